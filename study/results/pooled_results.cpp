#include "study/results/pooled_results.h"

#include <algorithm>
#include <cstdint>
#include <map>
#include <set>
#include <string>

#include "analysis/data/reason.h"
#include "study/results/answer_tables.h"
#include "study/results/protocol_versions.h"
#include "study/session/analysis_plan_history.h"
#include "study/storage/records.h"

namespace study {
namespace {

/// Undoes the adjustment: adjusted p values and intervals become the unadjusted ones.
void withoutCorrection(analysis::PairwiseComparisons& comparisons) {
  comparisons.alphaPerTest = comparisons.alpha;
  for (auto& row : comparisons.rows) {
    row.adjusted = row.p;
    row.adjustedInterval = row.interval;
    if (row.p) row.isSignificant = *row.p <= comparisons.alpha;
  }
}

/// Removes the tests: answers of a single participant are no evidence on differences between
/// people.
void withoutTests(analysis::PairwiseComparisons& comparisons) {
  comparisons.tests = 0;
  comparisons.alphaPerTest.reset();
  for (auto& row : comparisons.rows) {
    row = {
        .id = row.id,
        .group1 = row.group1,
        .group2 = row.group2,
        .n1 = row.n1,
        .n2 = row.n2,
        .moments = row.moments,
        .estimate = row.estimate,
        .isInFamily = true,
        .reason = analysis::reason("two_participants_needed")};
  }
}

/// The answer counts of one cohort for each condition that a family compares.
std::vector<analysis::NamedSample> countsIn(
    const FamilyLayout& layout,
    const ProtocolVersions& versions,
    const std::string& cohort,
    const std::vector<storage::PointCount>& points) {
  const auto& table = layout.table();
  const auto lowest = static_cast<int>(table.lowest);
  const auto width = static_cast<std::size_t>(table.highest - table.lowest + 1.0);
  std::vector<std::vector<std::uint64_t>> times(
      table.methods.size(), std::vector<std::uint64_t>(width));
  for (const auto& one : points) {
    if (one.cohort != cohort) continue;
    const auto cell = layout.cellOf(
        {one.instrument,
         one.phase,
         one.condition,
         one.item,
         versions.of(one.protocol).instrument(one.instrument)},
        static_cast<double>(one.point));
    if (!cell) continue;
    times[cell->method][static_cast<std::size_t>(cell->score - table.lowest)] += one.times;
  }
  std::vector<analysis::NamedSample> conditions;
  for (std::size_t i = 0; i < times.size(); ++i) {
    conditions.push_back({table.methods[i], analysis::LikertCounts(lowest, times[i])});
  }
  return conditions;
}

}  // namespace

std::vector<analysis::NamedSample> pooledCounts(const analysis::AnswerTable& table) {
  std::vector<analysis::NamedSample> conditions;
  for (std::size_t i = 0; i < table.methods.size(); ++i) {
    conditions.push_back({table.methods[i], table.sampleOf(i)});
  }
  return conditions;
}

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
    const protocols::Family& family,
    const std::vector<analysis::NamedSample>& conditions,
    std::size_t participants) {
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
  if (participants == 1) withoutTests(comparisons);
  return comparisons;
}

Results pooledResults(Study& study, RunMode mode) {
  const auto& loaded = study.protocol();
  const auto& protocol = loaded.protocol;
  const bool isPointScale = std::ranges::all_of(
      protocol.analysis.families,
      [&](const auto& family) { return FamilyLayout(loaded, family).table().isPointScale; });
  // numbers and scores have no countable points
  if (!isPointScale) return computeResults(study, mode);
  const auto history = analysisPlanHistory(study);
  const ProtocolVersions versions(study);
  Results results{.runMode = mode};
  for (const auto& cohort : protocol.cohorts) results.flow.push_back({.cohort = cohort.id});
  VersionsOfPeople everybody;
  std::map<std::string, std::set<std::string>> participants;  // of completed sessions, by cohort
  for (const auto& row : study.sessions().all()) {
    if (row.runMode != mode) continue;
    for (auto& flow : results.flow) {
      if (row.cohort == flow.cohort) flow.add(row.state);
    }
    if (row.state != SessionState::Completed) continue;
    participants[row.cohort].insert(row.participant);
    everybody[row.participant].insert(row.protocol);
  }
  results.changes = changesSince(
      versions, everybody, [&](const auto& change) { return concernsResults(protocol, change); });
  const auto points = storage::Records(study.database()).pointCounts(mode);
  for (const auto& family : protocol.analysis.families) {
    const FamilyLayout layout(loaded, family);
    FamilyResult result{.family = family, .isDeclared = history.isDeclared(family.id)};
    for (const auto& cohort : protocol.cohorts) {
      CohortResult part{
          .cohort = cohort.id, .conditions = countsIn(layout, versions, cohort.id, points)};
      part.comparisons = comparePooled(family, part.conditions, participants[cohort.id].size());
      result.cohorts.push_back(std::move(part));
    }
    results.families.push_back(std::move(result));
  }
  return results;
}

}  // namespace study
