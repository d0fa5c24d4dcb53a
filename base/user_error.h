#pragma once

#include <stdexcept>

namespace base {

/// A request that is wrong or not possible at this moment, or a file of the user's that cannot be
/// used. what() says what is wrong, where, and what to do.
class UserError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace base
