#include "analysis/summary/pairwise_comparisons.h"

#include <algorithm>
#include <set>
#include <stdexcept>
#include <utility>

#include "analysis/data/csv_table.h"
#include "analysis/hypothesis_tests/t_tests.h"
#include "analysis/registry/test_rows.h"

namespace analysis {
namespace {

void checkNames(std::span<const NamedSample> groups) {
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

const Moments& momentsOf(const std::string& name, std::span<const NamedSample> groups) {
  const auto group = std::ranges::find(groups, name, &NamedSample::name);
  if (group == groups.end()) throw std::invalid_argument("there is no group '" + name + "'");
  return group->answers.moments();
}

TestRow rowOf(const DeclaredPair& pair, const WelchResult& result, double alpha) {
  auto row = rowOf(result, confidenceInterval(result, 1.0 - alpha));
  row.id = "welch";
  row.group1 = pair.first;
  row.group2 = pair.second;
  row.isInFamily = true;
  return row;
}

}  // namespace

PairwiseComparisons comparePairwise(
    std::span<const NamedSample> groups,
    std::span<const DeclaredPair> pairs,
    double alpha,
    Adjustment adjustment) {
  if (!(alpha > 0.0 && alpha < 1.0)) throw std::invalid_argument("alpha lies between 0 and 1");
  checkNames(groups);
  checkFamily(pairs);

  PairwiseComparisons family;
  family.alpha = alpha;
  family.adjustment = adjustment;
  std::vector<WelchResult> results;
  std::vector<std::optional<double>> pValues;
  for (const auto& pair : pairs) {
    results.push_back(welchTTest(momentsOf(pair.first, groups), momentsOf(pair.second, groups)));
    pValues.push_back(results.back().p);
    family.rows.push_back(rowOf(pair, results.back(), alpha));
  }
  family.tests = definedCount(pValues);
  if (family.tests == 0) return family;

  family.alphaPerTest = alphaPerTest(alpha, family.tests);
  const auto adjusted = adjust(pValues, adjustment);
  for (std::size_t i = 0; i < results.size(); ++i) {
    auto& row = family.rows[i];
    row.adjusted = adjusted[i];
    if (row.adjusted) row.isSignificant = *row.adjusted <= alpha;
    row.adjustedInterval = confidenceInterval(results[i], 1.0 - *family.alphaPerTest);
  }
  return family;
}

}  // namespace analysis
