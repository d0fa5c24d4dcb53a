#pragma once

#include <stdexcept>

namespace study {

/// A mistake in what a person asked for, or something that is not possible at this moment. what()
/// says to the person at the desk what is wrong, with what, and what to do.
class UserError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace study
