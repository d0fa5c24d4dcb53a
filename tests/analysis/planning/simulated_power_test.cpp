#include "analysis/planning/simulated_power.h"

#include <array>
#include <stdexcept>

#include <gtest/gtest.h>

#include "analysis/planning/power.h"

namespace simulated_power_test {

using analysis::LikertModel;
using analysis::PowerSimulation;
using analysis::simulatePower;

TEST(SimulatedPower, HasTheMeasuredFamilywiseError) {
  // Rates of 20,000 studies a cell, simulated by another program: N = 6, no true difference.
  struct Case {
    double participant;
    double byCondition;
    double residual;
    double pooledWelch;
    double pairedT;
  };
  for (const auto& [participant, byCondition, residual, pooled, paired] :
       {Case{0.0, 0.0, 1.0, .047, .046},
        Case{.3, .0, .7, .019, .043},
        Case{.3, .2, .5, .171, .044},
        Case{.1, .4, .5, .345, .049}}) {
    PowerSimulation simulation{.participants = 6, .studies = 4000, .seed = 7};
    simulation.model = {participant, byCondition, residual};
    simulation.model.dz = 0.0;
    const auto found = simulatePower(simulation);
    EXPECT_NEAR(found.anyPooledWelch.rate, pooled, 0.03) << byCondition;
    EXPECT_NEAR(found.anyPairedT.rate, paired, 0.015) << byCondition;
  }
}

TEST(SimulatedPower, AgreesWithTheFormulaOfThePairedT) {
  PowerSimulation simulation{.participants = 14, .studies = 4000, .seed = 3};
  simulation.model.dz = 1.0;
  simulation.model.points = 9;  // so many that the scale takes little away …
  const auto fine = simulatePower(simulation);
  EXPECT_NEAR(fine.pairedT.rate, analysis::pairedTPower(1.0, 14, 0.05 / 3.0), 0.03);
  simulation.model.points = 2;  // … and so few that it does
  EXPECT_LT(simulatePower(simulation).pairedT.rate, fine.pairedT.rate - 0.02);
}

TEST(SimulatedPower, IsZeroIfTheExactTestCannotBeSignificant) {
  PowerSimulation simulation{.participants = 6, .studies = 300};
  simulation.model.dz = 10.0;
  const auto six = simulatePower(simulation);
  EXPECT_EQ(six.signedRank.rate, 0.0);  // 2/64 > .05/3
  EXPECT_EQ(six.signFlip.rate, 0.0);
  EXPECT_GT(six.friedman.rate, 0.9);
  simulation.participants = 7;
  EXPECT_GT(simulatePower(simulation).signedRank.rate, 0.9);
  EXPECT_GT(simulatePower(simulation).signFlip.rate, 0.9);
}

TEST(SimulatedPower, OfSignFlipsIsNearThatOfThePairedT) {
  for (const std::uint64_t participants : {14, 80}) {
    PowerSimulation simulation{.participants = participants, .studies = 2000, .seed = 3};
    simulation.model.dz = participants == 14 ? 1.0 : 0.35;
    for (const int points : {5, 101}) {
      simulation.model.points = points;  // of 80 people on 101 points the approximation is used
      const auto found = simulatePower(simulation);
      EXPECT_NEAR(found.signFlip.rate, found.pairedT.rate, 0.03) << participants << " " << points;
    }
    simulation.model.dz = 0.0;
    EXPECT_LE(simulatePower(simulation).signFlip.rate, 0.05 / 3.0 + 0.01);
  }
}

TEST(SimulatedPower, IsTheSameForTheSameSeed) {
  PowerSimulation simulation{.participants = 10, .studies = 200, .seed = 5};
  const auto first = simulatePower(simulation);
  const auto again = simulatePower(simulation);
  EXPECT_EQ(first.pairedT.rate, again.pairedT.rate);
  EXPECT_EQ(first.signedRank.rate, again.signedRank.rate);
  EXPECT_EQ(first.friedman.rate, again.friedman.rate);
  simulation.seed = 6;
  simulation.studies = 2000;
  EXPECT_NE(simulatePower(simulation).pairedT.rate, first.pairedT.rate);
}

TEST(SimulatedPower, HasNearlyTheSamePowerByExactAndNormalRankTests) {
  PowerSimulation exact{.participants = 50, .studies = 1000};
  exact.model.dz = 0.5;
  auto normal = exact;
  normal.participants = 51;
  EXPECT_NEAR(simulatePower(exact).signedRank.rate, simulatePower(normal).signedRank.rate, 0.08);
}

TEST(LikertCohort, HasTheDocumentedShares) {
  LikertModel model{.participantShare = 0.0, .participantByConditionShare = 0.0};
  model.residualShare = 1.0;
  model.dz = 0.0;
  analysis::LikertCohort cohort(model, 1);
  std::array<double, 5> share{};
  constexpr int kPeople = 5000;
  for (int i = 0; i < kPeople; ++i) {
    for (const auto& answers : cohort.next()) {
      for (const int answer : answers) share.at(static_cast<std::size_t>(answer - 1)) += 1.0;
    }
  }
  // Φ(−1.2), Φ(−0.4) − Φ(−1.2), Φ(0.4) − Φ(−0.4)
  const std::array<double, 5> wanted{.1151, .2295, .3108, .2295, .1151};
  for (std::size_t i = 0; i < share.size(); ++i) {
    EXPECT_NEAR(share.at(i) / (kPeople * 18.0), wanted.at(i), 0.006) << i;
  }
}

TEST(SimulatedPower, RejectsInvalidArguments) {
  PowerSimulation simulation{.participants = 1};
  EXPECT_THROW(simulatePower(simulation), std::invalid_argument);
  simulation.participants = 6;
  simulation.model.residualShare = 0.9;
  EXPECT_THROW(simulatePower(simulation), std::invalid_argument);
}

}  // namespace simulated_power_test
