#include "study/model/session_state.h"

#include <utility>

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
});

constexpr auto kEvents = std::to_array<std::pair<SessionEvent, std::string_view>>({
    {SessionEvent::FinishedStep, "finished_step"},
    {SessionEvent::GaveConsent, "gave_consent"},
    {SessionEvent::DeclinedConsent, "declined_consent"},
    {SessionEvent::BeganTrial, "began_trial"},
    {SessionEvent::FinishedTrial, "finished_trial"},
    {SessionEvent::BrokeOffTrial, "broke_off_trial"},
    {SessionEvent::RepeatedStep, "repeated_step"},
    {SessionEvent::SkippedStep, "skipped_step"},
    {SessionEvent::PausedSession, "paused_session"},
    {SessionEvent::ResumedSession, "resumed_session"},
    {SessionEvent::FinishedSession, "finished_session"},
    {SessionEvent::Withdrew, "withdrew"},
    {SessionEvent::WasRejected, "was_rejected"},
    {SessionEvent::GaveUpOnDevice, "gave_up_on_device"},
});

template <typename Table, typename Value>
std::string_view nameIn(const Table& table, Value wanted) noexcept {
  for (const auto& [value, name] : table) {
    if (value == wanted) return name;
  }
  return {};
}

}  // namespace

std::string_view nameOf(SessionState state) noexcept {
  return nameIn(kStates, state);
}
std::string_view nameOf(SessionEvent event) noexcept {
  return nameIn(kEvents, event);
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
