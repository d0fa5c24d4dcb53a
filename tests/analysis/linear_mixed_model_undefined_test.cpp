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

std::string reasonOf(
    const std::vector<double>& y, const FixedEffects& fixed, const std::vector<Factor>& random) {
  const auto result = analysis::fitLinearMixedModel(y, fixed, random);
  EXPECT_FALSE(result.fit.has_value());
  return result.reason;
}

TEST(LinearMixedModelUndefined, ForOneParticipant) {
  const std::vector<std::string> alone(8, "1");
  const auto reason = reasonOf(kScores, methods(), {analysis::factorOf("participant", alone)});
  EXPECT_NE(reason.find("'participant' has one level only"), std::string::npos) << reason;
}

TEST(LinearMixedModelUndefined, ForOneMethod) {
  FixedEffects fixed(8);
  fixed.add(analysis::factorOf("method", std::vector<std::string>(8, "a")));
  const auto reason = reasonOf(kScores, fixed, {analysis::factorOf("participant", kPerson)});
  EXPECT_NE(reason.find("'method' has one level only"), std::string::npos) << reason;
}

TEST(LinearMixedModelUndefined, ForConstantAnswers) {
  const auto reason = reasonOf(
      std::vector<double>(8, 3.7), methods(), {analysis::factorOf("participant", kPerson)});
  EXPECT_NE(reason.find("do not vary"), std::string::npos) << reason;
}

TEST(LinearMixedModelUndefined, ForAnswersThatTheMethodsExplain) {
  const auto reason =
      reasonOf({1, 2, 1, 2, 1, 2, 1, 2}, methods(), {analysis::factorOf("participant", kPerson)});
  EXPECT_NE(reason.find("do not vary"), std::string::npos) << reason;
}

TEST(LinearMixedModelUndefined, WithoutResidualVariance) {
  const auto reason =
      reasonOf({1, 2, 1, 2, 3, 4, 3, 4}, methods(), {analysis::factorOf("participant", kPerson)});
  EXPECT_NE(reason.find("no residual variance"), std::string::npos) << reason;
}

TEST(LinearMixedModelUndefined, ForAFactorThatIsFixedAndRandom) {
  const auto reason = reasonOf(kScores, methods(), {analysis::factorOf("method", kMethod)});
  EXPECT_NE(reason.find("leave nothing of the random intercept 'method'"), std::string::npos)
      << reason;
}

TEST(LinearMixedModelUndefined, ForFactorsThatGroupAlike) {
  auto hospital = analysis::factorOf("hospital", kPerson);
  const auto reason =
      reasonOf(kScores, methods(), {analysis::factorOf("participant", kPerson), hospital});
  EXPECT_NE(reason.find("'participant' and 'hospital' group the answers alike"), std::string::npos)
      << reason;
}

TEST(LinearMixedModelUndefined, ForALevelPerAnswer) {
  const std::vector<std::string> each{"1", "2", "3", "4", "5", "6", "7", "8"};
  const auto reason = reasonOf(kScores, methods(), {analysis::factorOf("answer", each)});
  EXPECT_NE(reason.find("as many levels as there are answers"), std::string::npos) << reason;
}

TEST(LinearMixedModelUndefined, ForColumnsThatSayTheSame) {
  auto fixed = methods();
  fixed.addCovariate("stiffness", {0.1, 0.7, 0.1, 0.7, 0.1, 0.7, 0.1, 0.7});
  const auto reason = reasonOf(kScores, fixed, {analysis::factorOf("participant", kPerson)});
  EXPECT_NE(reason.find("'stiffness' cannot be told apart"), std::string::npos) << reason;
}

TEST(LinearMixedModelUndefined, ForTooFewAnswers) {
  const auto reason = reasonOf({}, FixedEffects(0), {});
  EXPECT_NE(reason.find("0 answers for 1 fixed effects"), std::string::npos) << reason;
}

TEST(LinearMixedModelUndefined, SaysWhereDegreesOfFreedomAreNot) {
  // Two participants: their spread has one degree of freedom, and the mean less than two.
  const auto result = analysis::fitLinearMixedModel(
      kScores, methods(), {{analysis::factorOf("participant", kPerson)}});
  for (const auto& effect : result.fit.value().fixedEffects) {
    EXPECT_EQ(effect.p.has_value(), effect.reason.empty());
    EXPECT_TRUE(!effect.p || std::isfinite(*effect.p));
  }
}

TEST(LinearMixedModelUndefined, ThrowsForAProgrammersMistake) {
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
