#include "study/export/statistics_row.h"

#include <algorithm>

namespace study {
namespace {

/// Phases whose answers count, separated by spaces.
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

StatisticsRow beginning(const char* design, const char* method) {
  return {
      {"design", std::string(design)},
      {"unit", std::string("participant")},
      {"method", std::string(method)}};
}

StatisticsRow friedmanRow(const CohortResult& cohort) {
  const auto& f = cohort.within.friedman;
  auto row = beginning("paired", "friedman");
  row["n1"] = whole(f.blocks);
  row["statistic_name"] = std::string("chi2");
  row["statistic"] = cellOf(f.chiSquared);
  if (f.chiSquared) row["df"] = static_cast<double>(f.treatments - 1);
  row["p"] = cellOf(f.p);
  row["log10_p"] = cellOf(f.log10P);
  row["p_permutation"] = cellOf(f.exactP);
  row["effect_name"] = std::string("kendall_w");
  row["effect"] = cellOf(f.kendallW);
  addReason(row, f.reason);
  return row;
}

StatisticsRow anovaRow(const CohortResult& cohort) {
  const auto& anova = cohort.within.anova;
  auto row = beginning("paired", "rm_anova");
  row["n1"] = whole(anova.participants);
  row["statistic_name"] = std::string("F");
  row["statistic"] = finite(anova.f);
  row["df"] = cellOf(anova.degreesOfFreedom1);
  row["df2"] = cellOf(anova.degreesOfFreedom2);
  row["p"] = cellOf(anova.p);
  row["log10_p"] = cellOf(anova.log10P);
  row["epsilon"] = cellOf(anova.greenhouseGeisser);
  row["p_epsilon"] = cellOf(anova.pGreenhouseGeisser);
  row["effect_name"] = std::string("partial_eta2");
  row["effect"] = cellOf(anova.partialEtaSquared);
  addReason(row, anova.reason);
  return row;
}

StatisticsRow orderRow(const CohortResult& cohort) {
  const auto& slope = cohort.position.slope;
  auto row = beginning("paired", "order_slope");
  row["conf_level"] = 0.95;
  row["n1"] = whole(slope.n);
  row["estimate"] = cellOf(slope.meanDifference);
  row["se"] = cellOf(slope.standardError);
  row["statistic_name"] = std::string("t");
  row["statistic"] = finite(slope.t);
  row["df"] = cellOf(slope.degreesOfFreedom);
  row["p"] = cellOf(slope.p);
  row["log10_p"] = cellOf(slope.log10P);
  addInterval(row, "conf", cohort.position.slopeInterval);
  addReason(row, slope.reason);
  return row;
}

StatisticsRow spreadRow(const CohortResult& cohort) {
  const auto& spread = cohort.checks.spread;
  auto row = beginning("unpaired", "brown_forsythe");
  row["statistic_name"] = std::string("F");
  row["statistic"] = finite(spread.f);
  row["df"] = cellOf(spread.degreesOfFreedom1);
  row["df2"] = cellOf(spread.degreesOfFreedom2);
  row["p"] = cellOf(spread.p);
  row["log10_p"] = cellOf(spread.log10P);
  addReason(row, spread.reason);
  return row;
}

StatisticsRow alphaRow(const analysis::MethodChecks& checks) {
  auto row = beginning("paired", "cronbach_alpha");
  row["conf_level"] = checks.alpha.level;
  row["n1"] = whole(checks.alpha.respondents);
  row["effect_name"] = std::string("cronbach_alpha");
  row["effect"] = cellOf(checks.alpha.value);
  addInterval(row, "effect", checks.alpha.interval);
  addReason(row, checks.alpha.reason);
  return row;
}

StatisticsRow omegaRow(const analysis::MethodChecks& checks) {
  auto row = beginning("paired", "omega_total");
  row["n1"] = whole(checks.omega.respondents);
  row["effect_name"] = std::string("omega_total");
  row["effect"] = cellOf(checks.omega.value);
  addReason(
      row, checks.omega.isImproper ? analysis::reason("improper_omega") : checks.omega.reason);
  return row;
}

StatisticsRow normalityRow(const analysis::MethodChecks& checks) {
  auto row = beginning("unpaired", "shapiro_wilk");
  row["n1"] = whole(checks.normality.n);
  row["statistic_name"] = std::string("W");
  row["statistic"] = cellOf(checks.normality.w);
  row["p"] = cellOf(checks.normality.p);
  addReason(row, checks.normality.reason);
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

std::vector<StatisticsRow> overallRows(
    const CohortResult& cohort, const std::map<std::string, std::string>& codes) {
  std::vector<StatisticsRow> rows{
      friedmanRow(cohort), anovaRow(cohort), orderRow(cohort), spreadRow(cohort)};
  for (auto& row : rows) row["groups"] = allCodes(cohort, codes);
  for (const auto& checks : cohort.checks.methods) {
    for (auto row : {alphaRow(checks), omegaRow(checks), normalityRow(checks)}) {
      row["group1"] = codes.at(checks.method);
      rows.push_back(std::move(row));
    }
  }
  return rows;
}

}  // namespace study
