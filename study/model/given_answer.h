#pragma once

#include <string>

#include "questionnaires/model/answer.h"

namespace study {

/// An answer as it was given, with when and how it was given.
struct GivenAnswer {
  std::string item;
  questionnaires::Response response;
  int itemOrder = 0;        ///< position of the item on its page, from 1
  double firstTouch = 0.0;  ///< after the page was shown [s]
  /// From showing the page to the last change of the answer [s]; at least firstTouch.
  double responseTime = 0.0;
  int changes = 0;       ///< how often it was changed after the first touch
  std::string language;  ///< of the item's text

  bool operator==(const GivenAnswer&) const = default;
};

}  // namespace study
