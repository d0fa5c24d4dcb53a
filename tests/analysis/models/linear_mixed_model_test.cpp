#include "analysis/models/linear_mixed_model.h"

#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace linear_mixed_model_test {

using analysis::Factor;
using analysis::FixedEffects;

/// Levels in blocks: 0 0 0 1 1 1 …
Factor blocks(const std::string& name, std::size_t levels, std::size_t each) {
  std::vector<std::string> labels;
  for (std::size_t i = 0; i < levels * each; ++i) labels.push_back(std::to_string(i / each));
  return analysis::factorOf(name, labels);
}

/// Levels in turn: 0 1 2 0 1 2 …
Factor turns(const std::string& name, std::size_t levels, std::size_t answers) {
  std::vector<std::string> labels;
  for (std::size_t i = 0; i < answers; ++i) labels.push_back(std::to_string(i % levels));
  return analysis::factorOf(name, labels);
}

// Davies & Goldsmith 1972, Statistical Methods in Research and Production, table 6.3: the yield of
// dyestuff from five preparations of each of six batches.
const std::vector<double> kDyestuff{1545, 1440, 1440, 1520, 1580, 1540, 1555, 1490, 1560, 1495,
                                    1595, 1550, 1605, 1510, 1560, 1445, 1440, 1595, 1465, 1545,
                                    1595, 1630, 1515, 1635, 1625, 1520, 1455, 1450, 1480, 1445};

TEST(LinearMixedModel, FindsThePublishedVariancesOfDyestuff) {
  const auto result =
      analysis::fitLinearMixedModel(kDyestuff, FixedEffects(30), {{blocks("batch", 6, 5)}});

  const auto& fit = result.fit.value();
  EXPECT_NEAR(-2.0 * fit.logLikelihood, 319.6543, 5e-5);  // lme4: Dyestuff, REML
  EXPECT_NEAR(fit.components[0].variance, 1764.05, 5e-3);
  EXPECT_NEAR(fit.residualVariance, 2451.25, 1e-6);  // the mean square within batches, exactly
  EXPECT_NEAR(fit.fixedEffects[0].estimate, 1527.5, 1e-9);
  EXPECT_NEAR(fit.fixedEffects[0].degreesOfFreedom.value(), 5.0, 1e-7);
}

// Box & Tiao 1973, Bayesian Inference in Statistical Analysis, table 5.1.4: simulated so that the
// batches vary less than their means would by chance.
const std::vector<double> kDyestuff2{7.298,  3.846,  2.434, 9.566,  7.990,  5.220, 6.556, 0.608,
                                     11.788, -0.892, 0.110, 10.386, 13.434, 5.510, 8.166, 2.212,
                                     4.852,  7.092,  9.288, 4.980,  0.282,  9.014, 4.458, 9.446,
                                     7.198,  1.722,  4.782, 8.106,  0.758,  3.758};

TEST(LinearMixedModel, NamesAVarianceThatIsEstimatedAsZero) {
  const auto result =
      analysis::fitLinearMixedModel(kDyestuff2, FixedEffects(30), {{blocks("batch", 6, 5)}});

  const auto& fit = result.fit.value();
  EXPECT_EQ(fit.components[0].variance, 0.0);
  EXPECT_TRUE(fit.components[0].isSingular);
  EXPECT_NEAR(-2.0 * fit.logLikelihood, 161.8283, 5e-5);  // lme4: Dyestuff2, REML
  EXPECT_NEAR(fit.residualVariance, 13.81, 5e-3);
  EXPECT_NEAR(fit.fixedEffects[0].estimate, 5.6656, 5e-5);
  EXPECT_NEAR(fit.fixedEffects[0].degreesOfFreedom.value(), 29.0, 1e-9);
}

/// Numbers without a pattern, the same on every machine.
class Noise {
 public:
  double next() {
    state_ = state_ * 6364136223846793005ULL + 1442695040888963407ULL;
    return static_cast<double>(state_ >> 33U) / 2147483648.0 - 0.5;
  }

