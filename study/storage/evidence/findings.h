#pragma once

#include <string>
#include <vector>

namespace study::storage {

/// What a check found.
struct Findings {
  std::vector<std::string> problems = {};  ///< something is not as it was written
  std::vector<std::string> remarks = {};   ///< what a reader has to know; nothing is wrong
};

}  // namespace study::storage
