#pragma once

#include <stdexcept>

namespace study {

/// A request that is wrong, or that is not possible at this moment. what() says what is wrong,
/// where, and what to do.
class UserError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace study
