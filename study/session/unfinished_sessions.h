#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "study/model/session_plan.h"
#include "study/session/study.h"
#include "study/storage/lease.h"

namespace study {

/// A session that is not over, as an operator finds it later, for example after the program or the
/// computer has stopped.
struct UnfinishedSession {
  SessionId id{};
  std::string participant;  ///< code
  RunMode runMode = RunMode::Live;
  SessionState state = SessionState::Enrolled;
  int step = 0;              ///< the index of its step, from 0
  int steps = 0;             ///< number of all steps
  Step at;                   ///< that step, without its condition
  protocols::Labels labels;  ///< of the alternatives
  std::string startedUtc;
  std::string lastStoredUtc;                     ///< of its last event
  std::optional<storage::Lease::Holder> holder;  ///< the program that has the session open, or had
                                                 ///< it open when it ended
  std::vector<std::string> choices;  ///< the possible actions, one sentence each; never empty

  bool isOpenElsewhere() const noexcept { return holder && holder->isAlive; }
  /// Whether the session is open on another computer. This computer cannot see whether the program
  /// there is still running.
  bool mayBeTakenOver() const noexcept { return isOpenElsewhere() && !holder->isOnThisComputer; }
};

/// What can be done about a session that is open elsewhere: with the computer, the number of the
/// process, and since when; and for one on another computer, with when it last stored something.
extern const std::string_view kOpenThere;
extern const std::string_view kTakeOver;

/// All unfinished sessions of a study, the oldest first. Does not change the study.
std::vector<UnfinishedSession> unfinishedSessions(Study& study);

/// How many of these are open elsewhere.
int openElsewhereIn(const std::vector<UnfinishedSession>& sessions) noexcept;

/// Why the session is unfinished: one sentence.
std::string whatHappened(const UnfinishedSession& session);

/// Participant, step and reason: "P003 (live) is in step 5 of 23 …".
std::string describe(const UnfinishedSession& session);

}  // namespace study
