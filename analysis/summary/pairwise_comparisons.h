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

/// The family of comparisons that a study declared, each by Welch's test, held to account for
/// their number.
struct PairwiseComparisons {
  double alpha = 0.05;
  Adjustment adjustment = Adjustment::Bonferroni;
  std::size_t tests = 0;               ///< m: the comparisons that have a p value
  std::optional<double> alphaPerTest;  ///< alpha / m, of the intervals; std::nullopt for m = 0
  std::vector<TestRow> rows;           ///< `welch`, with intervals at both levels
};

/// The declared comparisons, in their order.
///
/// The adjusted intervals are Bonferroni's with every adjustment: the other methods have none
/// that would always agree with them.
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
