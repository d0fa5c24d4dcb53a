#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

#include "haptics/devices/hand.h"

namespace haptics::devices {
namespace simulated_hand_test {

constexpr double kDt = 0.001;

/// Where a hand means to be, tick by tick: what it pushes with on a tool that stands at 0, over k.
std::vector<double> meantBy(SimulatedHand& hand, double stiffness, int ticks) {
  std::vector<double> meant;
  for (int i = 0; i < ticks; ++i) meant.push_back(hand.push(0.0, 0.0, kDt) / stiffness);
  return meant;
}

constexpr SimulatedHand::Person kCalm{
    .closed = 10.0,
    .pauseTime = 0.2,
    .closeTime = 0.5,
    .holdTime = 0.1,
    .openTime = 0.4,
    .damping = 0.0};

TEST(SimulatedHand, ClosesAlongAMinimumJerkPath) {
  SimulatedHand hand(kCalm);
  const auto meant = meantBy(hand, kCalm.stiffness, 1200);
  EXPECT_NEAR(meant[100], 0.0, 1e-12);                 // pausing
  EXPECT_NEAR(meant[200 + 250 - 1], 5.0, 1e-9);        // half the time, half the way
  EXPECT_NEAR(meant[200 + 125 - 1], 1.0351562, 1e-6);  // 10 (10 τ³ − 15 τ⁴ + 6 τ⁵) at τ = 1/4
  EXPECT_NEAR(meant[750], 10.0, 1e-12);                // holding
  EXPECT_NEAR(meant[1198], 0.0, 1e-4);                 // open again
}

TEST(SimulatedHand, RepeatsEveryCycleExactlyWithoutVariation) {
  SimulatedHand hand(kCalm);
  const auto meant = meantBy(hand, kCalm.stiffness, 2400);
  for (std::size_t i = 0; i < 1200; ++i) EXPECT_NEAR(meant[i], meant[i + 1200], 1e-9);
}

TEST(SimulatedHand, VariesFromCutToCutTheSameWayForASeed) {
  auto person = kCalm;
  person.variation = 0.3;
  person.seed = 5;
  const auto peaks = [&] {
    SimulatedHand hand(person);
    const auto meant = meantBy(hand, person.stiffness, 20'000);
    std::vector<double> found;
    for (std::size_t i = 1; i + 1 < meant.size(); ++i) {
      const bool isNewPeak = meant[i] > 5.0 && meant[i] > meant[i - 1] && meant[i + 1] <= meant[i];
      if (isNewPeak) found.push_back(meant[i]);
    }
    return found;
  };
  const auto first = peaks();
  ASSERT_GT(first.size(), 10U);
  EXPECT_EQ(first, peaks());
  const auto [least, most] = std::minmax_element(first.begin(), first.end());
  EXPECT_GT(*most - *least, 0.3);
  EXPECT_LE(*most, 10.0 * 1.09 + 1e-9);  // reach varies by 0.3 of the variation
}

TEST(SimulatedHand, PushesLessFarIntoStifferTissue) {
  SimulatedHand hand(kCalm);
  for (int i = 0; i < 750; ++i) hand.push(0.0, 0.0, kDt);
  EXPECT_NEAR(hand.push(8.0, 0.0, kDt), kCalm.stiffness * 2.0, 1e-9);
}

TEST(SimulatedHand, RefusesInvalidParameters) {
  EXPECT_THROW(SimulatedHand({.closeTime = 0.0}), std::invalid_argument);
  EXPECT_THROW(SimulatedHand({.stiffness = -1.0}), std::invalid_argument);
  EXPECT_THROW(SimulatedHand({.variation = 2.0}), std::invalid_argument);
  EXPECT_THROW(SimulatedHand({.closed = std::nan("")}), std::invalid_argument);
}

}  // namespace simulated_hand_test
}  // namespace haptics::devices
