#pragma once

#include <stdexcept>
#include <string>
#include <vector>

namespace analysis {

/// An analyst's table that cannot be used; what() says in words what is wrong, where and how to
/// mend it.
class Error : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;

  /// Everything that was found, one problem a line: the first ten, and how many more there are.
  explicit Error(const std::vector<std::string>& problems);
};

}  // namespace analysis
