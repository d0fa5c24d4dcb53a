#include "study/export/statistics_table.h"

#include <map>

#include "base/joined.h"
#include "study/export/condition_codes.h"
#include "study/export/export_parts.h"
#include "study/export/statistics_row.h"
#include "study/results/pooled_results.h"
#include "study/results/rendered_force_curves.h"

namespace study {
namespace {

using Row = StatisticsRow;

/// The rows of one family.
class FamilyRows {
 public:
  FamilyRows(const FamilyResult& family, const std::map<std::string, std::string>& codes)
      : family_(family), codes_(codes) {}

  std::vector<Row> all() {
    for (const auto& cohort : family_.cohorts) {
      for (const auto& test : cohort.comparisons.rows) addPooled(cohort, test);
      for (const auto& comparison : cohort.within.rows) {
        for (const auto& test : comparison.tests) addWithin(cohort, test);
      }
      addOverall(cohort);
    }
    for (const auto& row : family_.between) addBetween(row);
    return std::move(rows_);
  }

 private:
  Row row(
      const std::string& cohort,
      std::string_view design,
      std::string_view unit,
      analysis::TestRow test) {
    auto row = familyRow(family_, cohort);
    row.design = design;
    row.unit = unit;
    row.test = std::move(test);
    return row;
  }

  static std::string flagsOf(const CohortResult& cohort) {
    return base::joined(cohort.flags, " ", &analysis::Flag::id);
  }

  std::string_view declaredCorrection() const {
    const auto adjustment = adjustmentOf(family_.family.correction);
    return adjustment ? nameOf(*adjustment) : "none";
  }

  Row& addPair(
      const CohortResult& cohort,
      std::string_view design,
      std::string_view unit,
      const analysis::TestRow& test) {
    auto& added = rows_.emplace_back(row(cohort.cohort, design, unit, test));
    added.group1 = codes_.at(test.group1);
    added.group2 = codes_.at(test.group2);
    added.isDeclared = family_.isConfirmatory(test.id);
    added.flags = flagsOf(cohort);
    return added;
  }

  void addPooled(const CohortResult& cohort, const analysis::TestRow& test) {
    auto& added = addPair(cohort, "unpaired", "answer", test);
    added.tests = cohort.comparisons.tests;
    added.adjustment = family_.isNamed("welch") ? declaredCorrection() : "bonferroni";
    added.alphaPerTest = cohort.comparisons.alphaPerTest;
  }

  void addWithin(const CohortResult& cohort, const analysis::TestRow& test) {
    const bool isModel = test.id == "mixed_model" || test.id == "ordinal_model";
    auto& added =
        addPair(cohort, isModel ? "mixed" : "paired", isModel ? "answer" : "participant", test);
    added.tests = cohort.within.tests;
    if (!test.isInFamily) return;
    added.adjustment = declaredCorrection();
    added.alphaPerTest = cohort.within.alphaPerTest;
  }

  void addOverall(const CohortResult& cohort) {
    const auto family = familyRow(family_, cohort.cohort);
    for (auto& added : overallRows(family, cohort, codes_)) rows_.push_back(std::move(added));
    for (auto& added : siteRows(family, cohort, codes_)) rows_.push_back(std::move(added));
  }

  void addBetween(const BetweenResult& result) {
    for (const auto& test : result.tests) {
      auto& added = rows_.emplace_back(row(result.cohort1, "unpaired", "participant", test));
      added.cohort2 = result.cohort2;
      added.group1 = codes_.at(result.condition);
      if (!test.effect.name.empty()) added.level = 0.95;
    }
  }

  const FamilyResult& family_;
  const std::map<std::string, std::string>& codes_;
  std::vector<Row> rows_;
};

/// The rows of one run mode.
std::vector<Row> rowsOf(
    Study& study,
    const Results& results,
    const std::map<std::string, std::string>& codes,
    bool isExact) {
  const auto mode = results.runMode;
  std::vector<Row> rows;
  const auto add = [&](std::vector<Row> more) {
    for (auto& row : more) rows.push_back(std::move(row));
  };
  for (const auto& family : results.families) {
    add(FamilyRows(family, codes).all());
  }
  add(instrumentRows(results.instruments, codes));
  add(itemRows(results.answers.items, study.protocol(), codes, isExact));
  add(renderedForceRows(renderedForceResult(study, mode), codes));
  for (auto& row : rows) row.runMode = mode;
  return rows;
}

}  // namespace

std::vector<Results> resultsFor(Study& study, const ExportOptions& options) {
  std::vector<Results> results;
  for (const auto mode : {RunMode::Live, RunMode::Pilot, RunMode::Simulated}) {
    if (options.runMode && *options.runMode != mode) continue;
    auto one = computeResults(study, mode);
    if (one.completed() > 0) results.push_back(std::move(one));
  }
  return results;
}

ExportedTable statisticsTable(
    Study& study, const ExportOptions& options, const std::vector<Results>& results) {
  std::vector<Row> rows;
  for (const auto& one : results) {
    const auto codes = conditionCodes(study, one.runMode, options.codes);
    for (auto& row : rowsOf(study, one, codes, options.isExact)) rows.push_back(std::move(row));
  }
  const Table<Row> table{
      .name = "statistics",
      .description = "One row per test, score or check; what is missing says why.",
      .columns = statisticsColumns(),
      .revealsCondition = true};
  return exportedTable(table, rows, readersOf(study, options));
}

}  // namespace study
