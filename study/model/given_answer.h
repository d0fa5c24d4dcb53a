#pragma once

#include <string>

#include "questionnaires/model/answer.h"

namespace study {

/// An answer as it was given, with when and how it was given.
struct GivenAnswer {
  std::string item;
  questionnaires::Response response;
  int itemOrder = 0;          ///< position of the item on its page, from 1
  double firstTouch = 0.0;    ///< after the page was shown [s]
  double responseTime = 0.0;  ///< until the answer was last changed [s]; not before the first touch
  int changes = 0;            ///< how often it was changed after the first touch
  std::string language;       ///< of the item's text

  bool operator==(const GivenAnswer&) const = default;
};

}  // namespace study