 private:
  std::uint64_t state_ = 1;
};

TEST(LinearMixedModel, OfBalancedBlocksIsThePairedTTest) {
  // One answer of each participant to each method; participants vary more than their answers.
  Noise noise;
  std::vector<double> y;
  for (int person = 0; person < 12; ++person) {
    const double own = 4.0 * noise.next();
    for (const double effect : {0.0, 0.5}) y.push_back(own + effect + noise.next());
  }
  FixedEffects fixed(24);
  fixed.add(turns("method", 2, 24));
  const auto fit =
      analysis::fitLinearMixedModel(y, fixed, {{blocks("participant", 12, 2)}}).fit.value();

  double mean = 0.0;
  double squares = 0.0;
  for (std::size_t i = 0; i < 24; i += 2) mean += (y[i + 1] - y[i]) / 12.0;
  for (std::size_t i = 0; i < 24; i += 2) squares += std::pow(y[i + 1] - y[i] - mean, 2);
  const double standardError = std::sqrt(squares / 11.0 / 12.0);
  ASSERT_GT(fit.components[0].variance, 0.0);
  EXPECT_NEAR(fit.fixedEffects[1].estimate, mean, 1e-12);
  EXPECT_NEAR(fit.fixedEffects[1].standardError, standardError, 1e-9);
  EXPECT_NEAR(fit.fixedEffects[1].degreesOfFreedom.value(), 11.0, 1e-6);
}

TEST(LinearMixedModel, ContrastsTwoLevelsOfAFactor) {
  // Level means 1, 4 and 9, with scatter that takes nothing from them.
  const std::vector<double> means{1.0, 4.0, 9.0};
  const std::vector<double> people{-1.0, 0.5, 1.5, -0.5, -0.5};
  std::vector<double> y;
  for (std::size_t person = 0; person < people.size(); ++person) {
    const double twist = 0.25 * (static_cast<double>(person % 2) - 0.4);
    y.insert(
        y.end(),
        {means[0] + people[person] + twist,
         means[1] + people[person] - 2.0 * twist,
         means[2] + people[person] + twist});
  }
  FixedEffects fixed(y.size());
  fixed.add(turns("method", 3, y.size()));
  const auto fit =
      analysis::fitLinearMixedModel(y, fixed, {{blocks("participant", 5, 3)}}).fit.value();

  const auto difference = [&](const char* level1, const char* level2) {
    return contrast(fit, "", fixed.difference("method", level1, level2));
  };
  EXPECT_NEAR(difference("0", "1").estimate, -3.0, 1e-9);
  EXPECT_LT(difference("0", "1").t.value(), 0.0);
  EXPECT_NEAR(difference("0", "2").estimate, -8.0, 1e-9);
  EXPECT_NEAR(difference("1", "2").estimate, -5.0, 1e-9);
}

