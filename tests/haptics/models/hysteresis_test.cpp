#include <cmath>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "haptics/models/interpolation.h"

namespace haptics::models {
namespace hysteresis_test {

using Curve = Interpolation<double>;
const std::vector<CurveNode<double>> kClosing{{2.0, 0.0}, {6.0, 4.0}, {7.0, 3.0}, {10.0, 5.0}};
const std::vector<CurveNode<double>> kOpening{{2.0, 0.0}, {8.0, 0.5}, {10.0, 2.0}};
constexpr double kWidth = 0.5;

Hysteresis<double> cut() {
  return {
      Curve(kClosing.data(), kClosing.size(), {}),
      Curve(kOpening.data(), kOpening.size(), {}),
      kWidth};
}

double onBranch(const std::vector<CurveNode<double>>& nodes, double travel) {
  std::size_t hint = 0;
  return Curve(nodes.data(), nodes.size(), {}).at(travel, hint).force;
}

TEST(Hysteresis, ClosesAlongTheClosingBranchAndOpensAlongTheOpeningOne) {
  const auto model = cut();
  Hysteresis<double>::State state;
  for (double travel = 1.0; travel < 9.0; travel += 0.01) {
    EXPECT_EQ(model.at(travel, state).force, onBranch(kClosing, travel));
  }
  for (double travel = 9.0; travel > 1.0; travel -= 0.01) {
    const double force = model.at(travel, state).force;
    if (travel < 9.0 - kWidth - 0.02) {
      EXPECT_NEAR(force, onBranch(kOpening, travel), 1e-12) << travel;
    }
  }
}

TEST(Hysteresis, NeverJumps) {
  const auto model = cut();
  Hysteresis<double>::State state;
  std::mt19937 random(3);
  std::normal_distribution<double> push(0.0, 0.004);
  double travel = 5.0;
  double last = model.at(travel, state).force;
  // The steepest slope of both, and the widest gap (5 - 0.33 at 6) over the width.
  constexpr double kSteepest = 1.0 + 4.0 / kWidth + 1.0;
  for (int i = 0; i < 100'000; ++i) {
    const double step = push(random) + 0.003 * std::sin(0.0005 * i);
    travel += step;
    const auto response = model.at(travel, state);
    ASSERT_LE(std::abs(response.force - last), kSteepest * std::abs(step) + 1e-12) << travel;
    last = response.force;
  }
}

TEST(Hysteresis, DoesNotDependOnSpeed) {
  const auto model = cut();
  for (const double step : {0.001, 0.01, 0.1}) {
    Hysteresis<double>::State state;
    double travel = 1.0;
    for (; travel < 8.9999; travel += step) model.at(travel, state);
    for (; travel > 5.0001; travel -= step) model.at(travel, state);
    EXPECT_NEAR(model.at(5.0, state).force, onBranch(kOpening, 5.0), 1e-9);
  }
}

TEST(Hysteresis, GivesNoEnergyOnAClosedLoop) {
  const auto model = cut();
  std::mt19937 random(5);
  for (int loop = 0; loop < 200; ++loop) {
    // There and back between random turns, ending where it began, on the closing branch.
    Hysteresis<double>::State state;
    std::uniform_real_distribution<double> anywhere(2.0, 10.0);
    std::vector<double> turns{1.0};
    for (int i = 0; i < 8; ++i) turns.push_back(anywhere(random));
    turns.push_back(1.0);
    double energy = 0.0;
    double last = model.at(1.0, state).force;
    for (std::size_t i = 1; i < turns.size(); ++i) {
      constexpr int kSteps = 4000;
      const double step = (turns[i] - turns[i - 1]) / kSteps;
      for (int k = 1; k <= kSteps; ++k) {
        const double force = model.at(turns[i - 1] + k * step, state).force;
        energy += 0.5 * (force + last) * step;
        last = force;
      }
    }
    EXPECT_GE(energy, -1e-6);
  }
}

TEST(Hysteresis, KnowsItsStiffness) {
  const auto model = cut();
  Hysteresis<double>::State state;
  double travel = 1.5;
  for (; travel < 8.0; travel += 0.001) model.at(travel, state);
  auto before = model.at(travel, state);
  for (int i = 0; i < 300; ++i) {  // into the turn
    travel -= 0.001;
    const auto response = model.at(travel, state);
    EXPECT_NEAR((before.force - response.force) / 0.001, response.stiffness, 0.02) << travel;
    before = response;
  }
}

TEST(Hysteresis, HasNoForceForNaN) {
  const auto model = cut();
  Hysteresis<double>::State state;
  EXPECT_FALSE(model.at(std::nan(""), state).isDefined);
  EXPECT_TRUE(model.at(5.0, state).isDefined);
}

}  // namespace hysteresis_test
}  // namespace haptics::models
