#pragma once

#include <optional>
#include <string_view>

namespace study {

/// What a session is for. It stands with every row, and only live ones count unless asked
/// otherwise.
enum class RunMode {
  Live,
  Pilot,      ///< somebody tries the study out; takes no place from a participant
  Simulated,  ///< nobody took part
};

std::string_view nameOf(RunMode mode) noexcept;
std::optional<RunMode> runModeNamed(std::string_view name) noexcept;

}  // namespace study
