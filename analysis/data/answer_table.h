#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "analysis/data/answer_sample.h"

namespace analysis {

/// One answer to one statement about one method, reversed where needed so that a higher score is
/// better. Participant, method, round and statement are indices into the names of the AnswerTable.
struct ScoredAnswer {
  std::size_t participant = 0;
  std::size_t method = 0;
  std::size_t round = 0;
  std::size_t statement = 0;
  int position = 0;  ///< position of the method in the order of its round, from 1
  double score = 0.0;
};

/// The answers of all participants about all methods, on one scale.
struct AnswerTable {
  double lowest = 1.0;
  double highest = 5.0;
  /// Whether the answers are points: whole numbers on a scale of at most LikertCounts::kMostPoints.
  /// Otherwise no counts, ordinal model or test for two peaks are computed.
  bool isPointScale = true;
  std::vector<std::string> participants;
  std::vector<std::string> methods;
  std::vector<std::string> rounds;
  std::vector<std::string> statements;
  std::vector<ScoredAnswer> answers;

  /// The lowest point above the middle of the scale: 4 of 1 … 5.
  /// @pre isPointScale
  int lowestPointAboveMiddle() const;

  /// All answers about a method, of all participants.
  AnswerSample sampleOf(std::size_t method) const;

  /// A sample of @p scores, counted by point if isPointScale.
  AnswerSample sampleOf(std::span<const double> scores) const;

  /// Mean score by participant and method, [participant][method], each correctly rounded;
  /// std::nullopt without answers.
  std::vector<std::vector<std::optional<double>>> participantMeans() const;
};

/// The mean scores of those participants who answered about all requested methods, one row each.
struct CompleteCaseMeans {
  std::vector<std::size_t> participants;   ///< indices into the table's participants
  std::vector<std::vector<double>> means;  ///< [row][index into the requested methods]
  std::vector<std::size_t>
      excludedParticipants;  ///< participants who lack an answer about a requested method
  std::vector<double> of(std::size_t method) const;  ///< the means of one method
};

/// @param methods  indices into the methods of the table.
CompleteCaseMeans completeCaseMeans(
    const AnswerTable& table, const std::vector<std::size_t>& methods);

}  // namespace analysis
