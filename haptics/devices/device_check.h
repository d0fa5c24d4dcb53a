#pragma once

#include <cstdint>
#include <string>

namespace haptics::devices {

enum class Finding : std::uint8_t { Pass, Warn, Fail };

const char* nameOf(Finding finding) noexcept;

/// One line of what a device was found to be.
struct CheckResult {
  Finding finding = Finding::Pass;
  std::string what;      ///< what was looked at: "telemetry rate"
  std::string measured;  ///< what was seen, with its unit
  std::string mend;      ///< what to do about it; empty where all is well
};

}  // namespace haptics::devices
