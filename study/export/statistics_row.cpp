#include "study/export/statistics_row.h"

#include <utility>

#include "analysis/registry/test_rows.h"
#include "base/joined.h"

namespace study {
namespace {

/// Separated by spaces.
std::string listed(const std::vector<std::string>& ids) {
  std::string text;
  for (const auto& id : ids) text += (text.empty() ? "" : " ") + id;
  return text;
}

std::string allCodes(const CohortResult& cohort, const std::map<std::string, std::string>& codes) {
  return base::joined(
      cohort.table.methods, " ", [&](const auto& method) { return codes.at(method); });
}

analysis::TestRow named(std::string_view id, analysis::TestRow test) {
  test.id = id;
  return test;
}

/// A row with number, mean and variance of the answers to one condition at one site.
StatisticsRow siteAnswersRow(
    StatisticsRow row,
    const std::string& site,
    const std::string& code,
    const analysis::AnswerSample& answers) {
  row.site = site;
  row.unit = "answer";
  row.group1 = code;
  row.level.reset();
  row.test.id = "site_answers";
  row.test.n1 = answers.total();
  row.test.moments = {{{answers.mean(), answers.variance()}, {}}};
  return row;
}

/// The estimate pooled over sites (the diamond of a forest plot), or the reason why there is none.
analysis::TestRow pooledSitesRow(const analysis::SiteComparison& comparison) {
  analysis::TestRow test{.id = "pooled_sites", .reason = comparison.reason};
  if (!comparison.pooled) return test;
  const auto& pooled = comparison.pooled->knappHartung;
  test.n1 = comparison.pooled->sites;
  test.estimate.value = pooled.estimate;
  test.standardError = pooled.standardError;
  test.interval = pooled.interval;
  test.statistic = {"t", pooled.statistic};
  test.df = pooled.df;
  test.p = pooled.p;
  test.effect = {"i2", pooled.iSquared};
  return test;
}

}  // namespace

StatisticsRow familyRow(const FamilyResult& result, const std::string& cohort) {
  const auto& family = result.family;
  const auto& table = result.cohorts.front().table;
  return {
      .cohort = cohort,
      .family = family.id,
      .instrument = family.instrument,
      .blocks = listed(table.rounds),
      .items = family.score.empty() ? listed(table.statements) : std::string(),
      .score = family.score,
      .unit = "participant",
      .alpha = family.alpha,
      .level = 1.0 - family.alpha};
}

std::vector<StatisticsRow> overallRows(
    const StatisticsRow& family,
    const CohortResult& cohort,
    const std::map<std::string, std::string>& codes) {
  std::vector<StatisticsRow> rows;
  const auto add = [&](std::string_view design, analysis::TestRow test) -> StatisticsRow& {
    auto& row = rows.emplace_back(family);
    row.design = design;
    row.test = std::move(test);
    return row;
  };
  for (const auto& test : cohort.within.overall) add("paired", test);
  const auto& position = cohort.position;
  auto slope = named("order_slope", analysis::rowOf(position.slope, position.slopeInterval, {}));
  slope.effect = {};
  add("paired", std::move(slope)).level = 0.95;
  add("unpaired", named("brown_forsythe", analysis::rowOf(cohort.checks.spread)));
  for (auto& row : rows) row.groups = allCodes(cohort, codes);
  for (const auto& test : cohort.within.probabilities) {
    auto& row = add("mixed", test);
    row.unit = "answer";
    row.group1 = codes.at(test.group1);
    row.acceptableFrom = test.additionalNumber("from");
  }
  for (const auto& checks : cohort.checks.methods) {
    const auto& code = codes.at(checks.method);
    auto& alpha = add("paired", named("cronbach_alpha", analysis::rowOf(checks.alpha)));
    alpha.group1 = code;
    alpha.level = checks.alpha.level;
    add("paired", named("omega_total", analysis::rowOf(checks.omega))).group1 = code;
    add("unpaired", named("shapiro_wilk", analysis::rowOf(checks.normality))).group1 = code;
  }
  return rows;
}

std::vector<StatisticsRow> siteRows(
    const StatisticsRow& family,
    const CohortResult& cohort,
    const std::map<std::string, std::string>& codes) {
  std::vector<StatisticsRow> rows;
  if (!cohort.sites) return rows;
  for (const auto& site : cohort.sites->answers) {
    for (std::size_t i = 0; i < site.methods.size(); ++i) {
      const auto& code = codes.at(cohort.table.methods[i]);
      rows.push_back(siteAnswersRow(family, site.site, code, site.methods[i]));
    }
  }
  for (const auto& comparison : cohort.sites->rows) {
    const auto add = [&](const std::string& site, analysis::TestRow test) {
      auto& row = rows.emplace_back(family);
      row.site = site;
      row.design = "paired";
      row.group1 = codes.at(comparison.group1);
      row.group2 = codes.at(comparison.group2);
      row.test = std::move(test);
    };
    for (const auto& site : comparison.sites) {
      auto test = named("site_difference", analysis::rowOf(site.test, site.interval, {}));
      test.effect = {};
      add(site.site, std::move(test));
    }
    add({}, pooledSitesRow(comparison));
  }
  return rows;
}

}  // namespace study
