#pragma once

#include <stdexcept>

namespace haptics::recordings {

/// A recording that cannot be read, or holds no cut of the kind that was asked for; in words for
/// the person at the desk: what, to what, what to do.
class Error : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace haptics::recordings
