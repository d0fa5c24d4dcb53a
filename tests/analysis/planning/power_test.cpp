#include "analysis/planning/power.h"

#include <cmath>
#include <limits>
#include <stdexcept>

#include <gtest/gtest.h>

namespace power_test {

using analysis::pairedTPower;
using analysis::participantsForPower;

constexpr double kThird = 0.05 / 3.0;

TEST(Power, OfAPairedTTestHasTenDigits) {
  // mpmath, 25 digits: the integral over w = s/σ of f(w) (Φ(δ − t_c w) + Φ(−δ − t_c w)).
  EXPECT_NEAR(pairedTPower(1.0, 6, kThird), 0.273454148520144651, 1e-10);
  EXPECT_NEAR(pairedTPower(1.5, 6, kThird), 0.592234437309864698, 1e-10);
  EXPECT_NEAR(pairedTPower(0.5, 45, kThird), 0.802358159141115453, 1e-10);
  EXPECT_NEAR(pairedTPower(0.8, 20, kThird), 0.818383298514099511, 1e-10);
  EXPECT_NEAR(pairedTPower(1.2, 11, kThird), 0.840708298547156303, 1e-10);
}

TEST(Power, OfTwoParticipantsHasAClosedForm) {
  // ν = 1: T = (Z + δ)/|W|, and P(|T| > c) = ∫ 2φ(w) (Φ(δ − cw) + Φ(−δ − cw)) dw over w > 0.
  for (const double dz : {0.3, 1.0, 2.5}) {
    const double shift = dz * std::sqrt(2.0);
    const double critical = std::tan(std::acos(-1.0) * (0.5 - 0.025));
    const auto tail = [](double x) { return 0.5 * std::erfc(x / std::sqrt(2.0)); };
    constexpr double kStep = 1e-4;
    double power = 0.0;
    for (double w = 0.5 * kStep; w < 9.0; w += kStep) {
      const double density = 2.0 * std::exp(-0.5 * w * w) / std::sqrt(2.0 * std::acos(-1.0));
      power += kStep * density * (tail(critical * w - shift) + tail(critical * w + shift));
    }
    EXPECT_NEAR(pairedTPower(dz, 2, 0.05), power, 1e-6) << dz;
  }
}

TEST(Power, SaysHowManyParticipantsAreNeeded) {
  struct Case {
    double dz;
    std::uint64_t for80;
    std::uint64_t for90;
  };
  // R: ceiling(power.t.test(delta = dz, sd = 1, sig.level = .05 / 3, power = .8 or .9,
  //                         type = "paired", strict = TRUE)$n)
  for (const auto& [dz, for80, for90] :
       {Case{0.5, 45, 57}, {0.8, 20, 25}, {1.0, 14, 17}, {1.2, 11, 13}, {1.5, 8, 10}}) {
    EXPECT_EQ(participantsForPower(dz, kThird, 0.8), for80) << dz;
    EXPECT_EQ(participantsForPower(dz, kThird, 0.9), for90) << dz;
    EXPECT_EQ(participantsForPower(-dz, kThird, 0.9), for90) << dz;
  }
  EXPECT_EQ(participantsForPower(0.5, 0.05, 0.8), 34U);  // G*Power, textbooks
}

TEST(Power, IsAlphaWithoutAnEffectAndOneForALargeOne) {
  EXPECT_EQ(pairedTPower(0.0, 12, 0.05), 0.05);
  EXPECT_EQ(pairedTPower(1e9, 12, 0.05), 1.0);
  EXPECT_NEAR(pairedTPower(20.0, 1000, 0.05), 1.0, 1e-12);
  EXPECT_FALSE(participantsForPower(0.0, 0.05, 0.8));
  EXPECT_FALSE(participantsForPower(1e-5, 0.05, 0.8));
  // (z(.975) + z(.8))² / d² + z(.975)² / 2
  EXPECT_NEAR(static_cast<double>(*participantsForPower(0.003, 0.05, 0.8)), 872'100, 3.0);
}

TEST(Power, RejectsInvalidArguments) {
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(pairedTPower(1.0, 1, 0.05), std::invalid_argument);
  EXPECT_THROW(pairedTPower(1.0, 6, 0.0), std::invalid_argument);
  EXPECT_THROW(pairedTPower(kNone, 6, 0.05), std::invalid_argument);
  EXPECT_THROW(participantsForPower(1.0, 0.05, 1.0), std::invalid_argument);
  EXPECT_THROW(participantsForPower(1.0, 0.05, 0.01), std::invalid_argument);
}

}  // namespace power_test
