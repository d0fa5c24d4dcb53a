#include "analysis/models/answer_probability.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/analysis/digits.h"
#include "tests/analysis/golden_file.h"
#include "tests/analysis/study_answers.h"
#include "tests/support/test_data.h"

namespace answer_probability_test {

using analysis::AnswerProbability;
using analysis::CumulativeLinkFit;
using analysis::Factor;
using analysis::FixedEffects;

struct Model {
  FixedEffects fixed;
  CumulativeLinkFit fit;

  std::optional<AnswerProbability> of(const std::string& group, int level) const {
    return answerProbability(fit, level, fixed.combinations("method", group));
  }
};

Model fitted(std::span<const int> y, FixedEffects fixed, std::span<const Factor> random) {
  auto result = analysis::fitCumulativeLinkMixedModel(y, fixed, random);
  if (!result.fit) throw std::logic_error(base::describe(result.reason));
  return {std::move(fixed), *std::move(result.fit)};
}

// Two groups of yes (1) and no (0) without intercepts are a saturated model: its probabilities are
// the shares p, and the standard error of their logits is 1 / √(n p (1 − p)).
TEST(AnswerProbability, IsTheShareOfASaturatedModel) {
  std::vector<int> y;
  std::vector<std::string> groups;
  const auto give = [&](const char* group, int times, int answer) {
    for (int i = 0; i < times; ++i) {
      groups.emplace_back(group);
      y.push_back(answer);
    }
  };
  give("a", 13, 1);
  give("a", 7, 0);
  give("b", 4, 1);
  give("b", 21, 0);
  FixedEffects fixed(y.size());
  fixed.add(analysis::factorOf("method", groups));
  const auto model = fitted(y, fixed, {});
  for (const auto& [group, n, p] : {std::tuple("a", 20.0, 0.65), std::tuple("b", 25.0, 0.16)}) {
    const auto found = model.of(group, 1).value();
    EXPECT_NEAR(found.probability, p, 1e-12);
    EXPECT_NEAR(found.logit.estimate, std::log(p / (1.0 - p)), 1e-11);
    EXPECT_NEAR(found.logit.standardError, 1.0 / std::sqrt(n * p * (1.0 - p)), 1e-9);
    const auto interval = probabilityInterval(found, 0.95);
    const double odds = p / (1.0 - p);
    const double factor = std::exp(1.959963984540054 / std::sqrt(n * p * (1.0 - p)));
    EXPECT_NEAR(interval.low, odds / factor / (1.0 + odds / factor), 1e-9);
    EXPECT_NEAR(interval.high, odds * factor / (1.0 + odds * factor), 1e-9);
  }
}

/// A model without fixed effects, of answers 1, 2 and 4, whose parameters are known exactly.
CumulativeLinkFit known(double threshold, double deviation) {
  CumulativeLinkFit fit;
  fit.levels = {1, 2, 4};
  fit.thresholds = {
      analysis::waldEstimate("1|2", threshold - 1.0, 0.0),
      analysis::waldEstimate("2|4", threshold, 0.0)};
  fit.components = {
      {.name = "participant", .variance = 0.36 * deviation * deviation},
      {.name = "participant:method", .variance = 0.64 * deviation * deviation}};
  for (auto& component : fit.components)
    component.standardDeviation = std::sqrt(component.variance);
  fit.covariance.assign(16, 0.0);
  return fit;
}

const std::vector<std::vector<double>> kIntercept{{1.0}};

// R: integrate(function(u) plogis(a + s * u) * dnorm(u), -Inf, Inf, rel.tol = 1e-13)
TEST(AnswerProbability, IsTheMeanOverTheRandomIntercepts) {
  const auto at = [](double threshold, double deviation) {
    return answerProbability(known(threshold, deviation), 4, kIntercept).value().probability;
  };
  EXPECT_NEAR(at(-1.0, 0.0), 0.7310585786300049, 1e-14);
  EXPECT_NEAR(at(-1.0, 2.0), 0.6477264385258688, 1e-12);
  EXPECT_NEAR(at(0.7, 5.0), 0.4475511332663446, 1e-12);
  EXPECT_NEAR(at(-2.5, 0.8), 0.9050383294507875, 1e-12);
  EXPECT_NEAR(at(0.0, 30.0), 0.5, 1e-13);
  EXPECT_NEAR(at(0.7, 5.0) + at(-0.7, 5.0), 1.0, 1e-13);
}

TEST(AnswerProbability, UsesTheNextLevelAboveIfALevelHasNoAnswers) {
  const auto fit = known(0.3, 1.0);
  const auto probability = [&](int level) { return answerProbability(fit, level, kIntercept); };
  EXPECT_EQ(probability(3).value().probability, probability(4).value().probability);
  EXPECT_GT(probability(2).value().probability, probability(3).value().probability);
  EXPECT_FALSE(probability(1));
  EXPECT_FALSE(probability(5));
}

TEST(AnswerProbability, RefusesDesignsOfAnotherModel) {
  const auto fit = known(0.0, 1.0);
  EXPECT_THROW(answerProbability(fit, 4, {}), std::invalid_argument);
  const std::vector<std::vector<double>> wide{{1.0, 0.0}};
  EXPECT_THROW(answerProbability(fit, 4, wide), std::invalid_argument);
}

class StudyProbability : public testing::TestWithParam<std::pair<const char*, const char*>> {
 protected:
  static void check(const Model& model, const nlohmann::json& golden, double gate) {
    ASSERT_EQ(golden.size(), 3U);
    for (const auto& truth : golden) {
      const auto method = truth["method"].get<std::string>();
      SCOPED_TRACE(method);
      const auto found = model.of(method, 4).value();
      const auto digits = [&](double number, const char* key) {
        return tests::correctDigits(number, truth[key].get<std::string>());
      };
      EXPECT_GE(digits(found.logit.estimate, "logit"), gate) << found.logit.estimate;
      EXPECT_GE(digits(found.logit.standardError, "SE"), std::min(gate, 2.6))
          << found.logit.standardError;
      if (!truth.contains("probability")) continue;
      const auto interval = probabilityInterval(found, 0.95);
      EXPECT_NEAR(found.probability, std::stod(truth["probability"].get<std::string>()), 1e-3);
      EXPECT_NEAR(interval.low, std::stod(truth["low"].get<std::string>()), 2e-3);
      EXPECT_NEAR(interval.high, std::stod(truth["high"].get<std::string>()), 2e-3);
    }
  }
};

// R: ordinal::clm and emmeans, at the cut 3|4
TEST_P(StudyProbability, MatchesTheReferenceWithoutRandomIntercepts) {
  const auto answers = tests::studyAnswers(GetParam().first);
  FixedEffects fixed(answers.scores.size());
  fixed.add(answers.method);
  const auto golden = tests::statsJson("study/study_golden.json");
  check(
      fitted(answers.levels(), fixed, {}),
      golden["clm_" + std::string(GetParam().second) + "_from_4"],
      6.0);
}

// R: ordinal::clmm, integrate() and numDeriv::grad()
TEST_P(StudyProbability, MatchesTheReferenceWithRandomIntercepts) {
  const auto answers = tests::studyAnswers(GetParam().first);
  FixedEffects fixed(answers.scores.size());
  fixed.add(answers.method);
  fixed.add(answers.round);
  const std::vector<Factor> random{
      answers.participant, interactionOf(answers.participant, answers.method)};
  const auto golden = tests::statsJson("study/study_golden.json");
  check(
      fitted(answers.levels(), fixed, random),
      golden["clmm_" + std::string(GetParam().second) + "_from_4"],
      3.0);
}

INSTANTIATE_TEST_SUITE_P(
    AnswerProbability,
    StudyProbability,
    testing::Values(std::pair("professional", "prof"), std::pair("non-professional", "non")));

}  // namespace answer_probability_test
