#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "analysis/models/linear_mixed_model.h"

namespace linear_mixed_model_undefined_test {

using analysis::Factor;
using analysis::FixedEffects;

const std::vector<std::string> kMethod{"a", "b", "a", "b", "a", "b", "a", "b"};
const std::vector<std::string> kPerson{"1", "1", "1", "1", "2", "2", "2", "2"};
const std::vector<double> kScores{1, 3, 2, 4, 3, 5, 2, 5};

FixedEffects methods() {
  FixedEffects fixed(kMethod.size());
  fixed.add(analysis::factorOf("method", kMethod));
  return fixed;
}

analysis::Reason reasonOf(
    const std::vector<double>& y, const FixedEffects& fixed, const std::vector<Factor>& random) {
  const auto result = analysis::fitLinearMixedModel(y, fixed, random);
  EXPECT_FALSE(result.fit.has_value());
  return result.reason;
}

TEST(LinearMixedModelUndefined, ForOneParticipant) {
  const std::vector<std::string> alone(8, "1");
  const auto why = reasonOf(kScores, methods(), {analysis::factorOf("participant", alone)});
  EXPECT_EQ(why, analysis::reason("one_random_level", "participant"));
}

TEST(LinearMixedModelUndefined, ForOneMethod) {
  FixedEffects fixed(8);
  fixed.add(analysis::factorOf("method", std::vector<std::string>(8, "a")));
  const auto why = reasonOf(kScores, fixed, {analysis::factorOf("participant", kPerson)});
  EXPECT_EQ(why, analysis::reason("one_level", "method"));
}

TEST(LinearMixedModelUndefined, ForConstantAnswers) {
  const auto why = reasonOf(
      std::vector<double>(8, 3.7), methods(), {analysis::factorOf("participant", kPerson)});
  EXPECT_EQ(why, analysis::reason("no_spread_beyond_fixed"));
}

TEST(LinearMixedModelUndefined, ForAnswersThatTheMethodsExplain) {
  const auto why =
      reasonOf({1, 2, 1, 2, 1, 2, 1, 2}, methods(), {analysis::factorOf("participant", kPerson)});
  EXPECT_EQ(why, analysis::reason("no_spread_beyond_fixed"));
}

TEST(LinearMixedModelUndefined, WithoutResidualVariance) {
  const auto why =
      reasonOf({1, 2, 1, 2, 3, 4, 3, 4}, methods(), {analysis::factorOf("participant", kPerson)});
  EXPECT_EQ(why, analysis::reason("variances_not_estimated"));
}

TEST(LinearMixedModelUndefined, ForAFactorThatIsFixedAndRandom) {
  const auto why = reasonOf(kScores, methods(), {analysis::factorOf("method", kMethod)});
  EXPECT_EQ(why, analysis::reason("nothing_left_of_intercept", "method"));
}

TEST(LinearMixedModelUndefined, ForTwoFactorsWithTheSameGroups) {
  auto hospital = analysis::factorOf("hospital", kPerson);
  const auto why =
      reasonOf(kScores, methods(), {analysis::factorOf("participant", kPerson), hospital});
  EXPECT_EQ(why, analysis::reason("same_grouping", "participant", "hospital"));
}

TEST(LinearMixedModelUndefined, ForALevelPerAnswer) {
  const std::vector<std::string> each{"1", "2", "3", "4", "5", "6", "7", "8"};
  const auto why = reasonOf(kScores, methods(), {analysis::factorOf("answer", each)});
  EXPECT_EQ(why, analysis::reason("as_many_levels", "answer"));
}

TEST(LinearMixedModelUndefined, ForLinearlyDependentColumns) {
  // Each method in one round only.
  auto fixed = methods();
  fixed.add(analysis::factorOf(
      "round", std::vector<std::string>{"1", "2", "1", "2", "1", "2", "1", "2"}));
  const auto why = reasonOf(kScores, fixed, {analysis::factorOf("participant", kPerson)});
  EXPECT_EQ(why, analysis::reason("dependent_effect", "round 2"));
}

TEST(LinearMixedModelUndefined, ForTooFewAnswers) {
  const auto why = reasonOf({}, FixedEffects(0), {});
  EXPECT_EQ(why, analysis::reason("too_few_answers", 0, 1));
}

TEST(LinearMixedModelUndefined, GivesAReasonForMissingDegreesOfFreedom) {
  // Two participants: their spread has one degree of freedom, and the mean less than two.
  const auto result = analysis::fitLinearMixedModel(
      kScores, methods(), {{analysis::factorOf("participant", kPerson)}});
  for (const auto& effect : result.fit.value().fixedEffects) {
    EXPECT_EQ(effect.p.has_value(), effect.reason.empty());
    EXPECT_TRUE(!effect.p || std::isfinite(*effect.p));
  }
}

TEST(LinearMixedModelUndefined, ThrowsForInvalidArguments) {
  const std::vector<Factor> random{analysis::factorOf("participant", kPerson)};
  const std::vector<double> short1{1, 2};
  auto infinite = kScores;
  infinite[3] = std::numeric_limits<double>::infinity();
  EXPECT_THROW(analysis::fitLinearMixedModel(short1, methods(), random), std::invalid_argument);
  EXPECT_THROW(analysis::fitLinearMixedModel(infinite, methods(), random), std::invalid_argument);
  EXPECT_THROW(
      analysis::fitLinearMixedModel(std::vector<double>{1, 2}, FixedEffects(2), random),
      std::invalid_argument);
}

}  // namespace linear_mixed_model_undefined_test
