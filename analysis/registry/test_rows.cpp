#include "analysis/registry/test_rows.h"

#include "analysis/models/answer_probability.h"

namespace analysis {
namespace {

/// A row with the numbers that every test has.
template <typename Result>
TestRow rowWithP(const Result& result) {
  TestRow row;
  row.p = result.p;
  row.reason = result.reason;
  return row;
}

template <typename Result>
TestRow rowWithLog10P(const Result& result) {
  auto row = rowWithP(result);
  row.log10P = result.log10P;
  return row;
}

/// A row with F, its degrees of freedom and p.
template <typename Result>
TestRow rowWithF(const Result& result) {
  auto row = rowWithLog10P(result);
  row.statistic = {"F", result.f};
  row.df = result.degreesOfFreedom1;
  row.df2 = result.degreesOfFreedom2;
  return row;
}

/// Adds a mean difference with its standard error and t.
template <typename Result>
void addDifference(TestRow& row, const Result& result, const std::optional<double>& difference) {
  row.estimate = {"difference", difference};
  row.standardError = result.standardError;
  row.df = result.degreesOfFreedom;
}

template <typename Test>
TestRow equivalenceRow(
    const EquivalenceResult& result, const Test& test, const std::optional<double>& difference) {
  auto row = rowWithLog10P(result);
  addDifference(row, test, difference);
  row.more = {{"equivalence_bound", result.bounds.upper}};
  return row;
}

}  // namespace

TestRow rowOf(const WelchResult& result, const std::optional<Interval>& interval) {
  auto row = rowWithLog10P(result);
  row.n1 = result.n1;
  row.n2 = result.n2;
  row.moments = {{{result.mean1, result.variance1}, {result.mean2, result.variance2}}};
  addDifference(row, result, result.difference);
  row.statistic = {"t", result.t};
  row.interval = interval;
  return row;
}

TestRow rowOf(const StudentResult& result) {
  TestRow row;
  row.statistic = {"t", result.t};
  row.df = result.degreesOfFreedom;
  row.p = result.p;
  return row;
}

TestRow rowOf(const MannWhitneyResult& result, const CliffDelta& delta) {
  auto row = rowWithP(result);
  row.n1 = result.n1;
  row.n2 = result.n2;
  row.statistic = {"U", result.u};
  row.effect = {"cliff_delta", delta.delta};
  row.effectInterval = delta.interval;
  row.effectReason = delta.reason;
  row.more = {
      {"z", result.z},
      {"p_asymptotic", result.pAsymptotic},
      {"p_asymptotic_continuity", result.pAsymptoticContinuity}};
  return row;
}

TestRow rowOf(const BrunnerMunzelResult& result) {
  auto row = rowWithLog10P(result);
  row.n1 = result.n1;
  row.n2 = result.n2;
  row.statistic = {"W", result.w};
  row.df = result.degreesOfFreedom;
  row.more = {{"probability", result.probability}};
  return row;
}

TestRow rowOf(const OneWayAnovaResult& result) {
  auto row = rowWithF(result);
  row.n1 = result.n;
  row.effect = {"eta2", result.rSquared};
  return row;
}

TestRow rowOf(const BrownForsytheResult& result) {
  return rowWithF(result);
}

TestRow rowOf(const ShapiroWilkResult& result) {
  auto row = rowWithP(result);
  row.n1 = result.n;
  row.statistic = {"W", result.w};
  return row;
}

TestRow rowOf(
    const PairedTResult& result,
    const std::optional<Interval>& interval,
    const PairedEffects& effects) {
  auto row = rowWithLog10P(result);
  row.n1 = result.n;
  addDifference(row, result, result.meanDifference);
  row.statistic = {"t", result.t};
  row.interval = interval;
  row.effect = {"g_z", effects.hedgesGz.value};
  row.effectInterval = effects.hedgesGz.interval;
  row.more = {{"d_z", effects.cohenDz.value}};
  return row;
}

TestRow rowOf(const SignFlipResult& result) {
  auto row = rowWithP(result);
  row.n1 = result.n;
  return row;
}

TestRow rowOf(const SignedRankResult& result, const HodgesLehmannResult& location) {
  auto row = rowWithP(result);
  row.n1 = result.n;
  row.estimate = {"location", location.estimate};
  if (row.reason.empty()) row.reason = location.reason;
  row.statistic = {"V", result.v};
  row.effect = {"rank_biserial", result.rankBiserial};
  row.more = {
      {"z", result.z},
      {"p_asymptotic", result.pAsymptotic},
      {"p_asymptotic_continuity", result.pAsymptoticContinuity}};
  return row;
}

TestRow rowOf(const SignTestResult& result) {
  auto row = rowWithLog10P(result);
  row.n1 = result.positive + result.negative + result.zeros;
  row.more = {
      {"positive", static_cast<double>(result.positive)},
      {"negative", static_cast<double>(result.negative)},
      {"zeros", static_cast<double>(result.zeros)}};
  return row;
}

TestRow rowOf(const BayesFactor& factor, std::size_t pairs) {
  TestRow row;
  row.n1 = pairs;
  row.effect = {"bf10", factor.bf10};
  row.reason = factor.reason;
  return row;
}

TestRow rowOf(const EquivalenceResult& result, const PairedTResult& test) {
  auto row = equivalenceRow(result, test, test.meanDifference);
  row.n1 = test.n;
  return row;
}

TestRow rowOf(const EquivalenceResult& result, const WelchResult& test) {
  auto row = equivalenceRow(result, test, test.difference);
  row.n1 = test.n1;
  row.n2 = test.n2;
  return row;
}

TestRow rowOf(const FriedmanResult& result) {
  auto row = rowWithLog10P(result);
  row.n1 = result.blocks;
  row.statistic = {"chi2", result.chiSquared};
  if (result.chiSquared) row.df = static_cast<double>(result.treatments - 1);
  row.effect = {"kendall_w", result.kendallW};
  row.more = {
      {"p_permutation", result.exactP},
      {"conditions", static_cast<double>(result.treatments)},
      {"iman_davenport_f", result.imanDavenportF},
      {"iman_davenport_p", result.imanDavenportP}};
  return row;
}

TestRow rowOf(const RepeatedMeasuresResult& result) {
  auto row = rowWithF(result);
  row.n1 = result.participants;
  row.effect = {"partial_eta2", result.partialEtaSquared};
  row.more = {{"epsilon", result.greenhouseGeisser}, {"p_epsilon", result.pGreenhouseGeisser}};
  return row;
}

TestRow rowOf(const CochranResult& result) {
  auto row = rowWithLog10P(result);
  row.n1 = result.persons;
  row.statistic = {"Q", result.q};
  row.df = result.degreesOfFreedom;
  row.more = {
      {"p_permutation", result.exactP},
      {"undecided", static_cast<double>(result.unvaryingPersons)}};
  return row;
}

TestRow rowOf(const IntraclassCorrelations& all, const IntraclassCorrelation& one) {
  auto row = TestRow();
  row.n1 = all.subjects;
  row.statistic = {"F", one.f};
  row.df = one.degreesOfFreedom1;
  row.df2 = one.degreesOfFreedom2;
  row.p = one.p;
  row.effect = {"icc", one.value};
  row.effectInterval = one.interval;
  row.more = {{"raters", static_cast<double>(all.raters)}};
  row.reason = all.reason;
  return row;
}

TestRow rowOf(const CronbachAlpha& alpha) {
  TestRow row;
  row.n1 = alpha.respondents;
  row.effect = {"cronbach_alpha", alpha.value};
  row.effectInterval = alpha.interval;
  row.reason = alpha.reason;
  return row;
}

TestRow rowOf(const OmegaTotal& omega) {
  TestRow row;
  row.n1 = omega.respondents;
  row.effect = {"omega_total", omega.value};
  row.reason = omega.isImproper ? reason("improper_omega") : omega.reason;
  return row;
}

TestRow rowOf(const FisherExactResult& result) {
  auto row = rowWithP(result);
  row.n1 = result.total;
  return row;
}

TestRow rowOf(const McNemarResult& result) {
  auto row = rowWithLog10P(result);
  row.statistic = {"chi2", result.chiSquared};
  if (result.chiSquared) row.df = 1.0;
  row.more = {
      {"p_asymptotic", result.pAsymptotic},
      {"changed_to_second", static_cast<double>(result.changedToYes)},
      {"changed_to_first", static_cast<double>(result.changedToNo)}};
  return row;
}

TestRow rowOf(const StuartMaxwellResult& result) {
  auto row = rowWithLog10P(result);
  row.n1 = result.persons;
  row.statistic = {"chi2", result.chiSquared};
  row.df = result.degreesOfFreedom;
  row.more = {{"changed", static_cast<double>(result.changed)}};
  return row;
}

TestRow rowOf(const EqualSharesResult& result) {
  TestRow row;
  row.n1 = result.votes;
  row.statistic = {"chi2", result.chiSquared};
  row.df = result.degreesOfFreedom;
  row.p = result.exactP;
  row.more = {{"p_asymptotic", result.p}};
  row.reason = result.reason;
  return row;
}

TestRow rowOf(const TEstimate& estimate, std::size_t answers) {
  auto row = rowWithLog10P(estimate);
  row.n1 = answers;
  if (!estimate.p) return row;
  row.estimate = {"difference", estimate.estimate};
  row.standardError = estimate.standardError;
  row.statistic = {"t", estimate.t};
  row.df = estimate.degreesOfFreedom;
  return row;
}

TestRow rowOf(const WaldEstimate& estimate, std::size_t answers, double level) {
  TestRow row;
  row.n1 = answers;
  row.estimate = {"log_odds_ratio", estimate.estimate};
  row.standardError = estimate.standardError;
  row.statistic = {"z", estimate.z};
  row.p = estimate.p;
  row.log10P = estimate.log10P;
  row.effect = {"odds_ratio", estimate.oddsRatio};
  row.effectInterval = oddsRatioInterval(estimate, level);
  return row;
}

TestRow answerProbabilityRow(
    const CumulativeLinkResult& model,
    const FixedEffects& fixed,
    std::span<const int> answers,
    const HighAnswerEvent& event,
    double level) {
  TestRow row;
  row.group1 = event.group;
  row.estimate.name = "logit";
  row.effect.name = "probability";
  row.more = {{"from", event.from}};
  const auto& factor = fixed.factor(event.factor);
  std::uint64_t given = 0;
  std::uint64_t high = 0;
  for (std::size_t i = 0; i < answers.size(); ++i) {
    if (factor.levels[factor.levelOfAnswer[i]] != event.group) continue;
    ++given;
    if (answers[i] >= event.from) ++high;
  }
  row.n1 = given;
  row.statistic.name = "observed_share";
  if (given > 0) row.statistic.value = static_cast<double>(high) / static_cast<double>(given);
  row.reason = given == 0 ? reason("no_answers_to_method") : model.reason;
  if (!row.reason.empty()) return row;
  const auto likely =
      answerProbability(*model.fit, event.from, fixed.combinations(event.factor, event.group));
  if (!likely) {
    row.reason = reason("one_side_of_level", event.from);
    return row;
  }
  row.estimate.value = likely->logit.estimate;
  row.standardError = likely->logit.standardError;
  row.interval = confidenceInterval(likely->logit, level);
  row.effect.value = likely->probability;
  row.effectInterval = probabilityInterval(*likely, level);
  return row;
}

}  // namespace analysis
