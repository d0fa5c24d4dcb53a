#pragma once

#include <string>

#include "questionnaires/model/answer.h"

namespace study {

/// An answer of a participant, and when and how it was given.
struct GivenAnswer {
  std::string item;
  questionnaires::Response response;
  int itemOrder = 0;        ///< position of the item on its page, from 1
  double firstTouch = 0.0;  ///< time from showing the page to the first touch of the item [s]
  /// From showing the page to the last change of the answer [s]; at least firstTouch.
  double responseTime = 0.0;
  int changes = 0;       ///< how often the answer was changed after the first touch
  std::string language;  ///< of the item's text

  bool operator==(const GivenAnswer&) const = default;
};

}  // namespace study
