#include <nlohmann/json.hpp>

#include "study/app/json_file.h"
#include "study/app/statistics/test_rows_json.h"
#include "study/export/statistics_row.h"
#include "study/report/references.h"
#include "study/results/apa_text.h"
#include "study/results/rendered_force_curves.h"
#include "study/results/vote_tables.h"

namespace study::app {
namespace {

ResultJson textOrNull(const std::string& text) {
  return text.empty() ? ResultJson(nullptr) : ResultJson(text);
}

ResultJson checksAsJson(const CohortResult& cohort) {
  const auto& position = cohort.position;
  ResultJson json;
  json["order"] = {
      {"slope", nullable(position.slope.meanDifference)},
      {"conf", limits(position.slopeInterval)},
      {"t", nullable(position.slope.t)},
      {"df", nullable(position.slope.degreesOfFreedom)},
      {"p", nullable(position.slope.p)},
      {"reason", reasonOf(position.slope.reason)},
      {"positions", ResultJson::array()}};
  for (const auto& at : position.positions) {
    json["order"]["positions"].push_back(
        {{"position", at.position},
         {"n", at.participants},
         {"mean", at.mean},
         {"conf", limits(at.interval)}});
  }
  const auto& spread = cohort.checks.spread;
  json["brown_forsythe"] = {
      {"f", nullable(spread.f)},
      {"df1", nullable(spread.degreesOfFreedom1)},
      {"df2", nullable(spread.degreesOfFreedom2)},
      {"p", nullable(spread.p)},
      {"reason", reasonOf(spread.reason)}};
  json["scale"] = ResultJson::array();
  for (const auto& method : cohort.checks.methods) {
    json["scale"].push_back(
        {{"condition", method.method},
         {"items", method.alpha.items},
         {"respondents", method.alpha.respondents},
         {"cronbach_alpha", nullable(method.alpha.value)},
         {"cronbach_alpha_conf", limits(method.alpha.interval)},
         {"cronbach_alpha_reason", reasonOf(method.alpha.reason)},
         {"omega_total", nullable(method.omega.value)},
         {"omega_is_improper", method.omega.isImproper},
         {"omega_reason", reasonOf(method.omega.reason)},
         {"shapiro_wilk_w", nullable(method.normality.w)},
         {"shapiro_wilk_p", nullable(method.normality.p)},
         {"shapiro_wilk_reason", reasonOf(method.normality.reason)}});
  }
  return json;
}

ResultJson estimateAsJson(const analysis::PooledEstimate& pooled) {
  return {
      {"estimate", pooled.estimate},
      {"se", pooled.standardError},
      {"conf", limits(pooled.interval)},
      {pooled.df ? "t" : "z", pooled.statistic},
      {"df", nullable(pooled.df)},
      {"p", pooled.p},
      {"tau2", pooled.tauSquared},
      {"i2", pooled.iSquared}};
}

ResultJson sitesAsJson(const analysis::SiteComparison& row) {
  ResultJson json{{"group1", row.group1}, {"group2", row.group2}};
  for (const auto& site : row.sites) {
    json["sites"].push_back(
        {{"site", site.site},
         {"n", site.test.n},
         {"difference", nullable(site.test.meanDifference)},
         {"se", nullable(site.test.standardError)},
         {"conf", limits(site.interval)},
         {"weight", site.weight},
         {"reason", reasonOf(site.test.reason)}});
  }
  json["reason"] = reasonOf(row.reason);
  if (row.pooled) {
    json["q"] = row.pooled->q;
    json["q_df"] = row.pooled->sites - 1;
    json["q_p"] = row.pooled->heterogeneityP;
    json["common"] = estimateAsJson(row.pooled->common);
    json["dersimonian_laird"] = estimateAsJson(row.pooled->derSimonianLaird);
    json["reml"] = estimateAsJson(row.pooled->reml);
    json["reml_knapp_hartung"] = estimateAsJson(row.pooled->knappHartung);
  }
  json["without_each"] = ResultJson::array();
  for (const auto& without : row.leaveOneOut) {
    auto& one = json["without_each"].emplace_back(estimateAsJson(without.pooled));
    one["site"] = without.site;
  }
  json["mixed_model_fixed_sites"] = rowAsJson(row.fixedSites);
  json["mixed_model_random_sites"] = rowAsJson(row.randomSites);
  return json;
}

ResultJson conditionAsJson(const std::string& condition, const analysis::AnswerSample& answers) {
  ResultJson json{{"condition", condition}, {"n", answers.total()}};
  json["mean"] = nullable(answers.mean());
  json["variance"] = nullable(answers.variance());
  if (const auto& points = answers.points()) {
    json["counts"] = std::vector<std::uint64_t>(points->counts().begin(), points->counts().end());
  }
  return json;
}

ResultJson sitesAsJson(
    const analysis::SiteAnalysis& sites, const std::vector<std::string>& methods) {
  ResultJson json{{"sites", ResultJson::array()}, {"comparisons", ResultJson::array()}};
  for (const auto& site : sites.answers) {
    auto& one = json["sites"].emplace_back(
        ResultJson{{"site", site.site}, {"participants", site.participants}});
    for (std::size_t i = 0; i < methods.size(); ++i) {
      one["conditions"].push_back(conditionAsJson(methods[i], site.methods[i]));
    }
  }
  for (const auto& row : sites.rows) json["comparisons"].push_back(sitesAsJson(row));
  if (sites.randomSites.fit) {
    for (const auto& component : sites.randomSites.fit->components) {
      json["variances"][component.name] = component.variance;
    }
  }
  return json;
}

ResultJson cohortAsJson(const CohortResult& cohort) {
  ResultJson json{
      {"cohort", cohort.cohort},
      {"m", cohort.comparisons.tests},
      {"alpha_per_test", nullable(cohort.comparisons.alphaPerTest)}};
  for (const auto& condition : cohort.conditions) {
    json["conditions"].push_back(conditionAsJson(condition.name, condition.answers));
  }
  for (const auto& row : cohort.comparisons.rows) json["comparisons"].push_back(pooledAsJson(row));
  json["within"] = withinAsJson(cohort.within);
  if (cohort.sites) json["by_site"] = sitesAsJson(*cohort.sites, cohort.table.methods);
  json.update(checksAsJson(cohort));
  json["flags"] = ResultJson::array();
  for (const auto& flag : cohort.flags) {
    json["flags"].push_back(
        {{"id", flag.id},
         {"what", flag.inEnglish()},
         {"why", base::describe(flag.why)},
         {"remedy", base::describe(flag.remedy)},
         {"source", report::sourcesWithDois(flag.source)}});
  }
  return json;
}

ResultJson betweenAsJson(const BetweenResult& result) {
  const auto& ranks = result.test("mann_whitney");
  const auto& brunnerMunzel = result.test("brunner_munzel");
  ResultJson json{
      {"condition", result.condition},
      {"cohort1", result.cohort1},
      {"cohort2", result.cohort2},
      {"mann_whitney",
       {{"u", nullable(ranks.statistic.value)},
        {"p", nullable(ranks.p)},
        {"reason", reasonOf(ranks.reason)}}},
      {"brunner_munzel",
       {{"w", nullable(brunnerMunzel.statistic.value)},
        {"df", nullable(brunnerMunzel.df)},
        {"p", nullable(brunnerMunzel.p)},
        {"reason", reasonOf(brunnerMunzel.reason)}}},
      {"cliff_delta",
       {{"value", nullable(ranks.effect.value)},
        {"conf", limits(ranks.effectInterval)},
        {"reason", reasonOf(ranks.effectReason)}}}};
  for (const auto& test : result.tests) {
    if (!json.contains(std::string(test.id))) json[std::string(test.id)] = rowAsJson(test);
  }
  return json;
}

ResultJson familyAsJson(const FamilyResult& family) {
  ResultJson json{
      {"family_id", family.family.id},
      {"title", family.family.title},
      {"instrument", family.family.instrument},
      {"alpha", family.family.alpha},
      {"declared", declaredInWords(family.family)},
      {"declared_before_data", family.isDeclared},
      {"cohorts", ResultJson::array()},
      {"between", ResultJson::array()}};
  if (!family.family.score.empty()) json["score"] = family.family.score;
  for (const auto& cohort : family.cohorts) json["cohorts"].push_back(cohortAsJson(cohort));
  for (const auto& row : family.between) json["between"].push_back(betweenAsJson(row));
  return json;
}

ResultJson flowAsJson(const char* group, const std::string& name, const CohortFlow& flow) {
  return {
      {group, name},
      {"enrolled", flow.enrolled},
      {"completed", flow.completed},
      {"in_progress", flow.inProgress},
      {"declined", flow.declined},
      {"withdrawn", flow.withdrawn},
      {"rejected", flow.rejected},
      {"aborted_hardware", flow.abortedHardware},
      {"erased", flow.erased}};
}

ResultJson voteAsJson(const VoteResult& vote) {
  ResultJson json{{"cohort", vote.cohort}, {"phase", vote.phase}, {"block", vote.block}};
  const auto shares = vote.votes.shares();
  for (std::size_t i = 0; i < shares.size(); ++i) {
    json["votes"][shares[i].option] = shares[i].votes;
    json["wilson"][shares[i].option] = limits(vote.intervals.at(i));
  }
  json["total"] = vote.votes.total();
  json["left_out"] = vote.leftOut;
  json["p_exact"] = nullable(vote.test.exactP);
  json["reason"] = reasonOf(vote.test.reason);
  return json;
}

/// Votes summed over rounds; also over cohorts (`cohort` null) if @p cohort is empty.
ResultJson voteSumAsJson(const std::string& cohort, const analysis::VoteCounts& sum) {
  ResultJson json{{"cohort", textOrNull(cohort)}};
  for (const auto& share : sum.shares()) json["votes"][share.option] = share.votes;
  json["total"] = sum.total();
  return json;
}

ResultJson voteSumsAsJson(const Results& results) {
  auto json = ResultJson::array();
  for (const auto& table : voteTables(results)) {
    for (const auto& cohort : table.cohorts) {
      json.push_back(voteSumAsJson(cohort.cohort, cohort.sum));
    }
    json.push_back(voteSumAsJson({}, table.total));
  }
  return json;
}

ResultJson instrumentAsJson(const InstrumentSummary& summary) {
  ResultJson json{
      {"instrument", summary.instrument},
      {"forms", summary.forms},
      {"contradictory", summary.contradictory},
      {"scores", ResultJson::array()},
      {"acceptable", ResultJson::array()}};
  for (const auto& score : summary.scores) {
    json["scores"].push_back(
        {{"score", score.score},
         {"cohort", score.cohort},
         {"condition", textOrNull(score.condition)},
         {"occasion", textOrNull(score.occasion)},
         {"n", score.values.size()},
         {"missing", score.missing},
         {"mean", nullable(score.mean)},
         {"sd", nullable(score.standardDeviation)},
         {"conf", limits(score.interval)}});
  }
  for (const auto& item : summary.acceptable) {
    json["acceptable"].push_back(
        {{"item", item.item.itemId},
         {"cohort", item.cohort},
         {"condition", textOrNull(item.condition)},
         {"from", item.item.acceptableFrom},
         {"acceptable", item.item.acceptable},
         {"n", item.item.answered},
         {"share", nullable(item.item.share)},
         {"conf", limits(item.interval)}});
  }
  return json;
}

ResultJson itemAsJson(const ItemSummary& one) {
  ResultJson json{
      {"instrument", one.instrument},
      {"item", one.item},
      {"cohort", one.cohort},
      {"condition", textOrNull(one.condition)},
      {"answers", one.answers}};
  if (one.mean) {
    json["n"] = one.values.size();
    json["mean"] = nullable(one.mean);
    json["sd"] = nullable(one.standardDeviation);
    json["median"] = nullable(one.median);
    json["least"] = nullable(one.least);
    json["most"] = nullable(one.most);
  }
  for (const auto& [option, times] : one.options) json["options"][option] = times;
  return json;
}

/// The manipulation check: differences of rendered forces [N].
ResultJson differenceAsJson(const RenderedForceDifference& difference) {
  return {
      {"condition1", difference.condition1},
      {"condition2", difference.condition2},
      {"rms_pooled", difference.pooled},
      {"n", difference.participants},
      {"rms_mean", nullable(difference.mean)},
      {"conf", limits(difference.interval)}};
}

/// Adds `felt_differences`; null with a reason if the traces could not be read.
void addRenderedForces(ResultJson& json, const RenderedForceResult& forces) {
  auto& all = json["felt_differences"];
  if (forces.reason.empty()) all = ResultJson::array();
  for (const auto& d : renderedForceDifferences(forces.curves)) all.push_back(differenceAsJson(d));
  json["felt_differences_reason"] = reasonOf(forces.reason);
}

}  // namespace

std::string testAsJson(
    const analysis::StatisticalTest& test,
    const analysis::TestData& data,
    const std::vector<analysis::TestRow>& rows,
    double level) {
  const bool isList = test.hasSeveralRows();
  ResultJson json{{"test", test.id}};
  if (!isList) addNames(json, rows.front());
  json["missing"] = data.missing;
  json["conf_level"] = level;
  if (!isList) addRow(json, rows.front());
  for (const auto& row : rows) {
    if (!isList) break;
    auto& comparison = json["comparisons"].emplace_back();
    addNames(comparison, row);
    addRow(comparison, row);
  }
  return json.dump(2) + "\n";
}

std::string resultsAsJson(Study& study, const Results& results) {
  ResultJson json{
      {"study_id", study.protocol().protocol.study.id},
      {"protocol_hash", study.protocols().current().sha256},
      {"app_version", appVersion()},
      {"run_mode", nameOf(results.runMode)},
      {"flow", ResultJson::array()},
      {"families", ResultJson::array()},
      {"votes", ResultJson::array()},
      {"vote_sums", voteSumsAsJson(results)},
      {"instruments", ResultJson::array()},
      {"items", ResultJson::array()}};
  for (const auto& flow : results.flow) {
    json["flow"].push_back(flowAsJson("cohort", flow.cohort, flow));
  }
  for (const auto& [site, flow] : results.siteFlow) {
    json["flow_by_site"].push_back(flowAsJson("site", site, flow));
  }
  for (const auto& one : results.changes) json["changed"].push_back(base::describe(one));
  for (const auto& family : results.families) json["families"].push_back(familyAsJson(family));
  for (const auto& vote : results.votes) json["votes"].push_back(voteAsJson(vote));
  for (const auto& i : results.instruments) json["instruments"].push_back(instrumentAsJson(i));
  for (const auto& one : results.answers.items) json["items"].push_back(itemAsJson(one));
  addRenderedForces(json, renderedForceResult(study, results.runMode));
  return json.dump(2) + "\n";
}

}  // namespace study::app