/// The estimates of crossed intercepts: mean squares of a two-way layout without interaction.
TEST(LinearMixedModel, OfCrossedInterceptsIsTheAnalysisOfVariance) {
  constexpr std::size_t kPeople = 8;
  constexpr std::size_t kStatements = 5;
  Noise noise;
  std::vector<double> people;
  std::vector<double> statements;
  std::vector<double> y;
  for (std::size_t i = 0; i < kPeople; ++i) people.push_back(3.0 * noise.next());
  for (std::size_t j = 0; j < kStatements; ++j) statements.push_back(2.0 * noise.next());
  for (const double person : people) {
    for (const double statement : statements) y.push_back(person + statement + noise.next());
  }
  const auto fit = analysis::fitLinearMixedModel(
                       y,
                       FixedEffects(y.size()),
                       {{blocks("participant", kPeople, kStatements),
                         turns("statement", kStatements, y.size())}})
                       .fit.value();

  std::vector<double> ofPerson(kPeople, 0.0);
  std::vector<double> ofStatement(kStatements, 0.0);
  double mean = 0.0;
  for (std::size_t k = 0; k < y.size(); ++k) {
    ofPerson[k / kStatements] += y[k] / kStatements;
    ofStatement[k % kStatements] += y[k] / kPeople;
    mean += y[k] / static_cast<double>(y.size());
  }
  double between = 0.0;
  double across = 0.0;
  double within = 0.0;
  for (std::size_t k = 0; k < y.size(); ++k) {
    const double a = ofPerson[k / kStatements];
    const double b = ofStatement[k % kStatements];
    between += std::pow(a - mean, 2) / (kPeople - 1.0);
    across += std::pow(b - mean, 2) / (kStatements - 1.0);
    within += std::pow(y[k] - a - b + mean, 2) / ((kPeople - 1.0) * (kStatements - 1.0));
  }
  EXPECT_NEAR(fit.residualVariance, within, 1e-8 * within);
  EXPECT_NEAR(fit.components[0].variance, (between - within) / kStatements, 1e-8 * between);
  EXPECT_NEAR(fit.components[1].variance, (across - within) / kPeople, 1e-8 * across);
}

TEST(LinearMixedModel, DoesNotDependOnOffsetAndUnit) {
  auto shifted = kDyestuff;
  for (double& value : shifted) value = 1e-6 * value + 1e6;
  const std::vector<Factor> batch{blocks("batch", 6, 5)};
  const auto plain = analysis::fitLinearMixedModel(kDyestuff, FixedEffects(30), batch).fit.value();
  const auto fit = analysis::fitLinearMixedModel(shifted, FixedEffects(30), batch).fit.value();

  EXPECT_NEAR(fit.components[0].variance / plain.components[0].variance, 1e-12, 1e-17);
  EXPECT_NEAR(fit.fixedEffects[0].degreesOfFreedom.value(), 5.0, 1e-4);
}

TEST(LinearMixedModel, FitsAStudyOfHundredParticipants) {
  constexpr std::size_t kPeople = 100;
  constexpr std::size_t kEach = 30;  // three methods, ten statements
  Noise noise;
  const auto participant = blocks("participant", kPeople, kEach);
  const auto method = turns("method", 3, kPeople * kEach);
  const auto statement = turns("statement", 10, kPeople * kEach);
  const auto cell = interactionOf(participant, method);
  const auto draw = [&](std::size_t levels, double size) {
    std::vector<double> effects;
    for (std::size_t i = 0; i < levels; ++i) effects.push_back(size * noise.next());
    return effects;
  };
  const auto people = draw(kPeople, 3.0);  // variance 9/12
  const auto cells = draw(3 * kPeople, 2.0);
  const auto statements = draw(10, 1.0);
  std::vector<double> y;
  for (std::size_t i = 0; i < kPeople * kEach; ++i) {
    y.push_back(
        people[participant.levelOfAnswer[i]] + cells[cell.levelOfAnswer[i]] +
        statements[statement.levelOfAnswer[i]] + 4.0 * noise.next());
  }
  FixedEffects fixed(y.size());
  fixed.add(method);
  const auto fit =
      analysis::fitLinearMixedModel(y, fixed, {{participant, cell, statement}}).fit.value();

  EXPECT_NEAR(fit.components[0].variance, 9.0 / 12.0, 0.3);
  EXPECT_NEAR(fit.components[1].variance, 4.0 / 12.0, 0.15);
  EXPECT_NEAR(fit.components[2].variance, 1.0 / 12.0, 0.1);
  EXPECT_NEAR(fit.residualVariance, 16.0 / 12.0, 0.1);
  EXPECT_NEAR(fit.fixedEffects[1].degreesOfFreedom.value(), 198.0, 0.01);
}

}  // namespace linear_mixed_model_test
