#include <cmath>

#include <nlohmann/json.hpp>

#include "study/app/json_file.h"
#include "study/export/statistics_row.h"
#include "study/results/apa_text.h"
#include "study/results/felt_curves.h"

namespace study::app {
namespace {

using ResultJson = nlohmann::ordered_json;

/// JSON has no infinity: a t beyond every number is null, and the reason says so.
ResultJson nullable(const std::optional<double>& value) {
  return value && std::isfinite(*value) ? ResultJson(*value) : ResultJson(nullptr);
}

ResultJson nullable(const std::optional<bool>& value) {
  return value ? ResultJson(*value) : ResultJson(nullptr);
}

ResultJson textOrNull(const std::string& text) {
  return text.empty() ? ResultJson(nullptr) : ResultJson(text);
}

ResultJson reasonOf(const base::Message& reason) {
  return reason.empty() ? ResultJson(nullptr) : ResultJson(base::describe(reason));
}

ResultJson limits(const std::optional<analysis::Interval>& interval) {
  if (!interval) return nullptr;
  return ResultJson::array({interval->low, interval->high});
}

ResultJson pooledAsJson(const analysis::PairwiseComparison& row) {
  const auto& w = row.welch;
  return {
      {"group1", row.group1},
      {"group2", row.group2},
      {"n1", w.n1},
      {"n2", w.n2},
      {"mean1", nullable(w.mean1)},
      {"mean2", nullable(w.mean2)},
      {"variance1", nullable(w.variance1)},
      {"variance2", nullable(w.variance2)},
      {"difference", nullable(w.difference)},
      {"se", nullable(w.standardError)},
      {"t", nullable(w.t)},
      {"df", nullable(w.degreesOfFreedom)},
      {"p", nullable(w.p)},
      {"log10_p", nullable(w.log10P)},
      {"conf_low", row.interval ? ResultJson(row.interval->low) : ResultJson(nullptr)},
      {"conf_high", row.interval ? ResultJson(row.interval->high) : ResultJson(nullptr)},
      {"reason", reasonOf(w.reason)},
      {"p_adj", nullable(row.adjustedP)},
      {"conf_low_adj",
       row.adjustedInterval ? ResultJson(row.adjustedInterval->low) : ResultJson(nullptr)},
      {"conf_high_adj",
       row.adjustedInterval ? ResultJson(row.adjustedInterval->high) : ResultJson(nullptr)},
      {"significant", nullable(row.isSignificant)}};
}

ResultJson testedAsJson(const analysis::AdjustedP& p, const analysis::Reason& reason) {
  return {
      {"p", nullable(p.p)},
      {"p_adj", nullable(p.adjusted)},
      {"significant", nullable(p.isSignificant)},
      {"reason", reasonOf(reason)}};
}

void addInterval(
    ResultJson& json,
    const std::string& prefix,
    const std::optional<analysis::Interval>& interval) {
  json[prefix + "low"] = interval ? ResultJson(interval->low) : ResultJson(nullptr);
  json[prefix + "high"] = interval ? ResultJson(interval->high) : ResultJson(nullptr);
}

void addModels(ResultJson& json, const analysis::WithinComparison& row, double alpha) {
  json["mixed_model"] = testedAsJson(row.mixedP, row.mixed.reason);
  if (row.mixedP.p) {
    json["mixed_model"]["estimate"] = row.mixed.estimate;
    json["mixed_model"]["se"] = row.mixed.standardError;
    json["mixed_model"]["t"] = nullable(row.mixed.t);
    json["mixed_model"]["df"] = nullable(row.mixed.degreesOfFreedom);
  }
  json["ordinal_model"] = testedAsJson(row.ordinalP, row.ordinalReason);
  if (!row.ordinal) return;
  json["ordinal_model"]["estimate"] = row.ordinal->estimate;
  json["ordinal_model"]["se"] = row.ordinal->standardError;
  json["ordinal_model"]["z"] = row.ordinal->z;
  json["ordinal_model"]["odds_ratio"] = nullable(std::optional(row.ordinal->oddsRatio));
  json["ordinal_model"]["odds_ratio_conf"] = limits(oddsRatioInterval(*row.ordinal, 1.0 - alpha));
}

ResultJson withinAsJson(const analysis::WithinComparison& row, double alpha) {
  ResultJson json{
      {"group1", row.group1},
      {"group2", row.group2},
      {"n", row.paired.n},
      {"difference", nullable(row.paired.meanDifference)},
      {"se", nullable(row.paired.standardError)},
      {"t", nullable(row.paired.t)},
      {"df", nullable(row.paired.degreesOfFreedom)},
      {"log10_p", nullable(row.paired.log10P)}};
  addInterval(json, "conf_", row.interval);
  addInterval(json, "conf_adj_", row.adjustedInterval);
  json["paired_t"] = testedAsJson(row.pairedP, row.paired.reason);
  json["sign_flip"] = testedAsJson(row.signFlipP, row.signFlip.reason);
  json["signed_rank"] = testedAsJson(row.signedRankP, row.signedRank.reason);
  json["signed_rank"]["v"] = nullable(row.signedRank.v);
  json["signed_rank"]["rank_biserial"] = nullable(row.signedRank.rankBiserial);
  json["hodges_lehmann"] = nullable(row.location.estimate);
  addModels(json, row, alpha);
  json["d_z"] = nullable(row.effects.cohenDz.value);
  json["g_z"] = nullable(row.effects.hedgesGz.value);
  addInterval(json, "g_z_", row.effects.hedgesGz.interval);
  json["bf10"] = nullable(row.bayes.bf10);
  if (row.equivalence) {
    json["tost"] = {
        {"bound", row.equivalence->bounds.upper},
        {"p", nullable(row.equivalence->p)},
        {"reason", reasonOf(row.equivalence->reason)}};
  }
  json["reason"] = reasonOf(row.paired.reason);
  return json;
}

ResultJson overallAsJson(const analysis::WithinAnalysis& within) {
  const auto& friedman = within.friedman;
  const auto& anova = within.anova;
  ResultJson json;
  json["friedman"] = {
      {"chi2", nullable(friedman.chiSquared)},
      {"df", friedman.treatments > 0 ? ResultJson(friedman.treatments - 1) : ResultJson(nullptr)},
      {"p", nullable(friedman.p)},
      {"p_exact", nullable(friedman.exactP)},
      {"kendall_w", nullable(friedman.kendallW)},
      {"reason", reasonOf(friedman.reason)}};
  json["anova"] = {
      {"f", nullable(anova.f)},
      {"df1", nullable(anova.degreesOfFreedom1)},
      {"df2", nullable(anova.degreesOfFreedom2)},
      {"p", nullable(anova.p)},
      {"partial_eta2", nullable(anova.partialEtaSquared)},
      {"greenhouse_geisser", nullable(anova.greenhouseGeisser)},
      {"p_greenhouse_geisser", nullable(anova.pGreenhouseGeisser)},
      {"reason", reasonOf(anova.reason)}};
  json["mixed_model"] = {{"reason", reasonOf(within.mixed.reason)}};
  if (within.mixed.fit) {
    for (const auto& component : within.mixed.fit->components) {
      json["mixed_model"]["variances"][component.name] = component.variance;
    }
    json["mixed_model"]["variances"]["residual"] = within.mixed.fit->residualVariance;
  }
  json["ordinal_model"] = {{"reason", reasonOf(within.ordinal.reason)}};
  if (within.ordinal.fit) {
    for (const auto& component : within.ordinal.fit->components) {
      json["ordinal_model"]["variances"][component.name] = component.variance;
    }
  }
  return json;
}

ResultJson withinAsJson(const analysis::WithinAnalysis& within, double alpha) {
  ResultJson json{
      {"participants", within.participants},
      {"left_out", within.leftOut},
      {"m", within.tests},
      {"alpha_per_test", nullable(within.alphaPerTest)}};
  json.update(overallAsJson(within));
  json["comparisons"] = ResultJson::array();
  for (const auto& row : within.rows) json["comparisons"].push_back(withinAsJson(row, alpha));
  return json;
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

ResultJson cohortAsJson(const CohortResult& cohort, double alpha) {
  ResultJson json{
      {"cohort", cohort.cohort},
      {"m", cohort.comparisons.tests},
      {"alpha_per_test", nullable(cohort.comparisons.alphaPerTest)}};
  for (const auto& condition : cohort.conditions) {
    const auto counts = condition.counts.counts();
    json["conditions"].push_back(
        {{"condition", condition.name},
         {"n", condition.counts.total()},
         {"mean", nullable(condition.counts.mean())},
         {"variance", nullable(condition.counts.variance())},
         {"counts", std::vector<std::uint64_t>(counts.begin(), counts.end())}});
  }
  for (const auto& row : cohort.comparisons.rows) json["comparisons"].push_back(pooledAsJson(row));
  json["within"] = withinAsJson(cohort.within, alpha);
  json.update(checksAsJson(cohort));
  json["flags"] = ResultJson::array();
  for (const auto& flag : cohort.flags) {
    json["flags"].push_back(
        {{"id", flag.id},
         {"what", flag.inEnglish()},
         {"why", base::describe(flag.why)},
         {"remedy", base::describe(flag.remedy)},
         {"source", base::describe(flag.source)}});
  }
  return json;
}

ResultJson betweenAsJson(const BetweenResult& row) {
  return {
      {"condition", row.condition},
      {"cohort1", row.cohort1},
      {"cohort2", row.cohort2},
      {"mann_whitney",
       {{"u", nullable(row.mannWhitney.u)},
        {"p", nullable(row.mannWhitney.p)},
        {"reason", reasonOf(row.mannWhitney.reason)}}},
      {"brunner_munzel",
       {{"w", nullable(row.brunnerMunzel.w)},
        {"df", nullable(row.brunnerMunzel.degreesOfFreedom)},
        {"p", nullable(row.brunnerMunzel.p)},
        {"reason", reasonOf(row.brunnerMunzel.reason)}}},
      {"cliff_delta",
       {{"value", nullable(row.cliff.delta)},
        {"conf", limits(row.cliff.interval)},
        {"reason", reasonOf(row.cliff.reason)}}}};
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
  for (const auto& cohort : family.cohorts) {
    json["cohorts"].push_back(cohortAsJson(cohort, family.family.alpha));
  }
  for (const auto& row : family.between) json["between"].push_back(betweenAsJson(row));
  return json;
}

ResultJson flowAsJson(const CohortFlow& flow) {
  return {
      {"cohort", flow.cohort},
      {"enrolled", flow.enrolled},
      {"completed", flow.completed},
      {"in_progress", flow.inProgress},
      {"declined", flow.declined},
      {"withdrawn", flow.withdrawn},
      {"rejected", flow.rejected},
      {"aborted_hardware", flow.abortedHardware}};
}

ResultJson voteAsJson(const VoteResult& vote) {
  ResultJson json{{"cohort", vote.cohort}, {"phase", vote.phase}, {"block", vote.block}};
  const auto shares = vote.votes.shares();
  for (std::size_t i = 0; i < shares.size(); ++i) {
    json["votes"][shares[i].option] = shares[i].votes;
    json["wilson"][shares[i].option] = limits(vote.intervals.at(i));
  }
  json["total"] = vote.votes.total();
  json["p_exact"] = nullable(vote.test.exactP);
  json["reason"] = reasonOf(vote.test.reason);
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

/// The manipulation check [N].
ResultJson feltAsJson(const FeltDifference& felt) {
  return {
      {"condition1", felt.condition1},
      {"condition2", felt.condition2},
      {"rms_pooled", felt.pooled},
      {"n", felt.participants},
      {"rms_mean", nullable(felt.mean)},
      {"conf", limits(felt.interval)}};
}

/// Null with its reason where the traces do not tell.
void addFelt(ResultJson& json, const FeltResult& felt) {
  auto& differences = json["felt_differences"];
  if (felt.reason.empty()) differences = ResultJson::array();
  for (const auto& one : feltDifferences(felt.curves)) differences.push_back(feltAsJson(one));
  json["felt_differences_reason"] = reasonOf(felt.reason);
}

}  // namespace

std::string resultsAsJson(Study& study, const Results& results) {
  ResultJson json{
      {"study_id", study.protocol().protocol.study.id},
      {"protocol_hash", study.protocols().current().sha256},
      {"app_version", appVersion()},
      {"run_mode", nameOf(results.runMode)},
      {"flow", ResultJson::array()},
      {"families", ResultJson::array()},
      {"votes", ResultJson::array()},
      {"instruments", ResultJson::array()}};
  for (const auto& flow : results.flow) json["flow"].push_back(flowAsJson(flow));
  for (const auto& family : results.families) json["families"].push_back(familyAsJson(family));
  for (const auto& vote : results.votes) json["votes"].push_back(voteAsJson(vote));
  for (const auto& i : results.instruments) json["instruments"].push_back(instrumentAsJson(i));
  addFelt(json, feltResult(study, results.runMode));
  return json.dump(2) + "\n";
}

}  // namespace study::app
