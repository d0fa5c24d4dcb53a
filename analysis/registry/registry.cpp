#include "analysis/registry/registry.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

#include "analysis/data/csv_table.h"
#include "analysis/models/cluster_robust.h"
#include "analysis/models/cumulative_link_mixed_model.h"
#include "analysis/numerics/exact_arithmetic.h"
#include "analysis/registry/test_rows.h"

namespace analysis {
namespace {

using Rows = std::vector<TestRow>;
using Numbers = std::vector<double>;

// Two groups

const Numbers& first(const TestData& data) {
  return data.values.at(0).values;
}
const Numbers& second(const TestData& data) {
  return data.values.at(1).values;
}

TestRow welchRow(const TestData& data, const TestSettings& settings) {
  const auto result = welchTTest(first(data), second(data));
  return rowOf(result, confidenceInterval(result, settings.level));
}

/// Adds the effect sizes that both t-tests of two groups report.
/// @param corrected  whether to use the small-sample correction
void addEffects(
    TestRow& row,
    const MeanEffects& effects,
    std::string_view name,
    const EffectSize& corrected,
    const NamedNumber& uncorrected) {
  row.effect = {name, corrected.value};
  row.effectInterval = corrected.interval;
  row.more = {
      uncorrected,
      {"glass_delta1", effects.glassDelta1},
      {"glass_delta2", effects.glassDelta2},
      {"common_language", effects.commonLanguageEffectSize}};
  if (row.reason.empty()) row.reason = effects.reason;
}

Rows welch(const TestData& data, const TestSettings& settings) {
  auto row = welchRow(data, settings);
  const auto effects = effectSizes(first(data), second(data), settings.level);
  addEffects(
      row, effects, "hedges_g_av", effects.hedgesGAv, {"cohen_d_av", effects.cohenDAv.value});
  return {row};
}

Rows student(const TestData& data, const TestSettings& settings) {
  // Means, difference and the reason for missing numbers are those of Welch's test.
  auto row = welchRow(data, settings);
  const auto result = rowOf(studentTTest(first(data), second(data)));
  row.standardError = row.log10P = std::nullopt;
  row.interval = std::nullopt;
  row.statistic = result.statistic;
  row.df = result.df;
  row.p = result.p;
  const auto effects = effectSizes(first(data), second(data), settings.level);
  addEffects(row, effects, "hedges_g", effects.hedgesG, {"cohen_d", effects.cohenD.value});
  return {row};
}

Rows mannWhitney(const TestData& data, const TestSettings& settings) {
  return {rowOf(
      mannWhitneyTest(first(data), second(data)),
      cliffDelta(first(data), second(data), settings.level))};
}

Rows brunnerMunzel(const TestData& data, const TestSettings&) {
  return {rowOf(brunnerMunzelTest(first(data), second(data)))};
}

EquivalenceBounds boundsOf(const TestSettings& settings) {
  return {.lower = -settings.bound.value(), .upper = settings.bound.value()};
}

Rows equivalenceOfGroups(const TestData& data, const TestSettings& settings) {
  const auto result = welchTTest(first(data), second(data));
  return {rowOf(equivalenceTest(result, boundsOf(settings)), result)};
}

Rows bayesFactorOfGroups(const TestData& data, const TestSettings&) {
  const auto n1 = first(data).size();
  const auto n2 = second(data).size();
  auto row = rowOf(jzsBayesFactor(studentTTest(first(data), second(data)), n1, n2), n1);
  row.n2 = n2;
  return {row};
}

// Several groups

std::vector<Numbers> groupsOf(const TestData& data) {
  std::vector<Numbers> groups;
  for (const auto& group : data.values) groups.push_back(group.values);
  return groups;
}

template <auto kTest>
Rows rowsOfGroups(const TestData& data, const TestSettings&) {
  return {rowOf(kTest(groupsOf(data)))};
}

OneWayAnovaResult anova(const std::vector<Numbers>& groups) {
  return oneWayAnova(groups);
}

Rows shapiroWilk(const TestData& data, const TestSettings&) {
  return {rowOf(shapiroWilkTest(first(data)))};
}

// Pairs

Numbers differencesOf(const TestData& data) {
  Numbers differences;
  for (std::size_t i = 0; i < first(data).size(); ++i) {
    differences.push_back(first(data)[i] - second(data)[i]);
  }
  return withoutRoundingNoise(differences);
}

Rows pairedT(const TestData& data, const TestSettings& settings) {
  const auto result = pairedTTest(first(data), second(data));
  auto row = rowOf(
      result, confidenceInterval(result, settings.level), effectSizes(result, settings.level));
  if (settings.adjustedLevel) {
    row.adjustedInterval = confidenceInterval(result, *settings.adjustedLevel);
  }
  const auto summary1 = summarise(first(data));
  const auto summary2 = summarise(second(data));
  row.moments = {{{summary1.mean, summary1.variance}, {summary2.mean, summary2.variance}}};
  return {row};
}

Rows signFlip(const TestData& data, const TestSettings&) {
  return {rowOf(signFlipTest(differencesOf(data)))};
}

template <ZeroTreatment kZeros>
Rows signedRank(const TestData& data, const TestSettings&) {
  const auto differences = differencesOf(data);
  return {rowOf(signedRankTest(differences, kZeros), hodgesLehmann(differences))};
}

Rows sign(const TestData& data, const TestSettings&) {
  return {rowOf(signTest(differencesOf(data)))};
}

Rows equivalenceOfPairs(const TestData& data, const TestSettings& settings) {
  const auto result = pairedTTest(first(data), second(data));
  return {rowOf(equivalenceTest(result, boundsOf(settings)), result)};
}

Rows bayesFactorOfPairs(const TestData& data, const TestSettings&) {
  const auto result = pairedTTest(first(data), second(data));
  return {rowOf(jzsBayesFactor(result), result.n)};
}

// One line per participant

template <auto kTest>
Rows rowsOfLines(const TestData& data, const TestSettings&) {
  return {rowOf(kTest(data.lines()))};
}

/// Comparisons of all pairs of columns after Friedman's test.
Rows rankComparisons(const TestData& data, TestRow (*rowOfPair)(const RankComparison&)) {
  const auto result = friedmanTest(data.lines());
  Rows rows;
  for (const auto& pair : result.pairs) {
    auto& row = rows.emplace_back(rowOfPair(pair));
    row.group1 = data.values[pair.first].name;
    row.group2 = data.values[pair.second].name;
    row.n1 = result.blocks;
    row.estimate = {"mean_rank_difference", pair.meanRankDifference};
  }
  if (rows.empty()) rows.emplace_back().reason = result.reason;
  return rows;
}

Rows nemenyi(const TestData& data, const TestSettings&) {
  return rankComparisons(data, [](const RankComparison& pair) {
    TestRow row;
    row.statistic = {"q", pair.nemenyiQ};
    row.p = pair.nemenyiP;
    row.log10P = pair.nemenyiLog10P;
    return row;
  });
}

Rows conover(const TestData& data, const TestSettings&) {
  return rankComparisons(data, [](const RankComparison& pair) {
    TestRow row;
    row.statistic = {"t", pair.conoverT};
    row.df = pair.conoverDegreesOfFreedom;
    row.p = pair.conoverP;
    return row;
  });
}

Rows cochran(const TestData& data, const TestSettings&) {
  std::vector<std::vector<bool>> answers;
  for (const auto& line : data.lines()) {
    auto& row = answers.emplace_back();
    for (const double value : line) {
      if (value != 0.0 && value != 1.0)
        throw base::UserError("Cochran's Q needs 0 for no and 1 for yes");
      row.push_back(value == 1.0);
    }
  }
  return {rowOf(cochranQTest(answers))};
}

template <IntraclassCorrelation IntraclassCorrelations::*kWhich>
Rows intraclass(const TestData& data, const TestSettings& settings) {
  const auto result = intraclassCorrelations(data.lines(), settings.level);
  return {rowOf(result, result.*kWhich)};
}

Rows cronbach(const TestData& data, const TestSettings& settings) {
  return {rowOf(cronbachAlpha(data.lines(), settings.level))};
}

Rows omega(const TestData& data, const TestSettings&) {
  return {rowOf(omegaTotal(data.lines()))};
}

// Counts

Rows fisher(const TestData& data, const TestSettings&) {
  return {rowOf(fisherExactTest(contingencyTableOf(data, false).counts))};
}

Rows mcNemar(const TestData& data, const TestSettings&) {
  const auto table = contingencyTableOf(data, true);
  if (table.rows.size() != 2) {
    throw base::UserError(
        "McNemar's test compares two options, and there are " + std::to_string(table.rows.size()) +
        "; stuart_maxwell compares more");
  }
  auto row = rowOf(mcNemarTest(table.counts[0][1], table.counts[1][0]));
  row.group1 = table.rows[0];
  row.group2 = table.rows[1];
  row.n1 = table.counts[0][0] + table.counts[0][1] + table.counts[1][0] + table.counts[1][1];
  return {row};
}

Rows stuartMaxwell(const TestData& data, const TestSettings&) {
  return {rowOf(stuartMaxwellTest(contingencyTableOf(data, true).counts))};
}

Rows equalShares(const TestData& data, const TestSettings&) {
  const auto options = data.factor("value");
  VoteCounts votes(options.levels);
  for (std::size_t i = 0; i < data.counts.size(); ++i) {
    votes.add(options.levels[options.levelOfAnswer[i]], data.counts[i]);
  }
  return {rowOf(equalSharesTest(votes))};
}

// Models

constexpr const char* kGroup = "group";

/// The model value ~ group [+ round] + (1 | cluster) + (1 | cluster:group). It has the second
/// intercept only if some cluster has several values of a group. Otherwise this intercept would be
/// confounded with the residuals.
struct Design {
  FixedEffects fixed;
  std::vector<Factor> random;
};

Design designOf(const TestData& data) {
  Design design{.fixed = FixedEffects(first(data).size()), .random = {}};
  const auto group = data.factor(kGroup);
  design.fixed.add(group);
  if (const auto round = data.factor("round"); round.levels.size() > 1) design.fixed.add(round);
  design.random.push_back(data.factor("cluster"));
  auto taste = interactionOf(design.random.front(), group);
  if (taste.levels.size() < first(data).size()) design.random.push_back(std::move(taste));
  return design;
}

/// A row for each pair of groups, or one row with the reason why no pair can be tested.
template <typename RowOfPair>
Rows rowsOfGroupPairs(const Factor& group, const Reason& reasonForNone, RowOfPair rowOfPair) {
  Rows rows;
  for (std::size_t i = 0; reasonForNone.empty() && i < group.levels.size(); ++i) {
    for (std::size_t j = i + 1; j < group.levels.size(); ++j) {
      rows.push_back(rowOfPair(group.levels[i], group.levels[j]));
      rows.back().group1 = group.levels[i];
      rows.back().group2 = group.levels[j];
    }
  }
  if (rows.empty()) rows.emplace_back().reason = reasonForNone;
  return rows;
}

Rows clusterRobustRows(const TestData& data, const TestSettings& settings) {
  const auto group = data.factor(kGroup);
  const auto labels = data.names.at(1).values;
  const auto cluster = data.factor("cluster");
  const auto round = data.factor("round");
  const auto fit = [&](const std::vector<std::string>& levels) {
    FixedEffects fixed(first(data).size());
    fixed.add(factorOf(kGroup, labels, levels));
    if (round.levels.size() > 1) fixed.add(round);
    return clusterRobust(first(data), fixed, cluster);
  };
  const auto reasonForNone = fit(group.levels).reason;
  return rowsOfGroupPairs(group, reasonForNone, [&](const std::string& a, const std::string& b) {
    // With b as the base, the coefficient of a is the difference a - b.
    auto levels = group.levels;
    std::erase(levels, a);
    std::erase(levels, b);
    levels.insert(levels.begin(), {b, a});
    const auto difference = fit(levels).fixedEffects.at(1);
    auto row = rowOf(difference, first(data).size());
    row.interval = confidenceInterval(difference, settings.level);
    return row;
  });
}

Rows mixedModel(const TestData& data, const TestSettings& settings) {
  const auto design = designOf(data);
  const auto result = fitLinearMixedModel(first(data), design.fixed, design.random);
  return rowsOfGroupPairs(
      data.factor(kGroup), result.reason, [&](const std::string& a, const std::string& b) {
        const auto difference =
            contrast(*result.fit, a + " - " + b, design.fixed.difference(kGroup, a, b));
        auto row = rowOf(difference, first(data).size());
        row.interval = confidenceInterval(difference, settings.level);
        return row;
      });
}

std::vector<int> integerAnswers(const TestData& data) {
  std::vector<int> answers;
  for (const double value : first(data)) {
    if (value != std::floor(value) || std::abs(value) > std::numeric_limits<int>::max()) {
      throw base::UserError("the ordinal model needs answers on a scale of whole numbers");
    }
    answers.push_back(static_cast<int>(value));
  }
  return answers;
}

Rows ordinalModel(const TestData& data, const TestSettings& settings) {
  const auto answers = integerAnswers(data);
  const auto design = designOf(data);
  const auto result = fitCumulativeLinkMixedModel(answers, design.fixed, design.random);
  return rowsOfGroupPairs(
      data.factor(kGroup), result.reason, [&](const std::string& a, const std::string& b) {
        const auto difference =
            contrast(*result.fit, a + " - " + b, design.fixed.difference(kGroup, a, b));
        auto row = rowOf(difference, answers.size(), settings.level);
        row.interval = confidenceInterval(difference, settings.level);
        return row;
      });
}

Rows answerProbabilities(const TestData& data, const TestSettings& settings) {
  const auto answers = integerAnswers(data);
  const auto design = designOf(data);
  const auto model = fitCumulativeLinkMixedModel(answers, design.fixed, design.random);
  Rows rows;
  for (const auto& group : data.factor(kGroup).levels) {
    const HighAnswerEvent asked{.factor = kGroup, .group = group, .from = settings.from.value()};
    rows.push_back(answerProbabilityRow(model, design.fixed, answers, asked, settings.level));
  }
  return rows;
}

using Icc = IntraclassCorrelations;
using Shape = DataShape;
using Use = StudyUse;

// clang-format off
// All tests: id, title, question, source, data, function, use in a study; kNeedsBound if it needs a
// bound, kEachPair or kEachGroup if it has a row for each pair of groups or for each group; kFewestPeople if
// reports leave it out for fewer people.
constexpr auto kNeedsBound = StatisticalTest::Form::NeedsBound;
constexpr auto kEachPair = StatisticalTest::Form::RowOfEachPair;
constexpr auto kEachGroup = StatisticalTest::Form::RowOfEachGroup;
constexpr auto kOneRow = StatisticalTest::Form::OneRow;
constexpr std::size_t kFewestPeople = 5;
constexpr std::array kTests{
    StatisticalTest{"welch", "Welch's t-test", "Do two groups differ in their mean?", "Welch 1947", Shape::TwoGroups, welch},
    StatisticalTest{"student", "Student's t-test", "Do two groups of equal variance differ in their mean?", "Student 1908", Shape::TwoGroups, student},
    StatisticalTest{"mann_whitney", "Mann and Whitney's test", "Does one group tend to larger values? Exact, ties included", "Mann & Whitney 1947", Shape::TwoGroups, mannWhitney, Use::Cohorts},
    StatisticalTest{"brunner_munzel", "Brunner and Munzel's test", "Does one group tend to larger values, if the scatter may differ?", "Brunner & Munzel 2000", Shape::TwoGroups, brunnerMunzel, Use::Cohorts, kOneRow, kFewestPeople},
    StatisticalTest{"tost_groups", "Two one-sided t-tests of two groups", "Is the difference of two means within ±bound?", "Schuirmann 1987", Shape::TwoGroups, equivalenceOfGroups, Use::None, kNeedsBound},
    StatisticalTest{"bayes_factor_groups", "JZS Bayes factor of two groups", "How much do the data speak for a difference of two means?", "Rouder et al. 2009", Shape::TwoGroups, bayesFactorOfGroups},
    StatisticalTest{"one_way_anova", "One-way analysis of variance", "Do groups of equal variance differ in their mean?", "Fisher 1925", Shape::Groups, rowsOfGroups<anova>},
    StatisticalTest{"brown_forsythe", "Brown and Forsythe's test", "Do groups differ in their spread about the median?", "Brown & Forsythe 1974", Shape::Groups, rowsOfGroups<brownForsytheTest>},
    StatisticalTest{"shapiro_wilk", "Shapiro and Wilk's test", "Could the values come from a normal law?", "Royston 1995", Shape::Values, shapiroWilk},
    StatisticalTest{"paired_t", "Paired t-test", "Do pairs differ in their mean?", "Student 1908", Shape::Pairs, pairedT, Use::Pairs},
    StatisticalTest{"sign_flip", "Exact sign-flip test", "Do pairs differ in their mean? All choices of signs", "Fisher 1935", Shape::Pairs, signFlip, Use::Pairs},
    StatisticalTest{"signed_rank", "Wilcoxon's signed rank test", "Are differences as likely up as down? Exact, zeros dropped", "Wilcoxon 1945", Shape::Pairs, signedRank<ZeroTreatment::Dropped>, Use::Pairs},
    StatisticalTest{"signed_rank_pratt", "Signed rank test with Pratt's zeros", "The same, zeros ranked and then dropped", "Pratt 1959", Shape::Pairs, signedRank<ZeroTreatment::RankedThenDropped>},
    StatisticalTest{"sign_test", "Sign test", "Are there more differences up than down? Exact", "Arbuthnott 1710", Shape::Pairs, sign},
    StatisticalTest{"bayes_factor", "JZS Bayes factor of pairs", "How much do the data speak for a mean difference?", "Rouder et al. 2009", Shape::Pairs, bayesFactorOfPairs, Use::PairsOutsideFamily},
    StatisticalTest{"tost", "Two one-sided t-tests of pairs", "Is the mean difference within ±bound?", "Schuirmann 1987", Shape::Pairs, equivalenceOfPairs, Use::PairsOutsideFamily, kNeedsBound},
    StatisticalTest{"friedman", "Friedman's test", "Do conditions differ, if every participant ranks them?", "Friedman 1937", Shape::Columns, rowsOfLines<friedmanTest>, Use::Conditions},
    StatisticalTest{"nemenyi", "Nemenyi's comparisons", "Which conditions differ after Friedman's test? p holds for all pairs", "Nemenyi 1963", Shape::Columns, nemenyi, Use::None, kEachPair},
    StatisticalTest{"conover", "Conover's comparisons", "Which conditions differ after Friedman's test? p of each pair alone", "Conover 1999", Shape::Columns, conover, Use::None, kEachPair},
    StatisticalTest{"rm_anova", "Repeated-measures analysis of variance", "Do conditions differ in their mean, all judged by the same people?", "Greenhouse & Geisser 1959", Shape::Columns, rowsOfLines<repeatedMeasuresAnova>, Use::Conditions},
    StatisticalTest{"cochran_q", "Cochran's Q", "Do options get as many yes (1) of the same people?", "Cochran 1950", Shape::Columns, cochran},
    StatisticalTest{"icc_1_1", "Intraclass correlation ICC(1,1)", "How alike are ratings of a subject, raters differing between subjects?", "Shrout & Fleiss 1979", Shape::Columns, intraclass<&Icc::oneWaySingle>},
    StatisticalTest{"icc_1_k", "Intraclass correlation ICC(1,k)", "The same of the mean of all ratings", "Shrout & Fleiss 1979", Shape::Columns, intraclass<&Icc::oneWayAverage>},
    StatisticalTest{"icc_2_1", "Intraclass correlation ICC(2,1)", "How far do raters agree, drawn at random from many?", "Shrout & Fleiss 1979", Shape::Columns, intraclass<&Icc::twoWayRandomSingle>},
    StatisticalTest{"icc_2_k", "Intraclass correlation ICC(2,k)", "The same of the mean of all raters", "Shrout & Fleiss 1979", Shape::Columns, intraclass<&Icc::twoWayRandomAverage>},
    StatisticalTest{"icc_3_1", "Intraclass correlation ICC(3,1)", "How consistent are these raters?", "Shrout & Fleiss 1979", Shape::Columns, intraclass<&Icc::twoWayMixedSingle>},
    StatisticalTest{"icc_3_k", "Intraclass correlation ICC(3,k)", "The same of the mean of these raters", "Shrout & Fleiss 1979", Shape::Columns, intraclass<&Icc::twoWayMixedAverage>},
    StatisticalTest{"cronbach_alpha", "Cronbach's alpha", "Do the items of a scale pull together?", "Cronbach 1951, Feldt 1965", Shape::Columns, cronbach, Use::None, kOneRow, kFewestPeople},
    StatisticalTest{"omega_total", "McDonald's omega", "How much of a sum of items do they have in common?", "McDonald 1999", Shape::Columns, omega, Use::None, kOneRow, kFewestPeople},
    StatisticalTest{"fisher_exact", "Fisher's exact test", "Do two sortings of the same cases have to do with each other?", "Fisher 1935, Freeman & Halton 1951", Shape::Categories, fisher},
    StatisticalTest{"mcnemar", "McNemar's test", "Do people change from one of two options as often as to it? Exact", "McNemar 1947", Shape::BeforeAfter, mcNemar},
    StatisticalTest{"stuart_maxwell", "Stuart and Maxwell's test", "Are options chosen as often the second time as the first?", "Stuart 1955, Maxwell 1970", Shape::BeforeAfter, stuartMaxwell},
    StatisticalTest{"equal_shares", "Exact multinomial test of equal shares", "Are options preferred equally often?", "Tate & Hyer 1973", Shape::Votes, equalShares},
    StatisticalTest{"cluster_robust", "Cluster-robust t-tests (CR2)", "Do groups differ in their mean, if values of a cluster go together?", "Bell & McCaffrey 2002", Shape::Clusters, clusterRobustRows, Use::None, kEachPair},
    StatisticalTest{"mixed_model", "Linear mixed model", "The same with random intercepts of clusters", "Bates et al. 2015, Kuznetsova et al. 2017", Shape::Clusters, mixedModel, Use::None, kEachPair},
    StatisticalTest{"ordinal_model", "Cumulative link mixed model", "The same of ordered answers, as odds ratios", "Christensen 2022", Shape::Clusters, ordinalModel, Use::None, kEachPair, kFewestPeople},
    StatisticalTest{"answer_probability", "Probability of a high answer, by the cumulative link mixed model", "How likely is an answer of --from or more, in all clusters?", "Christensen 2022", Shape::Clusters, answerProbabilities, Use::None, kEachGroup},
};
// clang-format on

}  // namespace

std::span<const StatisticalTest> statisticalTests() noexcept {
  return kTests;
}

const StatisticalTest& statisticalTest(std::string_view id) {
  const auto found = std::ranges::find(kTests, id, &StatisticalTest::id);
  if (found != kTests.end()) return *found;
  std::vector<std::string> ids;
  for (const auto& test : kTests) ids.emplace_back(test.id);
  const auto nearest = nearestName(id, ids);
  throw base::UserError(
      "There is no test '" + std::string(id) + "'" +
      (nearest ? "; did you mean '" + *nearest + "'?" : std::string(".")) +
      " 'palpate stats test --list' lists all.");
}

std::vector<TestRow> computeTest(
    const StatisticalTest& test, const TestData& data, const TestSettings& settings) {
  const bool needsBound = test.form == StatisticalTest::Form::NeedsBound;
  if (needsBound && !settings.bound) {
    throw base::UserError(
        "the test needs --bound: differences between -bound and +bound count as none; it belongs "
        "to the plan of the study");
  }
  if (!needsBound && settings.bound) throw base::UserError("the test does not use --bound");
  const bool needsFrom = test.form == StatisticalTest::Form::RowOfEachGroup;
  if (needsFrom && !settings.from) {
    throw base::UserError(
        "the test needs --from: it tells how likely this answer and all above it are");
  }
  if (!needsFrom && settings.from) throw base::UserError("the test does not use --from");
  Rows rows;
  try {
    rows = test.rows(data, settings);
  } catch (const std::invalid_argument& error) {
    throw base::UserError(error.what());
  }
  const bool comparesTwo = test.shape == Shape::TwoGroups || test.shape == Shape::Pairs;
  for (auto& row : rows) {
    row.id = test.id;
    if (!comparesTwo) continue;
    row.group1 = data.values.at(0).name;
    row.group2 = data.values.at(1).name;
  }
  return rows;
}

}  // namespace analysis
