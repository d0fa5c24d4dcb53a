// Noise and steps over many decades. Compiled twice, with fused multiply-add and without: rounding
// once instead of twice makes the textbook's form worse.
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <gtest/gtest.h>

#include "haptics/models/kalman_filter.h"

namespace haptics::models {
namespace kalman_stability_test {

using Real = boost::multiprecision::cpp_bin_float_100;

class KalmanStability : public testing::Test {
 protected:
  void SetUp() override {
#ifdef __FMA__
    if (!__builtin_cpu_supports("fma")) GTEST_SKIP() << "this processor has no fused multiply-add";
#endif
  }
};

/// What an adversary would choose: all over the decades, correlated as much as may be.
template <typename Scalar>
struct Adversary {
  std::mt19937_64 random;
  double decades;
  bool isProcessNothing = false;

  Scalar magnitude() {
    return static_cast<Scalar>(
        std::pow(10.0, std::uniform_real_distribution<double>(-decades, decades)(random)));
  }

  KalmanNoise<Scalar> noise() {
    KalmanNoise<Scalar> n{.finiteElements = magnitude(), .interpolation = magnitude()};
    n.processForce = isProcessNothing ? Scalar{0} : magnitude();
    n.processStiffness = isProcessNothing ? Scalar{0} : magnitude();
    const double correlation = std::uniform_real_distribution<double>(-0.999, 0.999)(random);
    n.processCovariance = static_cast<Scalar>(correlation) * std::sqrt(n.processForce) *
                          std::sqrt(n.processStiffness);
    n.wandering = magnitude();
    return n;
  }

  Scalar travelled() { return magnitude() * (random() % 2 == 0 ? Scalar{1} : Scalar{-1}); }
};

struct Count {
  std::int64_t steps = 0;
  std::int64_t negative = 0;
  std::int64_t notFinite = 0;
};

constexpr KalmanScheme kSchemes[]{
    KalmanScheme::PaperText,
    KalmanScheme::AuthorsFirmware,
    KalmanScheme::Sequential,
    KalmanScheme::SpaceDomain};

template <typename Scalar>
Count attack(double decades, bool isProcessNothing, int filters) {
  Adversary<Scalar> adversary{std::mt19937_64(20261121), decades, isProcessNothing};
  Count count;
  for (int i = 0; i < filters; ++i) {
    const auto noise = adversary.noise();
    if (noise.invalidReason() != nullptr) continue;
    KalmanFilter<Scalar> filter(noise.factored(), kSchemes[i % 4]);
    for (int step = 0; step < 200; ++step) {
      const Scalar force = filter.step(adversary.travelled(), Scalar{3}, Scalar{2});
      const auto& p = filter.variances();
      ++count.steps;
      count.negative += p.force < Scalar{0} || p.rest < Scalar{0} ? 1 : 0;
      count.notFinite += std::isfinite(force) ? 0 : 1;
    }
  }
  return count;
}

TEST_F(KalmanStability, HasNoNegativeVarianceInAMillionAdversarialSteps) {
  for (const bool isProcessNothing : {false, true}) {
    for (const double decades : {3.0, 6.0, 12.0}) {
      const auto count = attack<double>(decades, isProcessNothing, 1000);
      EXPECT_GE(count.steps, 190'000);
      EXPECT_EQ(count.negative, 0) << "10^±" << decades;
      EXPECT_EQ(count.notFinite, 0) << "10^±" << decades;
    }
  }
}

TEST_F(KalmanStability, HasNoNegativeVarianceInSinglePrecision) {
  for (const bool isProcessNothing : {false, true}) {
    for (const double decades : {3.0, 6.0, 12.0}) {
      const auto count = attack<float>(decades, isProcessNothing, 1000);
      EXPECT_GE(count.steps, 100'000);
      EXPECT_EQ(count.negative, 0) << "10^±" << decades;
    }
  }
}

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

TEST_F(KalmanStability, AgreesWithAHundredDigits) {
  Adversary<double> adversary{std::mt19937_64(7), 6.0};
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

TEST_F(KalmanStability, DoesNotDriftOnAHandThatRestsForAnHour) {
  for (const auto scheme : kSchemes) {
    KalmanFilter<double> filter(KalmanNoise<double>().factored(), scheme);
    for (int i = 0; i < 3'600'000; ++i) filter.step(0.0, 3.0, 2.0);
    EXPECT_GE(filter.force(), 2.0);
    EXPECT_LE(filter.force(), 3.0);
    const double moved = filter.step(0.01, 3.0, 2.0);
    EXPECT_GE(moved, 1.5) << static_cast<int>(scheme);
    EXPECT_LE(moved, 3.5) << static_cast<int>(scheme);
  }
}

TEST_F(KalmanStability, NeverHidesAnOverflow) {
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

TEST_F(KalmanStability, StaysFiniteForTinySteps) {
  for (const double step : {1e-100, 1e-160, 5e-324}) {
    KalmanFilter<double> filter(KalmanNoise<double>().factored(), KalmanScheme::SpaceDomain);
    for (int i = 0; i < 100; ++i) ASSERT_TRUE(std::isfinite(filter.step(step, 3.0, 2.0))) << step;
  }
}

}  // namespace kalman_stability_test
}  // namespace haptics::models
