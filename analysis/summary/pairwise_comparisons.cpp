#include "analysis/summary/pairwise_comparisons.h"

#include <algorithm>
#include <set>
#include <stdexcept>
#include <utility>

#include "analysis/data/nearest_name.h"
#include "analysis/registry/test_rows.h"

namespace analysis {
namespace {

void checkNames(std::span<const NamedCounts> groups) {
  std::set<std::string> seen;
  for (const auto& group : groups) {
    if (!seen.insert(group.name).second) {
      throw std::invalid_argument("two groups share the name '" + group.name + "'");
    }
  }
}

void checkFamily(std::span<const DeclaredPair> pairs) {
  std::set<std::pair<std::string, std::string>> seen;
  for (const auto& [first, second] : pairs) {
    if (first == second) {
      throw std::invalid_argument("group '" + first + "' cannot be compared with itself");
    }
    if (!seen.insert(std::minmax(first, second)).second) {
      const std::vector<std::string> both{first, second};
      throw std::invalid_argument(enumerated(both) + " are compared twice");
    }
  }
}

const LikertCounts& countsOf(const std::string& name, std::span<const NamedCounts> groups) {
  const auto group = std::ranges::find(groups, name, &NamedCounts::name);
  if (group == groups.end()) throw std::invalid_argument("there is no group '" + name + "'");
  return group->counts;
}

void judge(PairwiseComparisons& family) {
  std::vector<std::optional<double>> pValues;
  for (const auto& row : family.rows) pValues.push_back(row.welch.p);
  family.tests = definedCount(pValues);
  if (family.tests == 0) return;

  const double each = alphaPerTest(family.alpha, family.tests);
  const auto adjusted = adjust(pValues, family.adjustment);
  family.alphaPerTest = each;
  for (std::size_t i = 0; i < family.rows.size(); ++i) {
    auto& row = family.rows[i];
    row.adjustedP = adjusted[i];
    if (row.adjustedP) row.isSignificant = *row.adjustedP <= family.alpha;
    row.interval = confidenceInterval(row.welch, 1.0 - family.alpha);
    row.adjustedInterval = confidenceInterval(row.welch, 1.0 - each);
  }
}

}  // namespace

PairwiseComparisons comparePairwise(
    std::span<const NamedCounts> groups,
    std::span<const DeclaredPair> pairs,
    double alpha,
    Adjustment adjustment) {
  if (!(alpha > 0.0 && alpha < 1.0)) throw std::invalid_argument("alpha lies between 0 and 1");
  checkNames(groups);
  checkFamily(pairs);

  PairwiseComparisons family;
  family.alpha = alpha;
  family.adjustment = adjustment;
  for (const auto& [first, second] : pairs) {
    PairwiseComparison row;
    row.group1 = first;
    row.group2 = second;
    row.welch = welchTTest(countsOf(first, groups), countsOf(second, groups));
    family.rows.push_back(std::move(row));
  }
  judge(family);
  return family;
}

TestRow rowOf(const PairwiseComparison& comparison) {
  auto row = rowOf(comparison.welch, comparison.interval);
  row.id = "welch";
  row.group1 = comparison.group1;
  row.group2 = comparison.group2;
  row.adjustedInterval = comparison.adjustedInterval;
  row.isOfFamily = true;
  row.adjusted = comparison.adjustedP;
  row.isSignificant = comparison.isSignificant;
  return row;
}

}  // namespace analysis
