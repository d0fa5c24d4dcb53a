#pragma once

#include <optional>
#include <string_view>

namespace study {

/// The purpose of a session. It is stored with every row. Results count live sessions only, unless
/// another mode is chosen.
enum class RunMode {
  Live,
  Pilot,      ///< a test of the study; takes no place of a participant
  Simulated,  ///< without a participant
};

std::string_view nameOf(RunMode mode) noexcept;
std::optional<RunMode> runModeNamed(std::string_view name) noexcept;

}  // namespace study
