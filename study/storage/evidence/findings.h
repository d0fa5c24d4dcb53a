#pragma once

#include <string>
#include <vector>

namespace study::storage {

/// What a check found.
struct Findings {
  std::vector<std::string> problems = {};  ///< data that differ from what was written
  std::vector<std::string> remarks = {};   ///< notes for the reader that are no problems
};

}  // namespace study::storage
