#include "study/export/statistics_row.h"

#include <algorithm>

#include "analysis/registry/test_rows.h"

namespace study {
namespace {

/// Ids of the phases whose answers count, separated by spaces.
std::string blocksOf(const protocols::Family& family, const protocols::Protocol& protocol) {
  std::string text;
  for (const auto& phase : protocol.phases) {
    const auto& named = family.blocks;
    const bool isNamed =
        named.empty() || std::find(named.begin(), named.end(), phase.id) != named.end();
    const auto& asked = phase.trials.questionnaires;
    const bool asks = std::any_of(asked.begin(), asked.end(), [&](const auto& questionnaire) {
      return questionnaire.instrument == family.instrument;
    });
    if (phase.type != protocols::PhaseType::Block || !isNamed || !asks) continue;
    text += (text.empty() ? "" : " ") + phase.id;
  }
  return text;
}

std::string allCodes(const CohortResult& cohort, const std::map<std::string, std::string>& codes) {
  std::string text;
  for (const auto& method : cohort.table.methods) {
    text += (text.empty() ? "" : " ") + codes.at(method);
  }
  return text;
}

StatisticsRow rowOf(const char* design, const analysis::TestRow& test) {
  StatisticsRow row{{"design", std::string(design)}, {"unit", std::string("participant")}};
  addTest(row, test);
  return row;
}

StatisticsRow rowOf(const char* design, const char* id, analysis::TestRow test) {
  test.id = id;
  return rowOf(design, test);
}

StatisticsRow orderRow(const CohortResult& cohort) {
  auto test = analysis::rowOf(cohort.position.slope, cohort.position.slopeInterval, {});
  test.effect = {};
  auto row = rowOf("paired", "order_slope", std::move(test));
  row["conf_level"] = 0.95;
  return row;
}

StatisticsRow alphaRow(const analysis::CronbachAlpha& alpha) {
  auto row = rowOf("paired", "cronbach_alpha", analysis::rowOf(alpha));
  row["conf_level"] = alpha.level;
  return row;
}

}  // namespace

StatisticsRow headOfRow(
    const protocols::Family& family,
    const protocols::Protocol& protocol,
    std::string_view runMode,
    const std::string& cohort) {
  return {
      {"run_mode", std::string(runMode)},
      {"cohort", cohort},
      {"family_id", family.id},
      {"instrument", family.instrument},
      {"blocks", blocksOf(family, protocol)},
      {"declared", false},
      {"alpha", family.alpha},
      {"conf_level", 1.0 - family.alpha}};
}

void addTest(StatisticsRow& row, const analysis::TestRow& test) {
  row["method"] = std::string(test.id);
  if (test.n1) row["n1"] = whole(*test.n1);
  if (test.n2) row["n2"] = whole(*test.n2);
  for (std::size_t i = 0; test.moments && i < test.moments->size(); ++i) {
    const auto& [mean, variance] = (*test.moments)[i];
    row["mean" + std::to_string(i + 1)] = cellOf(mean);
    if (variance) row["sd" + std::to_string(i + 1)] = std::sqrt(*variance);
  }
  row["estimate"] = cellOf(test.estimate.value);
  row["se"] = cellOf(test.standardError);
  addName(row, "statistic_name", std::string(test.statistic.name));
  row["statistic"] = finite(test.statistic.value);
  row["df"] = cellOf(test.df);
  row["df2"] = cellOf(test.df2);
  row["p"] = cellOf(test.p);
  row["log10_p"] = cellOf(test.log10P);
  row["p_adj"] = cellOf(test.adjusted);
  addInterval(row, "conf", test.interval);
  addInterval(row, "conf", test.adjustedInterval, "_adj");
  addName(row, "effect_name", std::string(test.effect.name));
  row["effect"] = finite(test.effect.value);
  if (test.effectInterval) {
    row["effect_low"] = finite(test.effectInterval->low);
    row["effect_high"] = finite(test.effectInterval->high);
  }
  for (const auto& number : test.more) row[std::string(number.name)] = cellOf(number.value);
  addReason(row, test.reason);
}

std::vector<StatisticsRow> overallRows(
    const CohortResult& cohort, const std::map<std::string, std::string>& codes) {
  std::vector<StatisticsRow> rows;
  for (const auto& test : cohort.within.overall) rows.push_back(rowOf("paired", test));
  rows.push_back(orderRow(cohort));
  rows.push_back(rowOf("unpaired", "brown_forsythe", analysis::rowOf(cohort.checks.spread)));
  for (auto& row : rows) row["groups"] = allCodes(cohort, codes);
  for (const auto& checks : cohort.checks.methods) {
    for (auto row :
         {alphaRow(checks.alpha),
          rowOf("paired", "omega_total", analysis::rowOf(checks.omega)),
          rowOf("unpaired", "shapiro_wilk", analysis::rowOf(checks.normality))}) {
      row["group1"] = codes.at(checks.method);
      rows.push_back(std::move(row));
    }
  }
  return rows;
}

}  // namespace study
