#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <string_view>

namespace study {

/// The state of a session.
enum class SessionState {
  Enrolled,     ///< consent is not given yet, so no trial can begin; a place in the design is
                ///< reserved
  Consented,    ///< between trials: reading, answering, break
  InTrial,      ///< a trial is running
  Interrupted,  ///< a trial was broken off; the operator must repeat it, skip it, or end the
                ///< session
  Paused,
  Completed,
  Declined,         ///< the participant did not consent
  Withdrawn,        ///< the participant stopped
  Rejected,         ///< the operator stopped, with a reason
  AbortedHardware,  ///< a device could not be brought back
  Erased,           ///< answers were erased, in any state
};

/// What can happen to a session. kSessionTransitions lists the states before and after.
enum class SessionEvent {
  FinishedStep,
  GaveConsent,
  DeclinedConsent,
  BeganTrial,
  FinishedTrial,
  BrokeOffTrial,  ///< the device failed, stop was pressed, or the program ended
  RepeatedStep,
  SkippedStep,
  PausedSession,
  ResumedSession,
  FinishedSession,
  Withdrew,
  WasRejected,
  GaveUpOnDevice,
};

/// A row of the table of transitions.
struct SessionTransition {
  SessionState from;
  SessionEvent event;
  SessionState to;
};

/// All allowed transitions. Every other combination of state and event is refused.
inline constexpr auto kSessionTransitions = std::to_array<SessionTransition>({
    {SessionState::Enrolled, SessionEvent::FinishedStep, SessionState::Enrolled},
    {SessionState::Enrolled, SessionEvent::GaveConsent, SessionState::Consented},
    {SessionState::Enrolled, SessionEvent::DeclinedConsent, SessionState::Declined},

    {SessionState::Consented, SessionEvent::FinishedStep, SessionState::Consented},
    {SessionState::Consented, SessionEvent::GaveConsent, SessionState::Consented},
    {SessionState::Consented, SessionEvent::DeclinedConsent, SessionState::Declined},
    {SessionState::Consented, SessionEvent::SkippedStep, SessionState::Consented},
    {SessionState::Consented, SessionEvent::RepeatedStep, SessionState::Consented},
    {SessionState::Consented, SessionEvent::PausedSession, SessionState::Paused},
    {SessionState::Paused, SessionEvent::ResumedSession, SessionState::Consented},
    {SessionState::Consented, SessionEvent::FinishedSession, SessionState::Completed},

    {SessionState::Consented, SessionEvent::BeganTrial, SessionState::InTrial},
    {SessionState::Consented, SessionEvent::GaveUpOnDevice, SessionState::AbortedHardware},
    {SessionState::InTrial, SessionEvent::FinishedTrial, SessionState::Consented},
    {SessionState::InTrial, SessionEvent::BrokeOffTrial, SessionState::Interrupted},
    {SessionState::Interrupted, SessionEvent::RepeatedStep, SessionState::Consented},
    {SessionState::Interrupted, SessionEvent::SkippedStep, SessionState::Consented},
    {SessionState::Interrupted, SessionEvent::GaveUpOnDevice, SessionState::AbortedHardware},

    {SessionState::Enrolled, SessionEvent::Withdrew, SessionState::Withdrawn},
    {SessionState::Consented, SessionEvent::Withdrew, SessionState::Withdrawn},
    {SessionState::InTrial, SessionEvent::Withdrew, SessionState::Withdrawn},
    {SessionState::Interrupted, SessionEvent::Withdrew, SessionState::Withdrawn},
    {SessionState::Paused, SessionEvent::Withdrew, SessionState::Withdrawn},

    {SessionState::Enrolled, SessionEvent::WasRejected, SessionState::Rejected},
    {SessionState::Consented, SessionEvent::WasRejected, SessionState::Rejected},
    {SessionState::Interrupted, SessionEvent::WasRejected, SessionState::Rejected},
    {SessionState::Paused, SessionEvent::WasRejected, SessionState::Rejected},
});

/// The state after @p event; std::nullopt if it is not allowed.
constexpr std::optional<SessionState> next(SessionState from, SessionEvent event) {
  const auto* row = std::ranges::find_if(kSessionTransitions, [&](const SessionTransition& t) {
    return t.from == from && t.event == event;
  });
  return row == kSessionTransitions.end() ? std::nullopt : std::optional(row->to);
}

/// Whether the state is final.
constexpr bool isOver(SessionState state) {
  return std::ranges::none_of(
      kSessionTransitions, [&](const SessionTransition& t) { return t.from == state; });
}

static_assert(!next(SessionState::Enrolled, SessionEvent::BeganTrial), "no trial without consent");
static_assert(!next(SessionState::Enrolled, SessionEvent::SkippedStep), "consent is not skipped");
static_assert(!next(SessionState::InTrial, SessionEvent::FinishedStep), "a trial ends as a trial");
static_assert(isOver(SessionState::Completed) && isOver(SessionState::Declined));
static_assert(isOver(SessionState::Withdrawn) && isOver(SessionState::Rejected));
static_assert(isOver(SessionState::AbortedHardware) && isOver(SessionState::Erased));

std::string_view nameOf(SessionState state) noexcept;
std::optional<SessionState> sessionStateNamed(std::string_view name) noexcept;
std::string_view nameOf(SessionEvent event) noexcept;

/// The status of a session in tables: `in_progress`, `completed`, `declined`, `withdrawn`,
/// `rejected`, `aborted_hardware`, `erased`.
std::string_view statusOf(SessionState state) noexcept;

}  // namespace study
