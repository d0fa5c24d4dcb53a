#pragma once

#include <optional>
#include <string>
#include <vector>

#include "study/session/study.h"
#include "study/storage/lease.h"

namespace study {

/// A session that is not over, as the next person at the desk finds it: after a break, or after the
/// program or the computer has died.
struct UnfinishedSession {
  SessionId id{};
  std::string participant;  ///< code
  RunMode runMode = RunMode::Live;
  SessionState state = SessionState::Enrolled;
  int step = 0;       ///< where it is, from 0
  int steps = 0;      ///< in all
  std::string place;  ///< "round-1: Alternative 2"; never a condition
  std::string startedUtc;
  std::optional<storage::Lease::Holder> holder;  ///< who has it open, or had when they ended
  std::vector<std::string> choices;  ///< what can be done with it now, a sentence each; never empty

  bool isOpenElsewhere() const noexcept { return holder && holder->isAlive; }
};

/// All of a study, the oldest first. Changes nothing.
std::vector<UnfinishedSession> unfinishedSessions(Study& study);

/// Who, where, and what happened to it: "P003 (live) is in step 5 of 23 …".
std::string describe(const UnfinishedSession& session);

}  // namespace study
