#pragma once

#include <stdexcept>

namespace haptics::devices {

/// A device that cannot be used: which, why, and what to do about it, in words.
class DeviceError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace haptics::devices
