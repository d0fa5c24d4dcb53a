#pragma once

#include <string>
#include <vector>

namespace study::storage {

/// The result of a check.
struct Findings {
  std::vector<std::string> problems = {};  ///< damage or tampering
  std::vector<std::string> remarks = {};   ///< information for the reader that is no problem
};

}  // namespace study::storage
