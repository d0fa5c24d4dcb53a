#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "analysis/data/answer_sample.h"
#include "analysis/data/test_row.h"
#include "analysis/hypothesis_tests/adjustment.h"

namespace analysis {

/// The answers to one condition.
struct NamedSample {
  std::string name;
  AnswerSample answers;
};

/// A comparison as a protocol declares it. Its sign is first − second.
struct DeclaredPair {
  std::string first;
  std::string second;
};

/// The family of comparisons that a study declared, each by Welch's test, with p values adjusted
/// for their number.
struct PairwiseComparisons {
  double alpha = 0.05;
  Adjustment adjustment = Adjustment::Bonferroni;
  std::size_t tests = 0;  ///< m: the comparisons that have a p value
  /// alpha / m, the level of the adjusted intervals; std::nullopt for m = 0.
  std::optional<double> alphaPerTest;
  /// One row `welch` per pair, with the interval and the adjusted interval.
  std::vector<TestRow> rows;
};

/// Computes the declared comparisons, in their order.
///
/// The adjusted intervals are Bonferroni's for every adjustment of p, because the other methods
/// have no intervals that always agree with their p values.
///
/// @throws std::invalid_argument  if two groups share a name, a pair names a group that is not
///     there or the same one twice, a pair is declared twice (also the other way round), or alpha
///     is not between 0 and 1.
PairwiseComparisons comparePairwise(
    std::span<const NamedSample> groups,
    std::span<const DeclaredPair> pairs,
    double alpha = 0.05,
    Adjustment adjustment = Adjustment::Bonferroni);

}  // namespace analysis
