#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "analysis/summary/pairwise_comparisons.h"
#include "study/model/run_mode.h"
#include "study/results/counted_sessions.h"
#include "study/results/results.h"
#include "study/session/study.h"
#include "study/storage/coded_answers.h"

namespace study {

/// How often each point was chosen, by family, cohort and condition, all answers pooled: what the
/// profile as published compares (docs/statistics.md). Keyed so that more is better; only completed
/// sessions count, and of those only visits that were finished and not repeated.
///
/// Everything is counted once, from an index of whole numbers; of a large study two threads count
/// half the sessions each. Afterwards the audit trail says
/// which sessions anything has happened to: refresh() takes back what they had added and counts
/// those anew, and no other.
class PooledAnswers {
 public:
  /// From so many sessions on a second thread, with a connection of its own, is worth its
  /// beginning.
  static constexpr std::int64_t kWorthAThread = 5000;

  /// The study outlives it. @throws storage::StorageError
  PooledAnswers(Study& study, RunMode mode, std::int64_t worthAThread = kWorthAThread);
  PooledAnswers(const PooledAnswers&) = delete;
  PooledAnswers& operator=(const PooledAnswers&) = delete;

  RunMode runMode() const noexcept { return mode_; }

  /// Counts what has happened since, whoever wrote it; whether anything has.
  /// @throws storage::StorageError
  bool refresh();

  /// The conditions that a family compares, in the protocol's order, as a cohort answered about
  /// them. @param family, cohort  places in the protocol
  std::vector<analysis::NamedCounts> of(std::size_t family, std::size_t cohort) const;

 private:
  using Place = CountedSessions::Place;

  /// The counts of a family in one cohort: condition by condition, point by point.
  struct FamilyCounts {
    std::vector<std::string> conditions;
    int lowest = 1;
    int highest = 5;
    std::size_t first = 0;  ///< place of the first among those of a cohort

    std::size_t points() const noexcept { return static_cast<std::size_t>(highest - lowest + 1); }
  };

  /// That a question belongs to a family: score = offset + key · point.
  struct Use {
    std::int64_t offset = 0;
    std::int64_t key = 1;
    std::int64_t lowest = 1;
    std::int64_t highest = 5;
    std::size_t first = 0;  ///< place of its condition among those of a cohort
  };

  /// What some sessions have added.
  struct Part {
    std::vector<std::uint64_t> counts;  ///< cohort by cohort
    CountedSessions sessions;
  };

  void layOut();
  void learnQuestions();
  std::vector<Use> usesOf(const storage::Question& question) const;
  void countAll();
  Part counted(
      storage::Database& database,
      const storage::SessionRange& range,
      const std::vector<SessionId>& withMore) const;
  void countAnew(SessionId session);
  Part& partOf(SessionId session) noexcept { return parts_[session < secondFrom_ ? 0 : 1]; }
  static void keep(SessionId session, const std::vector<Place>& places, Part& part);
  std::optional<std::size_t> cohortNamed(const std::string& cohort) const;
  void addPlaces(
      const storage::CodedAnswer& answer, std::size_t cohort, std::vector<Place>& to) const;

  Study& study_;
  RunMode mode_;
  std::int64_t worthAThread_;
  const protocols::LoadedProtocol* loaded_ = nullptr;
  std::int64_t lastEvent_ = 0;
  std::vector<FamilyCounts> families_;
  std::size_t placesOfACohort_ = 0;
  std::vector<std::vector<Use>> uses_;  ///< by number of the question
  std::array<Part, 2> parts_;           ///< the second of a large study's later sessions
  SessionId secondFrom_{};              ///< the first session that belongs there
};

/// The comparisons that a family declares, by Welch's test, of answers that were pooled; corrected
/// as declared where Welch's test is the declared one, and after Bonferroni otherwise.
analysis::PairwiseComparisons comparePooled(
    const protocols::Family& family, const std::vector<analysis::NamedCounts>& conditions);

/// What the profile as published says of pooled answers, and nothing that asks who gave them: no
/// flags, no votes, no tests within people. @throws storage::StorageError
Results pooledResults(Study& study, const PooledAnswers& pooled);

/// What a family's correction is called where numbers are made; nothing for none.
std::optional<analysis::Adjustment> adjustmentOf(protocols::CorrectionType correction);

}  // namespace study
