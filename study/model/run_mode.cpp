#include "study/model/run_mode.h"

#include <array>
#include <utility>

namespace study {
namespace {

constexpr std::array<std::pair<RunMode, std::string_view>, 3> kNames{{
    {RunMode::Live, "live"},
    {RunMode::Pilot, "pilot"},
    {RunMode::Simulated, "simulated"},
}};

}  // namespace

std::string_view nameOf(RunMode mode) noexcept {
  for (const auto& [value, name] : kNames) {
    if (value == mode) return name;
  }
  return {};
}

std::optional<RunMode> runModeNamed(std::string_view name) noexcept {
  for (const auto& [value, known] : kNames) {
    if (known == name) return value;
  }
  return std::nullopt;
}

}  // namespace study
