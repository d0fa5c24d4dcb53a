// Noise and steps over many decades. haptics/bench/model_stability.cpp looks for negative
// variances, also with fused multiply-add.
#include <cmath>
#include <limits>
#include <random>

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <gtest/gtest.h>

#include "haptics/models/kalman_filter.h"

namespace haptics::models {
namespace kalman_stability_test {

using Real = boost::multiprecision::cpp_bin_float_100;

/// What an adversary would choose: all over the decades, correlated as much as may be.
struct Adversary {
  std::mt19937_64 random;
  double decades;

  double magnitude() {
    return std::pow(10.0, std::uniform_real_distribution<double>(-decades, decades)(random));
  }

  KalmanNoise<double> noise() {
    KalmanNoise<double> n{.finiteElements = magnitude(), .interpolation = magnitude()};
    n.processForce = magnitude();
    n.processStiffness = magnitude();
    const double correlation = std::uniform_real_distribution<double>(-0.999, 0.999)(random);
    n.processCovariance = correlation * std::sqrt(n.processForce) * std::sqrt(n.processStiffness);
    n.wandering = magnitude();
    return n;
  }

  double travelled() { return magnitude() * (random() % 2 == 0 ? 1.0 : -1.0); }
};

constexpr KalmanScheme kSchemes[]{
    KalmanScheme::PaperText,
    KalmanScheme::AuthorsFirmware,
    KalmanScheme::Sequential,
    KalmanScheme::SpaceDomain};

/// Eq. (14)–(21) in 100 digits, one predict and both measurements.
struct Reference {
  Real f = 0, z = 0, p11, p12, p22;
  KalmanNoise<double> noise;

  explicit Reference(const KalmanNoise<double>& n)
      : p11(n.processForce), p12(n.processCovariance), p22(n.processStiffness), noise(n) {}

  void correct(const Real& measured, double variance) {
    const Real total = p11 + variance;
    const Real k1 = p11 / total;
    const Real k2 = p12 / total;
    const Real innovation = measured - f;
    f += k1 * innovation;
    z += k2 * innovation;
    p22 -= k2 * p12;
    p12 -= k2 * p11;
    p11 -= k1 * p11;
  }

  Real step(double travelled, double elastic, double recorded) {
    const Real d = travelled;
    f += z * d;
    p11 += d * (2 * p12 + d * p22) + noise.processForce;
    p12 += d * p22 + noise.processCovariance;
    p22 += noise.processStiffness;
    correct(elastic, noise.finiteElements);
    correct(recorded, noise.interpolation);
    return f;
  }
};

TEST(KalmanStability, AgreesWithAHundredDigits) {
  Adversary adversary{std::mt19937_64(7), 6.0};
  std::vector<double> errors;
  for (int i = 0; i < 50; ++i) {
    const auto noise = adversary.noise();
    KalmanFilter<double> filter(noise.factored(), KalmanScheme::Sequential);
    Reference reference(noise);
    for (int step = 0; step < 40; ++step) {
      const double travelled = adversary.travelled();
      const double force = filter.step(travelled, 3.0, 2.0);
      const Real expected = reference.step(travelled, 3.0, 2.0);
      errors.push_back(static_cast<double>(abs(Real(force) / expected - 1)));
    }
  }
  std::sort(errors.begin(), errors.end());
  EXPECT_LE(errors[errors.size() * 99 / 100], 6e-8);  // what Joseph's form reaches, too
  EXPECT_LE(errors[errors.size() / 2], 1e-14);
}

TEST(KalmanStability, FollowsAHandThatMovesAfterAnHour) {
  for (const auto scheme : kSchemes) {
    KalmanFilter<double> filter(KalmanNoise<double>().factored(), scheme);
    for (int i = 0; i < 3'600'000; ++i) filter.step(0.0, 3.0, 2.0);
    const double moved = filter.step(0.01, 3.0, 2.0);
    EXPECT_GE(moved, 1.5) << static_cast<int>(scheme);
    EXPECT_LE(moved, 3.5) << static_cast<int>(scheme);
  }
}

TEST(KalmanStability, NeverHidesAnOverflow) {
  for (const double leap : {1e155, 1e300, std::numeric_limits<double>::infinity()}) {
    for (const auto scheme : kSchemes) {
      KalmanFilter<double> filter(KalmanNoise<double>().factored(), scheme);
      double force = 0.0;
      for (int i = 0; i < 4; ++i) force = filter.step(leap, 3.0, 2.0);
      const bool isSane = force >= -1e-9 && force <= 3.0 + 1e-9;
      EXPECT_TRUE(isSane || !std::isfinite(force)) << leap << ": " << force;
    }
  }
}

TEST(KalmanStability, StaysFiniteForTinySteps) {
  for (const double step : {1e-100, 1e-160, 5e-324}) {
    KalmanFilter<double> filter(KalmanNoise<double>().factored(), KalmanScheme::SpaceDomain);
    for (int i = 0; i < 100; ++i) ASSERT_TRUE(std::isfinite(filter.step(step, 3.0, 2.0))) << step;
  }
}

}  // namespace kalman_stability_test
}  // namespace haptics::models
