#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "questionnaires/model/answer.h"

namespace questionnaires {

/// What a score comes to with one person's answers.
struct ScoreResult {
  std::optional<double> value;
  std::string reason;        ///< why there is no value, in words; empty where there is one
  std::size_t answered = 0;  ///< items of the score that were answered
  std::size_t replaced = 0;  ///< items that were not, and counted as Score::missingAs
};

/// What @p score comes to with @p answers: (aggregate of the keyed answers + offset) · factor.
///
///     mean   Σ w x / Σ w      over the items that were answered
///     sum    Σ w x            over all items
///     count  how many x are at least Score::countFrom, over all items
///
/// x is the answer, low + high - x where the key is -1; w is 1, or the item's weight, or how often
/// it was chosen in the pairs that the score takes its weights from. An unanswered item is missing,
/// unless the score says what it counts as. Nothing where too few items were answered: a mean, and
/// a score that replaces missing answers, needs as many as the score says; everything else needs
/// all, and weights from pairs need every pair. Points, sliders and numbers count; other kinds of
/// items do not, and neither does an answer that validationError() refuses. Where an item was
/// answered more than once, the last answer counts.
ScoreResult computeScore(
    const Instrument& instrument, const Score& score, const std::vector<Answer>& answers);

/// Where @p score can lie. A mean lies within the widest range of its items, for any
/// weights.
Range rangeOf(const Instrument& instrument, const Score& score);

/// The value alone.
std::optional<double> scored(
    const Instrument& instrument, const Score& score, const std::vector<Answer>& answers);

/// How often each item of @p score was chosen in the pairs of Score::weightsFrom, in the order of
/// Score::items: for n items whole numbers from 0 to n - 1 that sum to n (n - 1) / 2, fifteen for
/// the six of the NASA-TLX. std::nullopt if a pair has no answer, or there are no pairs.
std::optional<std::vector<double>> pairWeights(
    const Instrument& instrument, const Score& score, const std::vector<Answer>& answers);

/// A score before and after, and after - before.
struct ScoreChange {
  std::optional<double> before;
  std::optional<double> after;
  std::optional<double> change;
  std::string reason;  ///< why there is no change, in words; empty where there is one
};

/// How @p score changed from the answers @p before to the answers @p after.
ScoreChange scoreChange(
    const Instrument& instrument,
    const Score& score,
    const std::vector<Answer>& before,
    const std::vector<Answer>& after);

/// How many participants found what an item asks about acceptable.
struct Acceptability {
  std::string itemId;
  double acceptableFrom = 0.0;  ///< the threshold, on the item's own scale
  std::size_t acceptable = 0;   ///< participants whose keyed answer is at or above it
  std::size_t answered = 0;     ///< participants who answered the item
  std::optional<double> share;  ///< acceptable / answered, 0 … 1
  std::string reason;           ///< why there is no share; empty where there is one
};

/// For every item of @p instrument that has a threshold, in its order: the share of participants at
/// or above it. @p participants holds the answers of each; who left the item open is not counted.
/// An answer to an item with key -1 is turned round first.
std::vector<Acceptability> acceptabilityOf(
    const Instrument& instrument, const std::vector<std::vector<Answer>>& participants);

/// Whether one person's answers contradict each other, by the rule of their instrument.
struct Consistency {
  std::vector<std::string> contradictory;  ///< ids of the scores whose answers lie too far apart
  bool isSuspicious = false;               ///< there are as many of them as the rule says
  std::string warning;                     ///< in words; empty where nothing is suspicious
};

/// Looks at @p answers by the ConsistencyRule of @p instrument; std::nullopt if it has none.
///
/// Within each score of the rule the keyed answers should lie close together, since its items ask
/// about one thing. A range (largest - smallest) above ConsistencyRule::widestRange is a
/// contradiction. Suspicious answers are told and never dropped: that is for the researcher to
/// decide. For the UEQ: a range above 3 in at least three of six scales (UEQ handbook, data
/// analysis tool).
std::optional<Consistency> consistencyOf(
    const Instrument& instrument, const std::vector<Answer>& answers);

}  // namespace questionnaires
