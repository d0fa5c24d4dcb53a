#include "study/app/planning/study_plan_file.h"

#include <nlohmann/json.hpp>

#include "study/results/results.h"

namespace study::app {
namespace {

using Json = nlohmann::ordered_json;

template <typename T>
Json orNull(const std::optional<T>& value) {
  return value ? Json(*value) : Json(nullptr);
}

Json asJson(const analysis::AttainableP& p) {
  return {{"p", p.p}, {"log10_p", p.log10P}};
}

Json asJson(const analysis::DetectionRate& rate) {
  return {{"rate", rate.rate}, {"se", rate.standardError}};
}

Json asJson(const std::optional<analysis::SimulatedPower>& found) {
  if (!found) return nullptr;
  Json json;
  const auto add = [&](const char* name, const analysis::DetectionRate& rate) {
    json[name] = asJson(rate);
  };
  add("paired_t", found->pairedT);
  add("sign_flip", found->signFlip);
  add("signed_rank", found->signedRank);
  add("friedman", found->friedman);
  add("any_paired_t", found->anyPairedT);
  add("pooled_welch", found->pooledWelch);
  add("any_pooled_welch", found->anyPooledWelch);
  return json;
}

Json asJson(const std::optional<analysis::SimulatedSitePower>& found) {
  if (!found) return nullptr;
  return {
      {"pooled", asJson(found->pooled)},
      {"any_pooled", asJson(found->anyPooled)},
      {"paired_t", asJson(found->pairedT)},
      {"any_paired_t", asJson(found->anyPairedT)},
      {"median_half_width", orNull(found->medianHalfWidth)}};
}

Json asJson(const std::optional<SiteDetectability>& sites) {
  if (!sites) return nullptr;
  return {
      {"design_effect", sites->designEffect},
      {"power", sites->power},
      {"simulated", asJson(sites->found)},
      {"simulated_without_effect", asJson(sites->falsePositives)}};
}

Json asJson(const Detectability& detectability, const CohortPlan& cohort) {
  return {
      {"cohort", cohort.id},
      {"participants", detectability.participants},
      {"smallest_pair", asJson(detectability.pair)},
      {"can_find_pairs", detectability.canPairsBeSignificant},
      {"smallest_friedman",
       detectability.friedman ? asJson(*detectability.friedman) : Json(nullptr)},
      {"power", orNull(detectability.power)},
      {"simulated", asJson(detectability.found)},
      {"simulated_without_effect", asJson(detectability.falsePositives)}};
}

Json asJson(const FamilyPlan& family, const StudyPlan& plan) {
  Json json{
      {"family_id", family.id},
      {"title", family.title},
      {"comparisons", family.comparisons},
      {"conditions", family.conditions},
      {"answers", family.answers},
      {"points", family.points},
      {"alpha", family.alpha},
      {"alpha_per_test", family.levels.strictest},
      {"alpha_per_test_at_best", family.levels.mostLenient},
      {"declared_test", idOf(family.test)},
      {"fewest_for_exact_pair", family.fewestForSignificance},
      {"participants_for_power", orNull(family.sampleSizeForPower)},
      {"participants_for_power_balanced", orNull(family.recommended)}};
  json["declared_test_found_if_balanced"] =
      family.foundIfRecommended ? asJson(*family.foundIfRecommended) : Json(nullptr);
  json["prospects"] = Json::array();
  const bool hasSites = plan.planOptions.sites.has_value();
  if (hasSites) {
    json["participants_for_power_at_sites"] = orNull(family.sampleSizeForPowerAtSites);
    json["participants_for_power_at_sites_balanced"] = orNull(family.recommendedAtSites);
  }
  for (std::size_t i = 0; i < plan.cohorts.size(); ++i) {
    auto& detectability =
        json["prospects"].emplace_back(asJson(family.detectabilities[i], plan.cohorts[i]));
    if (hasSites) detectability["at_sites"] = asJson(family.detectabilities[i].sites);
  }
  return json;
}

Json asJson(const SessionLength& length) {
  Json json{{"seconds", length.seconds}, {"seconds_of_force", length.secondsOnDevice}};
  json["parts"] = Json::array();
  for (const auto& part : length.parts) {
    json["parts"].push_back(
        {{"kind", nameOf(part.kind)},
         {"steps", part.steps},
         {"items", part.items},
         {"cuts", part.cuts},
         {"seconds", part.seconds}});
  }
  return json;
}

}  // namespace

std::string studyPlanAsJson(const StudyPlan& plan) {
  Json json{
      {"title", plan.title},
      {"effect_dz", plan.planOptions.dz},
      {"power", plan.planOptions.power},
      {"balanced_by", plan.balancedBy}};
  if (const auto& sites = plan.planOptions.sites) {
    json["sites"] = sites->sites;
    json["site_sd_dz"] = sites->deviation;
    json["site_icc"] = sites->intraclassCorrelation();
  }
  json["blocks"] = Json::array();
  for (const auto& block : plan.blocks) {
    json["blocks"].push_back(
        {{"phase", block.phase},
         {"conditions", block.conditions},
         {"multiple_of", block.multipleOf},
         {"one_order_for_all", block.hasOneOrder}});
  }
  json["cohorts"] = Json::array();
  for (const auto& cohort : plan.cohorts) {
    json["cohorts"].push_back(
        {{"id", cohort.id},
         {"participants", cohort.participants},
         {"balanced", cohort.isBalanced}});
  }
  json["cohort_pairs"] = Json::array();
  for (const auto& pair : plan.cohortPairs) {
    json["cohort_pairs"].push_back(
        {{"first", pair.first},
         {"second", pair.second},
         {"smallest_mann_whitney", asJson(pair.smallestP)}});
  }
  json["families"] = Json::array();
  for (const auto& family : plan.families) json["families"].push_back(asJson(family, plan));
  json["votes"] = Json::array();
  for (const auto& vote : plan.votes) {
    json["votes"].push_back(
        {{"phase", vote.phase},
         {"cohort", vote.cohort},
         {"alternatives", vote.alternatives},
         {"votes", vote.votes},
         {"can_decide", vote.canDecide},
         {"to_win", orNull(vote.votesForSignificance)}});
  }
  json["session"] = asJson(plan.length);
  json["max_force_n"] = plan.largestForce;
  json["ethics"] = ethicsParagraph(plan);
  return json.dump(2) + "\n";
}

}  // namespace study::app
