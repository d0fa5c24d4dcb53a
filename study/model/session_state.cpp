#include "study/model/session_state.h"

#include <utility>

#include "study/model/event_kind.h"

namespace study {
namespace {

constexpr auto kStates = std::to_array<std::pair<SessionState, std::string_view>>({
    {SessionState::Enrolled, "enrolled"},
    {SessionState::Consented, "consented"},
    {SessionState::InTrial, "in_trial"},
    {SessionState::Interrupted, "interrupted"},
    {SessionState::Paused, "paused"},
    {SessionState::Completed, "completed"},
    {SessionState::Declined, "declined"},
    {SessionState::Withdrawn, "withdrawn"},
    {SessionState::Rejected, "rejected"},
    {SessionState::AbortedHardware, "aborted_hardware"},
    {SessionState::Erased, "erased"},
});

}  // namespace

std::string_view nameOf(SessionState state) noexcept {
  for (const auto& [value, name] : kStates) {
    if (value == state) return name;
  }
  return {};
}
std::string_view nameOf(SessionEvent event) noexcept {
  return nameOf(kindOf(event));
}

std::optional<SessionState> sessionStateNamed(std::string_view name) noexcept {
  for (const auto& [value, known] : kStates) {
    if (known == name) return value;
  }
  return std::nullopt;
}

std::string_view statusOf(SessionState state) noexcept {
  return isOver(state) ? nameOf(state) : "in_progress";
}

}  // namespace study
