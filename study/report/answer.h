#pragma once

#include <string>
#include <vector>

namespace study::report {

/// What tables say, in the order in which a reader needs it.
struct Answer {
  std::string finding;                 ///< the headline: two or three short sentences
  std::string more{};                  ///< where, how much, and what was not tested; may be empty
  std::vector<std::string> caveats{};  ///< what weakens it, and what it does not say
};

}  // namespace study::report
