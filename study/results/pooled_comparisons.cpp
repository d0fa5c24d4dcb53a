// What the profile as published makes of pooled answers.
#include "study/results/pooled_answers.h"
#include "study/session/plan_history.h"

namespace study {
namespace {

/// Every comparison stands for itself.
void withoutCorrection(analysis::PairwiseComparisons& comparisons) {
  comparisons.alphaPerTest = comparisons.alpha;
  for (auto& row : comparisons.rows) {
    row.adjustedP = row.welch.p;
    row.adjustedInterval = row.interval;
    if (row.welch.p) row.isSignificant = *row.welch.p <= comparisons.alpha;
  }
}

}  // namespace

std::optional<analysis::Adjustment> adjustmentOf(protocols::CorrectionType correction) {
  using enum protocols::CorrectionType;
  switch (correction) {
    case None:
      return std::nullopt;
    case Bonferroni:
      return analysis::Adjustment::Bonferroni;
    case Holm:
      return analysis::Adjustment::Holm;
    case Hochberg:
      return analysis::Adjustment::Hochberg;
    case Hommel:
      return analysis::Adjustment::Hommel;
    case BenjaminiHochberg:
      return analysis::Adjustment::BenjaminiHochberg;
    case BenjaminiYekutieli:
      return analysis::Adjustment::BenjaminiYekutieli;
    case HolmSidak:
      return analysis::Adjustment::HolmSidak;
  }
  return std::nullopt;
}

analysis::PairwiseComparisons comparePooled(
    const protocols::Family& family, const std::vector<analysis::NamedCounts>& conditions) {
  std::vector<analysis::DeclaredPair> pairs;
  for (const auto& pair : family.comparisons) pairs.push_back({pair.first, pair.second});
  const bool isDeclared = family.test == protocols::TestType::Welch;
  const auto declared = adjustmentOf(family.correction);
  auto comparisons = analysis::comparePairwise(
      conditions,
      pairs,
      family.alpha,
      isDeclared && declared ? *declared : analysis::Adjustment::Bonferroni);
  if (isDeclared && !declared) withoutCorrection(comparisons);
  return comparisons;
}

Results pooledResults(Study& study, const PooledAnswers& pooled) {
  const auto& protocol = study.protocol().protocol;
  const auto history = planHistory(study);
  Results results{.runMode = pooled.runMode()};
  for (const auto& cohort : protocol.cohorts) results.flow.push_back({.cohort = cohort.id});
  for (const auto& row : study.sessions().all()) {
    for (auto& flow : results.flow) {
      const bool isIts = row.runMode == pooled.runMode() && row.cohort == flow.cohort;
      if (isIts) flow.add(statusOf(row.state));
    }
  }
  for (std::size_t i = 0; i < protocol.analysis.families.size(); ++i) {
    const auto& family = protocol.analysis.families[i];
    FamilyResult result{.family = family, .isDeclared = history.isDeclared(family.id)};
    for (std::size_t j = 0; j < protocol.cohorts.size(); ++j) {
      CohortResult part{.cohort = protocol.cohorts[j].id, .conditions = pooled.of(i, j)};
      part.comparisons = comparePooled(family, part.conditions);
      result.cohorts.push_back(std::move(part));
    }
    results.families.push_back(std::move(result));
  }
  return results;
}

}  // namespace study
