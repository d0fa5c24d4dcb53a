#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "analysis/data/likert_counts.h"
#include "analysis/data/test_row.h"
#include "analysis/numerics/interval.h"
#include "analysis/tests/adjustment.h"
#include "analysis/tests/welch.h"

namespace analysis {

/// The answers to one condition.
struct NamedCounts {
  std::string name;
  LikertCounts counts;
};

/// A comparison as a protocol declares it. Its sign is first − second.
struct DeclaredPair {
  std::string first;
  std::string second;
};

/// One row of the table of results.
struct PairwiseComparison {
  std::string group1;
  std::string group2;
  WelchResult welch;
  std::optional<double> adjustedP;
  std::optional<bool> isSignificant;         ///< adjusted p ≤ alpha; nothing without p
  std::optional<Interval> interval;          ///< of the difference, at 1 − alpha
  std::optional<Interval> adjustedInterval;  ///< of the difference, at 1 − alpha per test
};

/// The result as a TestRow, the form that all tests share.
TestRow rowOf(const PairwiseComparison& comparison);

/// The family of comparisons that a study declared, each by Welch's test, held to account for
/// their number.
struct PairwiseComparisons {
  double alpha = 0.05;
  Adjustment adjustment = Adjustment::Bonferroni;
  std::size_t tests = 0;               ///< m: the comparisons that have a p value
  std::optional<double> alphaPerTest;  ///< alpha / m, of the intervals; std::nullopt for m = 0
  std::vector<PairwiseComparison> rows;
};

/// The declared comparisons, in their order.
///
/// The adjusted intervals are Bonferroni's, whatever the adjustment: the other methods have none
/// that would always agree with them.
///
/// @throws std::invalid_argument  if two groups share a name, a pair names a group that is not
///     there or the same one twice, a pair is declared twice (also the other way round), or alpha
///     is not between 0 and 1.
PairwiseComparisons comparePairwise(
    std::span<const NamedCounts> groups,
    std::span<const DeclaredPair> pairs,
    double alpha = 0.05,
    Adjustment adjustment = Adjustment::Bonferroni);

}  // namespace analysis
