#include "study/export/statistics_table.h"

#include <algorithm>
#include <array>
#include <map>

#include "study/export/export_parts.h"
#include "study/export/statistics_row.h"
#include "study/results/felt_curves.h"
#include "study/results/results.h"
#include "study/storage/records.h"

namespace study {
namespace {

using Row = StatisticsRow;

/// The rows of one family.
class FamilyRows {
 public:
  FamilyRows(
      const FamilyResult& family,
      const protocols::Protocol& protocol,
      std::string_view runMode,
      const std::map<std::string, std::string>& codes)
      : family_(family), protocol_(protocol), runMode_(runMode), codes_(codes) {}

  std::vector<Row> all() {
    for (const auto& cohort : family_.cohorts) {
      for (const auto& comparison : cohort.comparisons.rows) pooled(cohort, comparison);
      for (const auto& comparison : cohort.within.rows) {
        for (const auto& test : comparison.tests) within(cohort, test);
      }
      overall(cohort);
    }
    for (const auto& row : family_.between) between(row);
    return std::move(rows_);
  }

 private:
  Row head(
      const std::string& cohort,
      const char* design,
      const char* unit,
      const analysis::TestRow& test) {
    auto row = headOfRow(family_.family, protocol_, runMode_, cohort);
    row["design"] = std::string(design);
    row["unit"] = std::string(unit);
    addTest(row, test);
    return row;
  }

  static std::string flagsOf(const CohortResult& cohort) {
    std::string text;
    for (const auto& flag : cohort.flags) text += (text.empty() ? "" : " ") + std::string(flag.id);
    return text;
  }

  std::string declaredCorrection() const {
    constexpr std::array<const char*, 8> kNames{
        "none", "bonferroni", "holm", "hochberg", "hommel", "bh", "by", "holm-sidak"};
    return kNames[static_cast<std::size_t>(family_.family.correction)];
  }

  Row pairRow(
      const CohortResult& cohort,
      const char* design,
      const char* unit,
      const analysis::TestRow& test) {
    auto row = head(cohort.cohort, design, unit, test);
    row["group1"] = codes_.at(test.group1);
    row["group2"] = codes_.at(test.group2);
    row["declared"] = family_.isConfirmatory(test.id);
    if (const auto flags = flagsOf(cohort); !flags.empty()) row["flags"] = flags;
    return row;
  }

  void pooled(const CohortResult& cohort, const analysis::PairwiseComparison& comparison) {
    auto row = pairRow(cohort, "unpaired", "answer", rowOf(comparison));
    row["m"] = whole(cohort.comparisons.tests);
    row["p_adj_method"] =
        family_.isNamed("welch") ? declaredCorrection() : std::string("bonferroni");
    row["alpha_per_test"] = cellOf(cohort.comparisons.alphaPerTest);
    rows_.push_back(std::move(row));
  }

  void within(const CohortResult& cohort, const analysis::TestRow& test) {
    const bool isModel = test.id == "mixed_model" || test.id == "ordinal_model";
    auto row =
        pairRow(cohort, isModel ? "mixed" : "paired", isModel ? "answer" : "participant", test);
    row["m"] = whole(cohort.within.tests);
    if (test.isOfFamily) {
      row["p_adj_method"] = declaredCorrection();
      row["alpha_per_test"] = cellOf(cohort.within.alphaPerTest);
    }
    rows_.push_back(std::move(row));
  }

  void overall(const CohortResult& cohort) {
    for (auto& row : overallRows(cohort, codes_)) {
      row.merge(headOfRow(family_.family, protocol_, runMode_, cohort.cohort));
      rows_.push_back(std::move(row));
    }
  }

  void between(const BetweenResult& result) {
    for (const auto& test : result.tests) {
      auto row = head(result.cohort1, "unpaired", "participant", test);
      row["cohort2"] = result.cohort2;
      row["group1"] = codes_.at(result.condition);
      if (!test.effect.name.empty()) row["conf_level"] = 0.95;
      rows_.push_back(std::move(row));
    }
  }

  const FamilyResult& family_;
  const protocols::Protocol& protocol_;
  std::string_view runMode_;
  const std::map<std::string, std::string>& codes_;
  std::vector<Row> rows_;
};

/// The rows of one run mode.
std::vector<Row> rowsOf(
    Study& study, const Results& results, const std::map<std::string, std::string>& codes) {
  const auto mode = results.runMode;
  std::vector<Row> rows;
  const auto add = [&](std::vector<Row> more) {
    for (auto& row : more) rows.push_back(std::move(row));
  };
  for (const auto& family : results.families) {
    add(FamilyRows(family, study.protocol().protocol, nameOf(mode), codes).all());
  }
  add(instrumentRows(results.instruments, codes));
  add(feltRows(feltResult(study, mode), codes));
  for (auto& row : rows) row["run_mode"] = std::string(nameOf(mode));
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
  const auto codes = conditionCodes(study);
  std::vector<Row> rows;
  for (const auto& one : results) {
    for (auto& row : rowsOf(study, one, codes)) rows.push_back(std::move(row));
  }
  const Table<Row> table{
      .name = "statistics",
      .description = "One row per test, score or check; what is missing says why.",
      .columns = statisticsColumns(),
      .tellsTheCondition = true};
  return filled(table, rows, readersOf(study, options));
}

}  // namespace study
