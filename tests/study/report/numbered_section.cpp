#include "tests/study/report/numbered_section.h"

#include <map>
#include <string>
#include <vector>

#include "tests/study/made_study.h"

namespace tests {
namespace {

using questionnaires::LocalizedText;
using study::CohortResult;

constexpr const char* kFirst = "interpolation";
constexpr const char* kSecond = "finite-elements";
constexpr const char* kCohort = "professional";

LocalizedText inEnglish(const std::string& text) {
  return LocalizedText(std::map<std::string, std::string>{{"en", text}});
}

analysis::PairwiseComparisons pooledComparisons() {
  analysis::TestRow row;
  row.id = "welch";
  row.group1 = kFirst;
  row.group2 = kSecond;
  row.n1 = 201;
  row.n2 = 202;
  row.moments = {{{2.03, 2.05}, {2.04, 2.06}}};
  row.estimate = {"difference", 2.07};
  row.standardError = 2.08;
  row.statistic = {"t", 2.09};
  row.df = 21.11;
  row.p = 0.212;
  row.adjusted = 0.214;
  row.isSignificant = true;
  row.interval = {2.15, 2.16};
  row.adjustedInterval = {2.17, 2.18};
  return {.alpha = 0.01, .tests = 4, .alphaPerTest = 0.0025, .rows = {row}};
}

analysis::TestRow tested(
    std::string_view id, double p, double adjusted, bool isSignificant = false) {
  analysis::TestRow row;
  row.id = id;
  row.p = p;
  row.isInFamily = true;
  row.adjusted = adjusted;
  row.isSignificant = isSignificant;
  return row;
}

analysis::TestRow pairedT() {
  auto row = tested("paired_t", 0.307, 0.341);
  row.n1 = 301;
  row.estimate = {"difference", 3.02};
  row.standardError = 3.04;
  row.statistic = {"t", 3.05};
  row.df = 36.0;
  row.interval = {3.08, 3.09};
  row.adjustedInterval = {3.11, 3.12};
  row.effect = {"g_z", 3.16};
  row.effectInterval = {3.17, 3.18};
  row.more = {{"d_z", 3.13}};
  return row;
}

analysis::TestRow bayesFactor() {
  analysis::TestRow row;
  row.id = "bayes_factor";
  row.effect = {"bf10", 3.25};
  return row;
}

analysis::TestRow equivalence() {
  analysis::TestRow row;
  row.id = "tost";
  row.p = 0.327;
  row.more = {{"equivalence_bound", 0.26}};
  return row;
}

analysis::WithinComparison withinComparison() {
  auto rank = tested("signed_rank", 0.321, 0.343, true);
  rank.statistic = {"V", 323.0};
  rank.estimate = {"location", 3.24};
  rank.more = {{"p_asymptotic", 0.322}};
  auto mixed = tested("mixed_model", 0.333, 0.344);
  mixed.estimate = {"difference", 3.28};
  mixed.standardError = 3.29;
  mixed.statistic = {"t", 3.31};
  mixed.df = 33.25;
  auto ordinal = tested("ordinal_model", 0.335, 0.345);
  ordinal.estimate = {"log_odds_ratio", 1.0};
  ordinal.standardError = 0.1;
  ordinal.statistic = {"z", 3.34};
  ordinal.effect = {"odds_ratio", 2.72};
  // 99 %: exp(1 ± 2.5758 · 0.1)
  ordinal.effectInterval = {2.1010077, 3.5169106};
  analysis::WithinComparison comparison{
      .group1 = kFirst,
      .group2 = kSecond,
      .tests = {
          pairedT(),
          tested("sign_flip", 0.319, 0.342),
          rank,
          bayesFactor(),
          equivalence(),
          mixed,
          ordinal}};
  for (auto& test : comparison.tests) {
    test.group1 = kFirst;
    test.group2 = kSecond;
  }
  return comparison;
}

analysis::WithinAnalysis withinAnalysis() {
  analysis::TestRow friedman;
  friedman.id = "friedman";
  friedman.statistic = {"chi2", 4.02};
  friedman.df = 2.0;
  friedman.p = 0.403;
  friedman.effect = {"kendall_w", 0.44};
  friedman.more = {{"p_permutation", 0.405}};
  analysis::TestRow anova;
  anova.id = "rm_anova";
  anova.statistic = {"F", 4.06};
  anova.df = 47.0;
  anova.df2 = 48.0;
  anova.p = 0.409;
  anova.effect = {"partial_eta2", 0.41};
  anova.more = {{"epsilon", 0.42}, {"p_epsilon", 0.411}};
  analysis::WithinAnalysis within{.participants = 41, .tests = 4, .overall = {friedman, anova}};
  within.mixed.fit.emplace();
  within.mixed.fit->components = {{.name = "participant", .variance = 4.13}};
  within.mixed.fit->residualVariance = 4.14;
  within.ordinal.reason = base::Message::verbatim("it was not asked for");
  analysis::TestRow probability;
  probability.id = "answer_probability";
  probability.group1 = kFirst;
  probability.n1 = 415;
  probability.statistic = {"observed_share", 0.41};
  probability.effect = {"probability", 0.42};
  probability.effectInterval = {0.43, 0.44};
  probability.more = {{"from", 4.0}};
  within.probabilities = {probability};
  within.rows = {withinComparison()};
  return within;
}

analysis::ScaleChecks checks() {
  analysis::MethodChecks method{.method = kFirst};
  method.alpha.respondents = 501;
  method.alpha.items = 52;
  method.alpha.value = 0.53;
  method.alpha.interval = {0.54, 0.55};
  method.omega.respondents = 506;
  method.omega.items = 57;
  method.omega.value = 0.58;
  method.normality.n = 509;
  method.normality.w = 0.511;
  method.normality.p = 0.512;
  analysis::ScaleChecks all{.methods = {method}};
  all.spread.f = 5.13;
  all.spread.degreesOfFreedom1 = 54.0;
  all.spread.degreesOfFreedom2 = 55.0;
  all.spread.p = 0.516;
  return all;
}

analysis::PositionEffect position() {
  analysis::PositionEffect effect;
  effect.slope.meanDifference = 6.01;
  effect.slope.standardError = 6.02;
  effect.slope.t = 6.03;
  effect.slope.degreesOfFreedom = 64.0;
  effect.slope.p = 0.605;
  effect.slopeInterval = {6.06, 6.07};
  return effect;
}

CohortResult cohortResult() {
  CohortResult result{.cohort = kCohort};
  // 1 4 4 5 5 5: mean 4, variance 2.4; and 1 2 2: mean 1.7, variance 0.3.
  result.conditions.push_back(
      {kFirst, analysis::LikertCounts(1, std::vector<std::uint64_t>{1, 0, 0, 2, 3})});
  result.conditions.push_back(
      {kSecond, analysis::LikertCounts(1, std::vector<std::uint64_t>{1, 2, 0, 0, 0})});
  result.comparisons = pooledComparisons();
  result.within = withinAnalysis();
  result.checks = checks();
  result.position = position();
  return result;
}

study::BetweenResult betweenResult() {
  study::BetweenResult result{
      .condition = kSecond, .cohort1 = kCohort, .cohort2 = "non-professional"};
  analysis::TestRow ranks;
  ranks.id = "mann_whitney";
  ranks.n1 = 701;
  ranks.n2 = 702;
  ranks.statistic = {"U", 703.5};
  ranks.p = 0.704;
  ranks.effect = {"cliff_delta", 0.71};
  ranks.effectInterval = {0.73, 0.74};
  ranks.more = {{"p_asymptotic", 0.705}};
  analysis::TestRow brunnerMunzel;
  brunnerMunzel.id = "brunner_munzel";
  brunnerMunzel.statistic = {"W", 7.07};
  brunnerMunzel.p = 0.708;
  brunnerMunzel.more = {{"probability", 0.706}};
  result.tests = {ranks, brunnerMunzel};
  return result;
}

study::VoteResult voteResult() {
  analysis::VoteCounts votes({"interpolation", "finite-elements", "kalman"});
  votes.add("interpolation", 81);
  votes.add("finite-elements", 82);
  votes.add("kalman", 83);
  study::VoteResult result{
      .cohort = kCohort, .phase = "preference-1", .block = "round-1", .votes = votes};
  result.test.exactP = 0.804;
  result.test.p = 0.805;
  result.intervals = {
      analysis::Interval{0.11, 0.12},
      analysis::Interval{0.13, 0.14},
      analysis::Interval{0.15, 0.16}};
  return result;
}

questionnaires::Instrument scoredInstrument() {
  questionnaires::Instrument instrument{.id = "scored", .version = "1"};
  instrument.title = inEnglish("Scored");
  questionnaires::Item item{.id = "ease"};
  item.text = inEnglish("It was easy.");
  instrument.items = {item};
  questionnaires::Score score{.id = "total"};
  score.title = inEnglish("Total");
  instrument.scores = {score};
  return instrument;
}

study::InstrumentSummary instrumentSummary() {
  study::InstrumentSummary summary{.instrument = "scored"};
  summary.scores = {
      {.score = "total",
       .cohort = kCohort,
       .condition = "kalman",
       .occasion = "",
       .values = {1.0, 2.0, 3.0},
       .missing = 91,
       .mean = 9.02,
       .standardDeviation = 9.03,
       .interval = analysis::Interval{9.04, 9.05}}};
  summary.acceptable = {
      {.cohort = kCohort,
       .condition = "kalman",
       .item =
           {.itemId = "ease",
            .acceptableFrom = 9.5,
            .acceptable = 96,
            .answered = 97,
            .share = 0.21},
       .interval = analysis::Interval{0.22, 0.23}}};
  return summary;
}

/// Two curves that differ by 3 N over all samples, and by 1 N, 2 N and 4.5 N for three
/// participants.
std::vector<study::RenderedForceCurve> renderedForceCurves() {
  const auto curve = [](const char* condition, double force, const std::vector<double>& own) {
    study::RenderedForceCurve made{
        .condition = condition, .device = "punch", .trials = 4, .points = {}};
    for (const int bin : {1, 2}) {
      made.points.push_back({1.0 * bin, force - 0.5, force, force + 0.5, bin});
    }
    for (std::size_t i = 0; i < own.size(); ++i) {
      made.medians["P" + std::to_string(i)] = {{1, own[i]}, {2, own[i]}};
    }
    return made;
  };
  auto first = curve(kFirst, 7.0, {5.0, 6.0, 8.5});
  first.intended = {5.75, 5.75};
  return {first, curve(kSecond, 4.0, {4.0, 4.0, 4.0})};
}

}  // namespace

study::report::ReportSection numberedSection() {
  const auto loaded = libraryProtocol("punch-face-validity");
  study::report::ReportSection section;
  section.protocol = loaded.protocol;
  section.instruments = loaded.instruments;
  section.instruments.push_back(scoredInstrument());
  section.results.runMode = study::RunMode::Live;
  section.results.flow = {
      {.cohort = kCohort,
       .enrolled = 11,
       .completed = 12,
       .inProgress = 13,
       .declined = 14,
       .withdrawn = 15,
       .rejected = 16,
       .abortedHardware = 17,
       .erased = 18}};
  auto family = loaded.protocol.analysis.families.front();
  family.alpha = 0.01;
  family.test = protocols::TestType::SignedRank;
  family.correction = protocols::CorrectionType::Holm;
  section.results.families = {
      {.family = family,
       .isDeclared = true,
       .cohorts = {cohortResult()},
       .between = {betweenResult()}}};
  section.results.votes = {voteResult()};
  section.results.instruments = {instrumentSummary()};
  section.curves = renderedForceCurves();
  section.quality = {
      .trials = 101,
      .optionalTrials = 102,
      .pass = 103,
      .warn = 104,
      .fail = 105,
      .cuts = 106,
      .saturated = 10.7,
      .contact = 10.8};
  section.quality.worstLateness = 109.0;
  return section;
}

analysis::SiteAnalysis numberedSites() {
  analysis::SiteDifference graz{
      .site = "Graz", .test = {}, .interval = {{8.07, 8.08}}, .weight = 0.09};
  graz.test.n = 801;
  graz.test.meanDifference = 8.02;
  graz.test.standardError = 8.03;
  graz.test.t = 8.04;
  graz.test.degreesOfFreedom = 8.05;
  graz.test.p = 0.806;
  analysis::MetaAnalysis pooled{.sites = 84, .q = 8.11, .heterogeneityP = 0.812};
  pooled.common = {.estimate = 8.13, .interval = {8.14, 8.15}, .p = 0.816};
  pooled.derSimonianLaird = {
      .estimate = 8.17, .interval = {8.18, 8.19}, .p = 0.821, .tauSquared = 8.22};
  pooled.reml = {
      .estimate = 8.23, .interval = {8.24, 8.25}, .p = 0.826, .tauSquared = 8.27, .iSquared = 0.28};
  pooled.knappHartung = {
      .estimate = 8.29,
      .standardError = 8.31,
      .interval = {8.32, 8.33},
      .statistic = 8.34,
      .df = 8.35,
      .p = 0.836,
      .iSquared = 0.37};
  analysis::SiteComparison comparison{.group1 = kFirst, .group2 = kSecond, .sites = {graz}};
  comparison.pooled = pooled;
  comparison.leaveOneOut = {
      {.site = "Graz",
       .pooled = {
           .estimate = 8.38,
           .interval = {8.39, 8.41},
           .p = 0.842,
           .tauSquared = 8.43,
           .iSquared = 0.44}}};
  comparison.fixedSites.estimate = {"difference", 8.45};
  comparison.fixedSites.interval = {8.46, 8.47};
  comparison.fixedSites.p = 0.848;
  comparison.randomSites.estimate = {"difference", 8.49};
  comparison.randomSites.interval = {8.51, 8.52};
  comparison.randomSites.p = 0.853;
  analysis::SiteAnalysis sites;
  sites.answers = {
      {.site = "Graz",
       .participants = 85,
       .methods = {analysis::LikertCounts(1, std::vector<std::uint64_t>{1, 0, 0, 2, 3})}}};
  sites.rows = {comparison};
  return sites;
}

}  // namespace tests
