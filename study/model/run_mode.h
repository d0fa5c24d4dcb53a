#pragma once

#include <optional>
#include <string_view>

namespace study {

/// The purpose of a session. It is stored with every session. Results count live sessions only,
/// unless another mode is chosen.
enum class RunMode {
  Live,
  Pilot,      ///< a test of the study, which takes no participant's place in the design
  Simulated,  ///< run by the program, without a participant
};

std::string_view nameOf(RunMode mode) noexcept;
std::optional<RunMode> runModeNamed(std::string_view name) noexcept;

}  // namespace study
