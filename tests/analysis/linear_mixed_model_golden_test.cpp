#include <cmath>
#include <map>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "analysis/models/linear_mixed_model.h"
#include "tests/analysis/digits.h"
#include "tests/analysis/golden_file.h"
#include "tests/analysis/study_answers.h"
#include "tests/support/test_data.h"

namespace linear_mixed_model_golden_test {

using analysis::Factor;
using analysis::FixedEffects;
using analysis::LinearMixedFit;
using analysis::TEstimate;

/// Scores of the study's cohort ~ method + round + (1 | participant) + (1 | participant:method).
struct StudyModel {
  explicit StudyModel(const std::string& cohort)
      : answers(tests::studyAnswers(cohort)), fixed(answers.scores.size()) {
    fixed.add(answers.method);
    fixed.add(answers.round);
    const std::vector<Factor> random{
        answers.participant, interactionOf(answers.participant, answers.method)};
    fit = analysis::fitLinearMixedModel(answers.scores, fixed, random).fit.value();
  }

  tests::StudyAnswers answers;
  FixedEffects fixed;
  LinearMixedFit fit;
};

/// The sum of n · mean² over the levels of a factor; over all answers where it has none.
double squaresOf(const Factor& factor, const std::vector<double>& scores) {
  std::map<std::size_t, std::pair<double, double>> sums;
  for (std::size_t i = 0; i < scores.size(); ++i) {
    auto& [sum, count] = sums[factor.levels.empty() ? 0 : factor.levelOfAnswer[i]];
    sum += scores[i];
    count += 1.0;
  }
  double squares = 0.0;
  for (const auto& entry : sums)
    squares += entry.second.first * entry.second.first / entry.second.second;
  return squares;
}

/// What lme4 and lmerTest say. Their optimiser stops some 1e-6 beside the minimum, which is known
/// exactly for these balanced data (EqualsTheAnalysisOfVariance): SE and t agree to 5.8 digits, the
/// variances to 5.2, df and p to 5.3 and 4.3, and no number of ours can agree to more.
class StudyGolden : public testing::TestWithParam<std::pair<const char*, const char*>> {
 protected:
  static void check(const char* what, double number, const std::string& truth, double gate) {
    const double digits = tests::correctDigits(number, truth);
    EXPECT_GE(digits, gate) << what << ": " << number << " is not " << truth;
  }

