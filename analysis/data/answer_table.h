#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "analysis/data/answer_sample.h"

namespace analysis {

/// One answer to one statement about one method, reversed where needed so that more is better. The
/// numbers are indices into the names of its table.
struct ScoredAnswer {
  std::size_t participant = 0;
  std::size_t method = 0;
  std::size_t round = 0;
  std::size_t statement = 0;
  int position = 0;  ///< of the method among those of its round, from 1
  double score = 0.0;
};

/// Who answered what, on one scale.
struct AnswerTable {
  double lowest = 1.0;
  double highest = 5.0;
  /// The answers are points: whole numbers, at most LikertCounts::kMostPoints. Otherwise they have
  /// no counts, no ordinal model and no test for two peaks.
  bool isOfPoints = true;
  std::vector<std::string> participants;
  std::vector<std::string> methods;
  std::vector<std::string> rounds;
  std::vector<std::string> statements;
  std::vector<ScoredAnswer> answers;

  /// The lowest point above the middle of the scale: 4 of 1 … 5.
  /// @pre isOfPoints
  int aboveMiddle() const;

  /// All answers about a method, of all participants.
  AnswerSample sampleOf(std::size_t method) const;

  /// Answers on this scale.
  AnswerSample sampleOf(std::span<const double> scores) const;

  /// Mean score by participant and method, each exactly rounded; std::nullopt if nothing was
  /// answered.
  std::vector<std::vector<std::optional<double>>> participantMeans() const;
};

/// Participants who answered about all of some methods, one row each: their mean scores.
struct CompleteMeans {
  std::vector<std::size_t> participants;             ///< indices into the table's
  std::vector<std::vector<double>> means;            ///< [row][place in the methods asked for]
  std::vector<std::size_t> leftOut;                  ///< participants who lack one
  std::vector<double> of(std::size_t method) const;  ///< a column
};

/// @param methods  indices into those of the table.
CompleteMeans completeMeans(const AnswerTable& table, const std::vector<std::size_t>& methods);

}  // namespace analysis
