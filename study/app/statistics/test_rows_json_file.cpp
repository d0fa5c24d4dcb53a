#include <cmath>

#include <nlohmann/json.hpp>

#include "study/app/statistics/test_rows_json.h"

namespace study::app {

ResultJson nullable(const std::optional<double>& value) {
  return value && std::isfinite(*value) ? ResultJson(*value) : ResultJson(nullptr);
}

ResultJson nullable(const std::optional<bool>& value) {
  return value ? ResultJson(*value) : ResultJson(nullptr);
}

ResultJson reasonOf(const base::Message& reason) {
  return reason.empty() ? ResultJson(nullptr) : ResultJson(base::describe(reason));
}

ResultJson limits(const std::optional<analysis::Interval>& interval) {
  if (!interval) return nullptr;
  return ResultJson::array({interval->low, interval->high});
}

namespace {

void addInterval(
    ResultJson& json,
    const std::string& prefix,
    const std::optional<analysis::Interval>& interval) {
  json[prefix + "low"] = interval ? nullable(std::optional(interval->low)) : ResultJson(nullptr);
  json[prefix + "high"] = interval ? nullable(std::optional(interval->high)) : ResultJson(nullptr);
}

void addNumber(ResultJson& json, const analysis::NamedNumber& number) {
  if (!number.name.empty()) json[std::string(number.name)] = nullable(number.value);
}

void addSizes(ResultJson& json, const analysis::TestRow& row) {
  if (row.n1) json[row.n2 ? "n1" : "n"] = *row.n1;
  if (row.n2) json["n2"] = *row.n2;
  if (!row.moments) return;
  json["mean1"] = nullable((*row.moments)[0].mean);
  json["mean2"] = nullable((*row.moments)[1].mean);
  json["variance1"] = nullable((*row.moments)[0].variance);
  json["variance2"] = nullable((*row.moments)[1].variance);
}

/// The keys that all tests of a family's comparisons have.
ResultJson commonKeysAsJson(const analysis::TestRow& test) {
  return {
      {"p", nullable(test.p)},
      {"p_adj", nullable(test.adjusted)},
      {"significant", nullable(test.isSignificant)},
      {"reason", reasonOf(test.reason)}};
}

ResultJson mixedModelAsJson(const analysis::TestRow& test) {
  auto json = commonKeysAsJson(test);
  if (!test.p) return json;
  json["estimate"] = nullable(test.estimate.value);
  json["se"] = nullable(test.standardError);
  json["t"] = nullable(test.statistic.value);
  json["df"] = nullable(test.df);
  return json;
}

ResultJson ordinalModelAsJson(const analysis::TestRow& test) {
  auto json = commonKeysAsJson(test);
  if (!test.p) return json;
  json["estimate"] = nullable(test.estimate.value);
  json["se"] = nullable(test.standardError);
  json["z"] = nullable(test.statistic.value);
  json["odds_ratio"] = nullable(test.effect.value);
  json["odds_ratio_conf"] = limits(test.effectInterval);
  return json;
}

ResultJson equivalenceAsJson(const analysis::TestRow& test) {
  return {
      {"bound", nullable(test.additionalNumber("equivalence_bound"))},
      {"p", nullable(test.p)},
      {"reason", reasonOf(test.reason)}};
}

/// First the tests with keys of their own, in a fixed order, then the other tests by id.
ResultJson withinAsJson(const analysis::WithinComparison& comparison) {
  const auto& paired = comparison.test("paired_t");
  const auto& rank = comparison.test("signed_rank");
  ResultJson json{
      {"group1", comparison.group1},
      {"group2", comparison.group2},
      {"n", paired.n1.value_or(0)},
      {"difference", nullable(paired.estimate.value)},
      {"se", nullable(paired.standardError)},
      {"t", nullable(paired.statistic.value)},
      {"df", nullable(paired.df)},
      {"log10_p", nullable(paired.log10P)}};
  addInterval(json, "conf_", paired.interval);
  addInterval(json, "conf_adj_", paired.adjustedInterval);
  json["paired_t"] = commonKeysAsJson(paired);
  json["sign_flip"] = commonKeysAsJson(comparison.test("sign_flip"));
  json["signed_rank"] = commonKeysAsJson(rank);
  json["signed_rank"]["v"] = nullable(rank.statistic.value);
  json["signed_rank"]["rank_biserial"] = nullable(rank.effect.value);
  json["hodges_lehmann"] = nullable(rank.estimate.value);
  json["mixed_model"] = mixedModelAsJson(comparison.test("mixed_model"));
  json["ordinal_model"] = ordinalModelAsJson(comparison.test("ordinal_model"));
  json["d_z"] = nullable(paired.additionalNumber("d_z"));
  json["g_z"] = nullable(paired.effect.value);
  addInterval(json, "g_z_", paired.effectInterval);
  json["bf10"] = nullable(comparison.test("bayes_factor").effect.value);
  for (const auto& test : comparison.tests) {
    const std::string id(test.id);
    if (id == "tost") {
      json[id] = equivalenceAsJson(test);
    } else if (id != "bayes_factor" && !json.contains(id)) {
      json[id] = rowAsJson(test);
    }
  }
  json["reason"] = reasonOf(paired.reason);
  return json;
}

ResultJson friedmanAsJson(const analysis::TestRow& test) {
  // df is also written if there are too few participants for χ².
  const auto conditions =
      static_cast<std::int64_t>(test.additionalNumber("conditions").value_or(0.0));
  return {
      {"chi2", nullable(test.statistic.value)},
      {"df", conditions > 0 ? ResultJson(conditions - 1) : ResultJson(nullptr)},
      {"p", nullable(test.p)},
      {"p_exact", nullable(test.additionalNumber("p_permutation"))},
      {"kendall_w", nullable(test.effect.value)},
      {"reason", reasonOf(test.reason)}};
}

ResultJson anovaAsJson(const analysis::TestRow& test) {
  return {
      {"f", nullable(test.statistic.value)},
      {"df1", nullable(test.df)},
      {"df2", nullable(test.df2)},
      {"p", nullable(test.p)},
      {"partial_eta2", nullable(test.effect.value)},
      {"greenhouse_geisser", nullable(test.additionalNumber("epsilon"))},
      {"p_greenhouse_geisser", nullable(test.additionalNumber("p_epsilon"))},
      {"reason", reasonOf(test.reason)}};
}

ResultJson overallAsJson(const analysis::WithinAnalysis& within) {
  ResultJson json;
  for (const auto& test : within.overall) {
    const std::string id(test.id);
    if (id == "friedman") {
      json[id] = friedmanAsJson(test);
    } else if (id == "rm_anova") {
      json["anova"] = anovaAsJson(test);
    } else {
      json[id] = rowAsJson(test);
    }
  }
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

}  // namespace

void addRow(ResultJson& json, const analysis::TestRow& row) {
  addSizes(json, row);
  addNumber(json, row.estimate);
  if (!row.estimate.name.empty()) json["se"] = nullable(row.standardError);
  addNumber(json, row.statistic);
  json["df"] = nullable(row.df);
  if (row.statistic.name == "F") json["df2"] = nullable(row.df2);
  json["p"] = nullable(row.p);
  json["log10_p"] = nullable(row.log10P);
  if (!row.estimate.name.empty()) addInterval(json, "conf_", row.interval);
  addNumber(json, row.effect);
  if (!row.effect.name.empty()) {
    addInterval(json, std::string(row.effect.name) + "_", row.effectInterval);
  }
  for (const auto& number : row.more) addNumber(json, number);
  json["reason"] = reasonOf(row.reason);
}

void addNames(ResultJson& json, const analysis::TestRow& row) {
  if (row.group1.empty()) return;
  json["group1"] = row.group1;
  if (!row.group2.empty()) json["group2"] = row.group2;
}

ResultJson pooledAsJson(const analysis::TestRow& test) {
  ResultJson json;
  addNames(json, test);
  addRow(json, test);
  json["p_adj"] = nullable(test.adjusted);
  const auto& interval = test.adjustedInterval;
  json["conf_low_adj"] = interval ? ResultJson(interval->low) : ResultJson(nullptr);
  json["conf_high_adj"] = interval ? ResultJson(interval->high) : ResultJson(nullptr);
  json["significant"] = nullable(test.isSignificant);
  return json;
}

ResultJson rowAsJson(const analysis::TestRow& test) {
  ResultJson json;
  addRow(json, test);
  if (test.isInFamily) json.update(commonKeysAsJson(test));
  return json;
}

ResultJson withinAsJson(const analysis::WithinAnalysis& within) {
  ResultJson json{
      {"participants", within.participants},
      {"left_out", within.excludedParticipants},
      {"m", within.tests},
      {"alpha_per_test", nullable(within.alphaPerTest)}};
  json.update(overallAsJson(within));
  json["answer_probabilities"] = ResultJson::array();
  for (const auto& row : within.probabilities) {
    auto& entry = json["answer_probabilities"].emplace_back();
    entry["condition"] = row.group1;
    addRow(entry, row);
  }
  json["comparisons"] = ResultJson::array();
  for (const auto& row : within.rows) json["comparisons"].push_back(withinAsJson(row));
  return json;
}

}  // namespace study::app
