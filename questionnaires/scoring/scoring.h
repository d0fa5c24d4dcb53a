#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "questionnaires/model/answer.h"

namespace questionnaires {

/// The value of a score for one person's answers.
struct ScoreResult {
  std::optional<double> value;
  std::string reason;        ///< why there is no value, as a sentence; empty if there is a value
  std::size_t answered = 0;  ///< number of answered items of the score
};

/// The value of @p score for @p answers: (aggregate of the keyed answers + offset) · factor, with
/// the aggregate
///
///     mean   Σ w x / Σ w      over the items that were answered
///     sum    Σ w x            over all items
///     count  how many x are at least Score::countFrom, over all items
///
/// x is the answer, reversed to low + high - x if the key is -1; w is 1, the item's weight, or the
/// number of times that the item was chosen in the pairs of Score::weightsFrom. An unanswered item
/// is missing, unless Score::missingAs replaces its answer. There is no value if too few items were
/// answered: a mean, and a score that replaces missing answers, requires Score::leastAnswered;
/// every other score requires all items, and a score with weights from pairs requires all items and
/// every pair. Only valid answers (validationError()) that are points or numbers are used. If an
/// item was answered more than once, the last answer is used.
ScoreResult computeScore(
    const Instrument& instrument, const Score& score, const std::vector<Answer>& answers);

/// The range of possible values of @p score. For a mean, the widest range of its items, for any
/// weights.
Range rangeOf(const Instrument& instrument, const Score& score);

/// The value of @p score for @p answers, as in ScoreResult::value.
std::optional<double> scoreValue(
    const Instrument& instrument, const Score& score, const std::vector<Answer>& answers);

/// How often each item of @p score was chosen in the pairs of Score::weightsFrom, in the order of
/// Score::items: for n items, whole numbers from 0 to n - 1 that sum to n (n - 1) / 2 (15 for the
/// six items of the NASA-TLX). std::nullopt if a pair has no answer, or if the score has no pairs.
std::optional<std::vector<double>> pairWeights(
    const Instrument& instrument, const Score& score, const std::vector<Answer>& answers);

/// A score before and after, and the change after - before.
struct ScoreChange {
  std::optional<double> before;
  std::optional<double> after;
  std::optional<double> change;
  std::string reason;  ///< why there is no change, as a sentence; empty if there is a change
};

/// The change of @p score from the answers @p before to the answers @p after.
ScoreChange scoreChange(
    const Instrument& instrument,
    const Score& score,
    const std::vector<Answer>& before,
    const std::vector<Answer>& after);

/// How many participants gave an acceptable answer to an item.
struct Acceptability {
  std::string itemId;
  double acceptableFrom = 0.0;  ///< the threshold, in the unit of the item's scale
  /// Number of participants whose keyed answer is at or above the threshold.
  std::size_t acceptable = 0;
  std::size_t answered = 0;     ///< number of participants who answered the item
  std::optional<double> share;  ///< acceptable / answered, 0 … 1
  std::string reason;           ///< why there is no share; empty if there is a share
};

/// For every item of @p instrument with a threshold, in order: the share of participants whose
/// answer is at or above the threshold. Answers to items with key -1 are reversed first.
/// @param participants  the answers of each participant; those who did not answer an item are
///     ignored for it.
std::vector<Acceptability> acceptabilityOf(
    const Instrument& instrument, const std::vector<std::vector<Answer>>& participants);

/// Whether one person's answers contradict each other, by the ConsistencyRule of the instrument.
struct Consistency {
  std::vector<std::string> contradictoryScores;  ///< ids; their answers contradict each other
  bool isSuspicious = false;  ///< they are ConsistencyRule::suspiciousFrom or more
  std::string warning;        ///< a sentence; empty if the answers are not suspicious
};

/// Checks @p answers by the ConsistencyRule of @p instrument; std::nullopt if the instrument has
/// none.
///
/// The keyed answers to the items of a score should be similar, because these items measure the
/// same construct. A range (largest - smallest) above ConsistencyRule::widestRange is a
/// contradiction. Suspicious answers are reported but never excluded; the researcher decides. For
/// the UEQ: a range above 3 in at least three of six scales (UEQ handbook, data analysis tool).
std::optional<Consistency> consistencyOf(
    const Instrument& instrument, const std::vector<Answer>& answers);

}  // namespace questionnaires
