#include "study/model/session_state.h"

#include <set>

#include <gtest/gtest.h>

namespace study {
namespace session_state_test {

constexpr std::array kEvents{
    SessionEvent::FinishedStep,
    SessionEvent::GaveConsent,
    SessionEvent::DeclinedConsent,
    SessionEvent::BeganTrial,
    SessionEvent::FinishedTrial,
    SessionEvent::BrokeOffTrial,
    SessionEvent::RepeatedStep,
    SessionEvent::SkippedStep,
    SessionEvent::PausedSession,
    SessionEvent::ResumedSession,
    SessionEvent::FinishedSession,
    SessionEvent::Withdrew,
    SessionEvent::WasRejected,
    SessionEvent::GaveUpOnDevice};

constexpr std::array kStates{
    SessionState::Enrolled,
    SessionState::Consented,
    SessionState::InTrial,
    SessionState::Interrupted,
    SessionState::Paused,
    SessionState::Completed,
    SessionState::Declined,
    SessionState::Withdrawn,
    SessionState::Rejected,
    SessionState::AbortedHardware};

constexpr std::array kTerminal{
    SessionState::Completed,
    SessionState::Declined,
    SessionState::Withdrawn,
    SessionState::Rejected,
    SessionState::AbortedHardware};

/// All states that can be reached from @p start without the event @p forbidden.
std::set<SessionState> reachableFrom(
    SessionState start, std::optional<SessionEvent> forbidden = std::nullopt) {
  std::set<SessionState> seen{start};
  std::size_t before = 0;
  while (before != seen.size()) {
    before = seen.size();
    for (const auto& row : kSessionTransitions) {
      if (row.event != forbidden && seen.count(row.from) > 0) seen.insert(row.to);
    }
  }
  return seen;
}

TEST(SessionState, ReachesEveryStateFromTheFirst) {
  const auto reached = reachableFrom(SessionState::Enrolled);
  for (const auto state : kStates) EXPECT_EQ(reached.count(state), 1U) << nameOf(state);
}

TEST(SessionState, BeginsNoTrialBeforeConsent) {
  const auto reached = reachableFrom(SessionState::Enrolled, SessionEvent::GaveConsent);
  EXPECT_EQ(reached.count(SessionState::InTrial), 0U);
  for (const auto state : reached) EXPECT_FALSE(next(state, SessionEvent::BeganTrial));
}

TEST(SessionState, AllowsWithdrawalAtAnyTime) {
  for (const auto state : kStates) {
    if (isOver(state)) continue;
    EXPECT_EQ(next(state, SessionEvent::Withdrew), SessionState::Withdrawn) << nameOf(state);
    EXPECT_EQ(reachableFrom(state).count(SessionState::Withdrawn), 1U) << nameOf(state);
  }
}

TEST(SessionState, IsOverInTheFiveTerminalStatesAndInNoOther) {
  for (const auto state : kStates) {
    const bool isTerminal = std::find(kTerminal.begin(), kTerminal.end(), state) != kTerminal.end();
    EXPECT_EQ(isOver(state), isTerminal) << nameOf(state);
    if (!isTerminal) continue;
    for (const auto event : kEvents) EXPECT_FALSE(next(state, event)) << nameOf(event);
  }
}

TEST(SessionState, HasOneOutcomeForEveryStateAndEvent) {
  std::set<std::pair<SessionState, SessionEvent>> rows;
  for (const auto& row : kSessionTransitions) {
    EXPECT_TRUE(rows.insert({row.from, row.event}).second)
        << nameOf(row.from) << " " << nameOf(row.event);
  }
}

TEST(SessionState, LeavesATrialOnlyByItsEndOrAWithdrawal) {
  const std::set allowed{
      SessionEvent::FinishedTrial, SessionEvent::BrokeOffTrial, SessionEvent::Withdrew};
  for (const auto event : kEvents) {
    EXPECT_EQ(next(SessionState::InTrial, event).has_value(), allowed.count(event) > 0)
        << nameOf(event);
  }
}

TEST(SessionState, HasOneNameInEveryFile) {
  std::set<std::string_view> names;
  for (const auto state : kStates) {
    EXPECT_FALSE(nameOf(state).empty());
    EXPECT_EQ(sessionStateNamed(nameOf(state)), state);
    names.insert(nameOf(state));
  }
  EXPECT_EQ(names.size(), kStates.size());
  EXPECT_FALSE(sessionStateNamed("lost"));
  std::set<std::string_view> events;
  for (const auto event : kEvents) events.insert(nameOf(event));
  EXPECT_EQ(events.size(), kEvents.size());
  EXPECT_EQ(events.count(""), 0U);
}

TEST(SessionState, IsInProgressInTablesUntilItIsOver) {
  for (const auto state : kStates) {
    EXPECT_EQ(statusOf(state), isOver(state) ? nameOf(state) : "in_progress");
  }
  EXPECT_EQ(statusOf(SessionState::AbortedHardware), "aborted_hardware");
}

}  // namespace session_state_test
}  // namespace study
