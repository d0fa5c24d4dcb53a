#include "study/export/statistics_table.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "study/export/export_parts.h"
#include "study/export/statistics_row.h"
#include "study/results/felt_curves.h"
#include "study/results/results.h"
#include "study/storage/records.h"

namespace study {
namespace {

using protocols::TestType;
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
      for (const auto& row : cohort.comparisons.rows) welch(cohort, row);
      for (const auto& row : cohort.within.rows) within(cohort, row);
      overall(cohort);
    }
    for (const auto& row : family_.between) between(row);
    return std::move(rows_);
  }

 private:
  Row head(const std::string& cohort, const char* design, const char* unit, const char* method) {
    auto row = headOfRow(family_.family, protocol_, runMode_, cohort);
    row["design"] = std::string(design);
    row["unit"] = std::string(unit);
    row["method"] = std::string(method);
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
      const std::string& first,
      const std::string& second,
      const char* design,
      const char* unit,
      const char* method) {
    auto row = head(cohort.cohort, design, unit, method);
    row["group1"] = codes_.at(first);
    row["group2"] = codes_.at(second);
    if (const auto flags = flagsOf(cohort); !flags.empty()) row["flags"] = flags;
    return row;
  }

  void welch(const CohortResult& cohort, const analysis::PairwiseComparison& comparison) {
    const auto& w = comparison.welch;
    const bool isNamed = family_.family.test == TestType::Welch;
    auto row = pairRow(cohort, comparison.group1, comparison.group2, "unpaired", "answer", "welch");
    row["m"] = whole(cohort.comparisons.tests);
    row["declared"] = family_.isConfirmatory(TestType::Welch);
    row["n1"] = whole(w.n1);
    row["n2"] = whole(w.n2);
    row["mean1"] = cellOf(w.mean1);
    row["mean2"] = cellOf(w.mean2);
    if (w.variance1) row["sd1"] = std::sqrt(*w.variance1);
    if (w.variance2) row["sd2"] = std::sqrt(*w.variance2);
    row["estimate"] = cellOf(w.difference);
    row["se"] = cellOf(w.standardError);
    row["statistic_name"] = std::string("t");
    row["statistic"] = finite(w.t);
    row["df"] = cellOf(w.degreesOfFreedom);
    row["p"] = cellOf(w.p);
    row["log10_p"] = cellOf(w.log10P);
    row["p_adj_method"] = isNamed ? declaredCorrection() : std::string("bonferroni");
    row["p_adj"] = cellOf(comparison.adjustedP);
    row["alpha_per_test"] = cellOf(cohort.comparisons.alphaPerTest);
    addInterval(row, "conf", comparison.interval);
    addInterval(row, "conf", comparison.adjustedInterval, "_adj");
    addReason(row, w.reason);
    rows_.push_back(std::move(row));
  }

  Row withinRow(
      const CohortResult& cohort,
      const analysis::WithinComparison& comparison,
      const char* method,
      const analysis::AdjustedP& p) {
    auto row =
        pairRow(cohort, comparison.group1, comparison.group2, "paired", "participant", method);
    row["m"] = whole(cohort.within.tests);
    row["n1"] = whole(comparison.differences.size());
    row["p"] = cellOf(p.p);
    row["p_adj_method"] = declaredCorrection();
    row["p_adj"] = cellOf(p.adjusted);
    row["alpha_per_test"] = cellOf(cohort.within.alphaPerTest);
    return row;
  }

  void within(const CohortResult& cohort, const analysis::WithinComparison& comparison) {
    pairedT(cohort, comparison);
    auto flip = withinRow(cohort, comparison, "sign_flip", comparison.signFlipP);
    flip["declared"] = family_.isConfirmatory(TestType::SignFlip);
    addReason(flip, comparison.signFlip.reason);
    rows_.push_back(std::move(flip));

    auto rank = withinRow(cohort, comparison, "signed_rank", comparison.signedRankP);
    rank["declared"] = family_.isConfirmatory(TestType::SignedRank);
    rank["statistic_name"] = std::string("V");
    rank["statistic"] = cellOf(comparison.signedRank.v);
    rank["estimate"] = cellOf(comparison.location.estimate);
    rank["effect_name"] = std::string("rank_biserial");
    rank["effect"] = cellOf(comparison.signedRank.rankBiserial);
    addReason(rank, comparison.signedRank.reason);
    rows_.push_back(std::move(rank));
    bayesFactor(cohort, comparison);
    if (comparison.equivalence) equivalence(cohort, comparison);
    mixedModel(cohort, comparison);
    ordinalModel(cohort, comparison);
  }

  void pairedT(const CohortResult& cohort, const analysis::WithinComparison& comparison) {
    const auto& t = comparison.paired;
    auto row = withinRow(cohort, comparison, "paired_t", comparison.pairedP);
    row["declared"] = family_.isConfirmatory(TestType::PairedT);
    row["estimate"] = cellOf(t.meanDifference);
    row["se"] = cellOf(t.standardError);
    row["statistic_name"] = std::string("t");
    row["statistic"] = finite(t.t);
    row["df"] = cellOf(t.degreesOfFreedom);
    row["log10_p"] = cellOf(t.log10P);
    addInterval(row, "conf", comparison.interval);
    addInterval(row, "conf", comparison.adjustedInterval, "_adj");
    row["effect_name"] = std::string("g_z");
    row["effect"] = cellOf(comparison.effects.hedgesGz.value);
    addInterval(row, "effect", comparison.effects.hedgesGz.interval);
    addReason(row, t.reason);
    rows_.push_back(std::move(row));
  }

  void bayesFactor(const CohortResult& cohort, const analysis::WithinComparison& comparison) {
    auto row = pairRow(
        cohort, comparison.group1, comparison.group2, "paired", "participant", "bayes_factor");
    row["m"] = whole(cohort.within.tests);
    row["n1"] = whole(comparison.differences.size());
    row["effect_name"] = std::string("bf10");
    row["effect"] = finite(comparison.bayes.bf10);
    addReason(row, comparison.bayes.reason);
    rows_.push_back(std::move(row));
  }

  void equivalence(const CohortResult& cohort, const analysis::WithinComparison& comparison) {
    const auto& tost = *comparison.equivalence;
    auto row =
        pairRow(cohort, comparison.group1, comparison.group2, "paired", "participant", "tost");
    row["m"] = whole(cohort.within.tests);
    row["n1"] = whole(comparison.differences.size());
    row["estimate"] = cellOf(comparison.paired.meanDifference);
    row["se"] = cellOf(comparison.paired.standardError);
    row["df"] = cellOf(comparison.paired.degreesOfFreedom);
    row["p"] = cellOf(tost.p);
    row["log10_p"] = cellOf(tost.log10P);
    row["equivalence_bound"] = tost.bounds.upper;
    addReason(row, tost.reason);
    rows_.push_back(std::move(row));
  }

  void mixedModel(const CohortResult& cohort, const analysis::WithinComparison& comparison) {
    auto row = withinRow(cohort, comparison, "mixed_model", comparison.mixedP);
    row["design"] = std::string("mixed");
    row["unit"] = std::string("answer");
    row["n1"] = whole(cohort.table.answers.size());
    if (comparison.mixed.p) {
      row["estimate"] = comparison.mixed.estimate;
      row["se"] = comparison.mixed.standardError;
      row["statistic_name"] = std::string("t");
      row["statistic"] = finite(comparison.mixed.t);
      row["df"] = cellOf(comparison.mixed.degreesOfFreedom);
      row["log10_p"] = cellOf(comparison.mixed.log10P);
    }
    addReason(row, cohort.within.mixed.fit ? comparison.mixed.reason : cohort.within.mixed.reason);
    rows_.push_back(std::move(row));
  }

  void ordinalModel(const CohortResult& cohort, const analysis::WithinComparison& comparison) {
    auto row = withinRow(cohort, comparison, "ordinal_model", comparison.ordinalP);
    row["design"] = std::string("mixed");
    row["unit"] = std::string("answer");
    row["n1"] = whole(cohort.table.answers.size());
    if (const auto& ordinal = comparison.ordinal) {
      row["estimate"] = ordinal->estimate;
      row["se"] = ordinal->standardError;
      row["statistic_name"] = std::string("z");
      row["statistic"] = ordinal->z;
      row["log10_p"] = ordinal->log10P;
      row["effect_name"] = std::string("odds_ratio");
      row["effect"] = finite(ordinal->oddsRatio);
      const auto limits = oddsRatioInterval(*ordinal, 1.0 - family_.family.alpha);
      row["effect_low"] = finite(limits.low);
      row["effect_high"] = finite(limits.high);
    }
    addReason(row, comparison.ordinalReason);
    rows_.push_back(std::move(row));
  }

  void overall(const CohortResult& cohort) {
    for (auto& row : overallRows(cohort, codes_)) {
      row.merge(headOfRow(family_.family, protocol_, runMode_, cohort.cohort));
      rows_.push_back(std::move(row));
    }
  }

  template <typename Test>
  Row betweenRow(const BetweenResult& result, const char* method, const Test& test) {
    auto row = head(result.cohort1, "unpaired", "participant", method);
    row["cohort2"] = result.cohort2;
    row["group1"] = codes_.at(result.condition);
    row["n1"] = whole(test.n1);
    row["n2"] = whole(test.n2);
    row["p"] = cellOf(test.p);
    addReason(row, test.reason);
    return row;
  }

  void between(const BetweenResult& result) {
    auto row = betweenRow(result, "mann_whitney", result.mannWhitney);
    row["statistic_name"] = std::string("U");
    row["statistic"] = cellOf(result.mannWhitney.u);
    row["conf_level"] = 0.95;
    row["effect_name"] = std::string("cliff_delta");
    row["effect"] = cellOf(result.cliff.delta);
    addInterval(row, "effect", result.cliff.interval);
    rows_.push_back(std::move(row));

    const auto& test = result.brunnerMunzel;
    row = betweenRow(result, "brunner_munzel", test);
    row["statistic_name"] = std::string("W");
    row["statistic"] = finite(test.w);
    row["df"] = cellOf(test.degreesOfFreedom);
    row["log10_p"] = cellOf(test.log10P);
    rows_.push_back(std::move(row));
  }

  const FamilyResult& family_;
  const protocols::Protocol& protocol_;
  std::string_view runMode_;
  const std::map<std::string, std::string>& codes_;
  std::vector<Row> rows_;
};

/// One mode of a study.
std::vector<Row> rowsOf(
    Study& study, RunMode mode, const std::map<std::string, std::string>& codes) {
  const auto results = computeResults(study, mode);
  std::vector<Row> rows;
  if (results.completed() == 0) return rows;
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

ExportedTable statisticsTable(Study& study, const ExportOptions& options) {
  const auto codes = conditionCodes(study);
  std::vector<RunMode> modes{RunMode::Live, RunMode::Pilot, RunMode::Simulated};
  if (options.runMode) modes = {*options.runMode};
  std::vector<Row> rows;
  for (const auto mode : modes) {
    for (auto& row : rowsOf(study, mode, codes)) rows.push_back(std::move(row));
  }
  const Table<Row> table{
      .name = "statistics",
      .description = "One row per test, score or check; what is missing says why.",
      .columns = statisticsColumns(),
      .tellsTheCondition = true};
  return filled(table, rows, readersOf(study, options));
}

}  // namespace study
