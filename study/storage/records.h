#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "study/model/given_answer.h"
#include "study/model/ids.h"
#include "study/model/run_mode.h"
#include "study/model/session_plan.h"
#include "study/model/session_state.h"
#include "study/model/trial_record.h"
#include "study/storage/database.h"
#include "study/storage/session_repository.h"

namespace study::storage {

/// A session, and by what it was run.
struct SessionRecord : SessionRow {
  std::string protocolHash;
  std::string appVersion;

  bool isCompleted() const noexcept { return state == SessionState::Completed; }
};

/// A visit to a step in which questions were asked or a condition was rendered.
struct StepRecord {
  VisitKey visit;
  StepKind kind = StepKind::Reading;
  std::string phase;
  std::string instrument;
  int position = 0;
  int label = 0;
  std::string condition;  ///< empty if the step has none, or if conditions are left out
  VisitStatus visitStatus = VisitStatus::Open;

  /// False also for visits that were skipped, broken off or repeated.
  bool isFinished() const noexcept { return visitStatus == VisitStatus::Finished; }

  /// Whether it is an optional trial before a preference. Such a trial has no position in the
  /// order, and no statistic uses it.
  bool isOptionalRepetition() const { return kind == StepKind::Trial && position == 0; }
};

/// An answer with its step.
struct AnswerRecord {
  StepRecord step;
  GivenAnswer answer;
  std::string savedUtc;
};

/// How often a point of an item's scale, or a whole number, was the answer in one cohort, about one
/// condition, in one phase, with one version of the protocol.
struct PointCount {
  ProtocolId protocol{};  ///< version of the sessions
  std::string cohort;
  std::string phase;
  std::string instrument;
  std::string condition;  ///< empty if the step has no condition
  std::string item;
  std::int64_t point = 0;
  std::uint64_t times = 0;
};

/// The landmarks of a cut: travel in the device's travel unit, force in N. std::nullopt for a
/// landmark that was not reached.
struct CutRecord {
  VisitKey visit;
  int number = 1;
  std::optional<double> interceptionTravel, interceptionForce;
  std::optional<double> yieldTravel, yieldForce;
  std::optional<double> bottomOutTravel, bottomOutForce;
  std::optional<double> openingTravel, openingForce;
  double peakForce = 0.0;
};

/// A trial with its step; units and meanings as in TrialRecord.
struct StoredTrial {
  StepRecord step;
  std::string device, travelUnit;
  TrialEnding ending = TrialEnding::Finished;
  Verdict verdict = Verdict::Pass;
  std::vector<base::Message> reasons;  ///< why the verdict is not PASS
  double duration = 0.0;
  std::int64_t ticks = 0;
  double nominalRate = 0.0;
  std::optional<double> achievedRate, latenessMedian, latenessP99, latenessLargest;
  std::optional<std::int64_t> lateTicks;
  std::int64_t lostSamples = 0, invalidTicks = 0;
  double saturated = 0.0, slewed = 0.0, undefined = 0.0, contact = 0.0, largestForce = 0.0;
  std::int64_t cuts = 0, traceSamples = 0;
};

/// Reads the recorded data of a study for analyses, the oldest first.
class Records {
 public:
  /// Whether records contain conditions. Reading sealed conditions needs the study's key.
  enum class Conditions { Shown, LeftOut };

  /// All functions throw StorageError if the key is needed but not available; what() says what to
  /// do.
  explicit Records(Database& database, Conditions conditions = Conditions::Shown)
      : database_(database), conditions_(conditions) {}

  std::vector<SessionRecord> sessions() const;
  /// @param session  only its answers
  std::vector<AnswerRecord> answers(std::optional<SessionId> session = std::nullopt) const;

  /// How often each point was chosen in the questionnaires of completed sessions, in visits that
  /// were finished and not repeated. Equals counting the result of answers(), but does not keep the
  /// answers: a million take 0.7 s (docs/decisions/0024). @throws StorageError
  std::vector<PointCount> pointCounts(RunMode mode) const;

  std::vector<StoredTrial> trials() const;
  std::vector<CutRecord> cuts() const;

  /// The number of trials that were never finished, in each block of a session that has any. In a
  /// completed session these were skipped, so that not every alternative was felt.
  std::map<std::pair<SessionId, std::string>, int> unfinishedTrials() const;

  /// A labelled alternative ("Alternative 2") of a block in a session.
  struct Alternative {
    SessionId session{};
    std::string block;
    int label = 0;
    auto operator<=>(const Alternative&) const = default;
  };
  using Allocation = std::map<Alternative, std::string>;
  /// The condition of every alternative in every session.
  Allocation allocation() const;

 private:
  Database& database_;
  Conditions conditions_;
};

/// The condition of an alternative of a block, which an answer names by its label ("2"); nullptr if
/// the session did not have it.
const std::string* conditionOf(
    const Records::Allocation& allocation,
    SessionId session,
    const std::string& block,
    const std::string& label);

/// The condition of the alternative of @p block that an answer chooses; nullptr if it chooses none.
/// @param item  of the answer; nullptr if it is not known
const std::string* chosenCondition(
    const Records::Allocation& allocation,
    const AnswerRecord& answer,
    const questionnaires::Item* item,
    const std::string& block);

}  // namespace study::storage