  static void check(const TEstimate& estimate, const nlohmann::json& golden, const char* p) {
    SCOPED_TRACE(estimate.name);
    const bool isCoefficient = golden.contains("Estimate");
    const auto text = [&](const char* key) { return golden[key].get<std::string>(); };
    check("estimate", estimate.estimate, text(isCoefficient ? "Estimate" : "estimate"), 12.0);
    check("SE", estimate.standardError, text(isCoefficient ? "Std..Error" : "SE"), 5.8);
    check("t", estimate.t.value(), text(isCoefficient ? "t.value" : "t"), 5.8);
    check("df", estimate.degreesOfFreedom.value(), text("df"), 5.3);
    if (p != nullptr) check("p", estimate.p.value(), text(p), 4.3);
  }
};

TEST_P(StudyGolden, FixedEffectsMatchTheReference) {
  const StudyModel model(GetParam().first);
  const std::string key = GetParam().second;
  const auto golden = tests::statsJson("study/study_golden.json");

  ASSERT_EQ(golden[key].size(), 4U);
  ASSERT_EQ(model.fit.fixedEffects.size(), 4U);
  for (std::size_t j = 0; j < 4; ++j) {
    check(model.fit.fixedEffects[j], golden[key].at(j), "Pr...t..");
  }
}

TEST_P(StudyGolden, VariancesAndLogLikelihoodMatchTheReference) {
  const StudyModel model(GetParam().first);
  const std::string key = GetParam().second;
  const auto golden = tests::statsJson("study/study_golden.json");
  const auto variance = [&](std::size_t row) {
    return golden[key + "_var"].at(row)["var"].get<std::string>();
  };

  check("participant:method", model.fit.components.at(1).variance, variance(0), 5.2);
  check("participant", model.fit.components.at(0).variance, variance(1), 5.2);
  check("residual", model.fit.residualVariance, variance(2), 6.0);
  const auto logLikelihood = golden[key + "_loglik_reml"].get<std::string>();
  check("log likelihood", model.fit.logLikelihood, logLikelihood, 11.0);
}

TEST_P(StudyGolden, DifferencesOfMethodsMatchTheReference) {
  const StudyModel model(GetParam().first);
  const std::string key = GetParam().second;
  const auto golden = tests::statsJson("study/study_golden.json")[key + "_pairs_holm"];
  const auto& methods = model.answers.method.levels;

  ASSERT_EQ(methods.size(), 3U);
  ASSERT_EQ(golden.size(), 3U);
  std::size_t row = 0;
  for (const auto& [first, second] : {std::pair(0U, 1U), std::pair(0U, 2U), std::pair(1U, 2U)}) {
    const std::string name = methods[first] + " - " + methods[second];
    const auto weights = model.fixed.difference("method", methods[first], methods[second]);
    EXPECT_EQ(name, golden.at(row)["contrast"].get<std::string>());
    check(contrast(model.fit, name, weights), golden.at(row), nullptr);  // its p are adjusted
    ++row;
  }
}

/// For balanced data without a variance at zero, the restricted estimates are those of the analysis
/// of variance, and Satterthwaite's degrees of freedom those of its mean squares.
TEST_P(StudyGolden, EqualsTheAnalysisOfVariance) {
  const StudyModel model(GetParam().first);
  const auto& fit = model.fit;
  const auto people = static_cast<double>(model.answers.participant.levels.size());
  const double answers = 18.0 * people;
  const double dfPerson = people - 1.0;
  const double dfCell = 2.0 * (people - 1.0);
  const double dfResidual = answers - 3.0 * people - 1.0;
  const auto cells = interactionOf(model.answers.participant, model.answers.method);
  const double ofNothing = squaresOf({}, model.answers.scores);
  const double ofPeople = squaresOf(model.answers.participant, model.answers.scores);
  const double ofMethods = squaresOf(model.answers.method, model.answers.scores);
  const double ofRounds = squaresOf(model.answers.round, model.answers.scores);
  const double ofCells = squaresOf(cells, model.answers.scores);
  const double person = (ofPeople - ofNothing) / dfPerson;  // mean squares
  const double cell = (ofCells - ofPeople - ofMethods + ofNothing) / dfCell;
  double total = 0.0;
  for (const double score : model.answers.scores) total += score * score;
  const double residual = (total - ofCells - ofRounds + ofNothing) / dfResidual;

  EXPECT_NEAR(fit.residualVariance, residual, 1e-11);
  EXPECT_NEAR(fit.components[1].variance, (cell - residual) / 6.0, 1e-11);
  EXPECT_NEAR(fit.components[0].variance, (person - cell) / 18.0, 1e-11);
  const auto df = [&](std::size_t j) { return fit.fixedEffects[j].degreesOfFreedom.value(); };
  EXPECT_NEAR(df(1), dfCell, 1e-9);
  EXPECT_NEAR(df(2), dfCell, 1e-9);
  EXPECT_NEAR(df(3), dfResidual, 1e-9);
  // The intercept is a mean over participants in one method and round.
  const double a = person / answers;
  const double b = 2.0 * cell / answers;
  const double c = residual / answers;
  const double satterthwaite =
      std::pow(a + b + c, 2) / (a * a / dfPerson + b * b / dfCell + c * c / dfResidual);
  EXPECT_NEAR(std::pow(fit.fixedEffects[0].standardError, 2), a + b + c, 1e-12);
  EXPECT_NEAR(df(0), satterthwaite, 1e-9);
}

INSTANTIATE_TEST_SUITE_P(
    LinearMixedModel,
    StudyGolden,
    testing::Values(
        std::pair("professional", "lmm_prof"), std::pair("non-professional", "lmm_non")));

TEST(LinearMixedModelOfTheStudy, GivesIntervals) {
  const StudyModel model("professional");
  const auto interval = analysis::confidenceInterval(model.fit.fixedEffects[1], 0.95).value();
  // t of 10 degrees of freedom at 97.5 %: 2.228138851964939
  EXPECT_NEAR(interval.high - interval.low, 2.0 * 2.228138851964939 * 0.351218258259351, 5e-6);
  EXPECT_THROW(analysis::confidenceInterval(model.fit.fixedEffects[1], 1.0), std::invalid_argument);
  EXPECT_THROW(contrast(model.fit, "", std::vector<double>{1.0}), std::invalid_argument);
}

}  // namespace linear_mixed_model_golden_test
