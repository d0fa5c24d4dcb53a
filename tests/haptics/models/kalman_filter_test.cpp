#include "haptics/models/kalman_filter.h"

#include <cmath>
#include <string>
#include <vector>

#include <Eigen/Dense>
#include <gtest/gtest.h>

namespace haptics::models {
namespace kalman_filter_test {

using Filter = KalmanFilter<double>;
using Noise = KalmanNoise<double>;

const std::vector kSchemes{
    KalmanScheme::PaperText,
    KalmanScheme::AuthorsFirmware,
    KalmanScheme::Sequential,
    KalmanScheme::SpaceDomain};

Filter filterOf(KalmanScheme scheme, const Noise& noise = {}) {
  return Filter(noise.factored(), scheme);
}

/// Eq. (14)–(21) with matrices, as a textbook writes them.
class Textbook {
 public:
  Textbook(const Eigen::Matrix2d& q, const Noise& noise, KalmanScheme scheme)
      : noise_(noise), scheme_(scheme), q_(q), p_(q) {}

  static Textbook of(const Noise& n, KalmanScheme scheme) {
    Eigen::Matrix2d q;
    q << n.processForce, n.processCovariance, n.processCovariance, n.processStiffness;
    return {q, n, scheme};
  }

  double step(double travelled, double finiteElements, double interpolation) {
    predict(travelled);
    if (scheme_ == KalmanScheme::PaperText) {
      if (steps_++ % 2 == 0) {
        correct(finiteElements, noise_.finiteElements);
      } else {
        correct(interpolation, noise_.interpolation);
      }
      return x_(0);
    }
    correct(finiteElements, noise_.finiteElements);
    if (scheme_ == KalmanScheme::AuthorsFirmware) predict(travelled);
    correct(interpolation, noise_.interpolation);
    return x_(0);
  }

 private:
  void predict(double d) {
    Eigen::Matrix2d a;
    a << 1.0, d, 0.0, 1.0;
    Eigen::Matrix2d q = q_;
    if (scheme_ == KalmanScheme::SpaceDomain) {
      const double way = std::abs(d);
      q << way * way * way / 3, d * way / 2, d * way / 2, way;
      q *= noise_.wandering;
    }
    x_ = a * x_;
    p_ = a * p_ * a.transpose() + q;
  }
  void correct(double z, double r) {
    const Eigen::RowVector2d h(1.0, 0.0);
    const Eigen::Vector2d k = p_ * h.transpose() / (h * p_ * h.transpose() + r);
    x_ += k * (z - h * x_);
    p_ = (Eigen::Matrix2d::Identity() - k * h) * p_;
  }

  Noise noise_;
  KalmanScheme scheme_;
  Eigen::Matrix2d q_;
  Eigen::Matrix2d p_;
  Eigen::Vector2d x_ = Eigen::Vector2d::Zero();
  int steps_ = 0;
};

/// The largest difference of the force while a hand moves to and fro.
template <typename AnyFilter>
double largestDifference(AnyFilter filter, Textbook textbook) {
  double largest = 0.0;
  for (int i = 0; i < 2000; ++i) {
    const double travelled = 0.02 * std::sin(0.01 * i + 0.3);
    const double elastic = 3.0 + std::sin(0.05 * i);
    const double recorded = 2.0 + std::cos(0.03 * i);
    const double ours = filter.step(travelled, elastic, recorded);
    largest = std::max(largest, std::abs(ours - textbook.step(travelled, elastic, recorded)));
  }
  return largest;
}

TEST(KalmanFilter, EqualsTheTextbookWithMatricesInEveryScheme) {
  for (const auto scheme : kSchemes) {
    for (const auto reading :
         {ProcessNoiseReading::Symmetrised,
          ProcessNoiseReading::StateOrder,
          ProcessNoiseReading::Product}) {
      const auto noise = Noise::published(reading);
      EXPECT_LE(largestDifference(filterOf(scheme, noise), Textbook::of(noise, scheme)), 1e-9)
          << static_cast<int>(scheme) << " " << static_cast<int>(reading);
    }
  }
}

TEST(KalmanFilter, EqualsTheTextbookWithTheProcessNoiseAsPrinted) {
  Eigen::Matrix2d printed;
  printed << 7.0275, 0.02772, 0.2772, 6.1024;
  using Printed = KalmanFilter<double, TextbookCovariance>;
  for (const auto scheme :
       {KalmanScheme::PaperText, KalmanScheme::AuthorsFirmware, KalmanScheme::Sequential}) {
    const Printed filter(Noise().asPrinted(), scheme);
    EXPECT_LE(largestDifference(filter, Textbook(printed, {}, scheme)), 1e-9);
    if (scheme == KalmanScheme::Sequential) continue;
    EXPECT_GT(largestDifference(filter, Textbook::of({}, scheme)), 1e-5);  // and it matters
  }
}

/// How much the interpolation weighs while the hand moves by @p travelled a step: the mean of
/// (f − FEM) / (IP − FEM).
double weightOfInterpolation(KalmanScheme scheme, const Noise& noise, double travelled) {
  Filter filter(noise.factored(), scheme);
  double sum = 0.0;
  constexpr int kSteps = 1000;
  for (int i = -100; i < kSteps; ++i) {
    const double force = filter.step(travelled, 2.0, 3.0);
    if (i >= 0) sum += force - 2.0;
  }
  return sum / kSteps;
}

TEST(KalmanFilter, WeighsTheInterpolationAsEachSchemeDoes) {
  // Computed with matrices on curves like those of Fig. 10 of the punch paper.
  EXPECT_NEAR(weightOfInterpolation(KalmanScheme::PaperText, {}, 0.0), 0.238, 0.005);
  EXPECT_NEAR(weightOfInterpolation(KalmanScheme::AuthorsFirmware, {}, 0.0), 0.4758, 1e-4);
  EXPECT_NEAR(weightOfInterpolation(KalmanScheme::AuthorsFirmware, {}, 0.15), 0.50, 0.03);
  EXPECT_NEAR(weightOfInterpolation(KalmanScheme::Sequential, {}, 0.0), 0.0, 1e-3);
}

TEST(KalmanFilter, WeighsByTheMeasurementNoiseAlone) {
  // The same curves, eq. (12) to (24) with six variances of the interpolation.
  const std::vector<std::pair<double, double>> published{
      {0.001, 0.499}, {0.1, 0.492}, {1, 0.438}, {7.742, 0.239}, {50, 0.061}, {500, 0.005}};
  for (const auto& [variance, weight] : published) {
    const Noise noise{.interpolation = variance};
    EXPECT_NEAR(weightOfInterpolation(KalmanScheme::PaperText, noise, 0.0), weight, 0.005);
  }
}

TEST(KalmanFilter, WeighsEquallyCertainForcesEquallyInTheSpaceDomain) {
  const Noise noise{.finiteElements = 0.32, .interpolation = 0.32};
  EXPECT_NEAR(weightOfInterpolation(KalmanScheme::SpaceDomain, noise, 0.001), 0.5, 0.005);
  EXPECT_NEAR(weightOfInterpolation(KalmanScheme::SpaceDomain, noise, 0.0), 0.5, 1e-3);
}

TEST(KalmanFilter, RendersASquareWaveInThePapersText) {
  // The measurements alternate: the force jumps at every step, at the Nyquist frequency.
  auto filter = filterOf(KalmanScheme::PaperText);
  for (int i = 0; i < 100; ++i) filter.step(0.0, 2.0, 3.0);
  const double first = filter.step(0.0, 2.0, 3.0);
  const double second = filter.step(0.0, 2.0, 3.0);
  EXPECT_NEAR(std::abs(second - first), 0.476, 0.005);
  EXPECT_NEAR(filter.step(0.0, 2.0, 3.0), first, 1e-3);
}

/// The force at 6 travel units on the way at 10 a second, at a rate [Hz].
double forceAtSix(KalmanScheme scheme, double rate) {
  const Noise noise{.finiteElements = 0.32, .interpolation = 0.32};
  auto filter = filterOf(scheme, noise);
  const double step = 10.0 / rate;
  const int steps = static_cast<int>(std::lround(4.0 / step));
  double force = 0.0;
  for (int i = 0; i <= steps; ++i) {
    const double travel = 2.0 + i * step;
    const double elastic = std::max(0.0, 1.7 * (travel - 4.0));
    const double recorded = travel < 3.813 ? 0.0 : 1.722 * (travel - 3.813);
    force = filter.step(step, elastic, recorded);
  }
  return force;
}

TEST(KalmanFilter, IsIndependentOfTheRateInTheSpaceDomain) {
  const double slow = forceAtSix(KalmanScheme::SpaceDomain, 375.0);
  EXPECT_NEAR(forceAtSix(KalmanScheme::SpaceDomain, 1000.0), slow, 0.01);
  EXPECT_NEAR(forceAtSix(KalmanScheme::SpaceDomain, 4000.0), slow, 0.01);
}

TEST(KalmanFilter, FollowsAForceThatBothAgreeOn) {
  for (const auto scheme : kSchemes) {
    auto filter = filterOf(scheme);
    double force = 0.0;
    for (int i = 0; i < 100; ++i) force = filter.step(0.01, 4.0, 4.0);
    EXPECT_NEAR(force, 4.0, 0.01);
  }
}

TEST(KalmanFilter, ForgetsWhenReset) {
  for (const auto scheme : kSchemes) {
    auto fresh = filterOf(scheme);
    auto used = filterOf(scheme);
    for (int i = 0; i < 51; ++i) used.step(0.1, 5.0, 1.0);
    used.reset();
    EXPECT_EQ(used.step(0.1, 2.0, 3.0), fresh.step(0.1, 2.0, 3.0));
  }
}

TEST(KalmanNoise, GivesAReasonIfItIsInvalid) {
  const auto why = [](const Noise& noise) {
    const char* reason = noise.invalidReason();
    return std::string(reason == nullptr ? "" : reason);
  };
  EXPECT_EQ(why({}), "");
  EXPECT_NE(why({.processForce = -1.0}).find("negative variance"), std::string::npos);
  EXPECT_NE(why({.processCovariance = 7.0}).find("indefinite"), std::string::npos);
  EXPECT_NE(why({.interpolation = -0.1}).find("(R) is negative"), std::string::npos);
  EXPECT_NE(why({.interpolation = std::nan("")}).find("not finite"), std::string::npos);
  EXPECT_NE(
      why({.processForce = 1e200, .processStiffness = 1e200}).find("finite"), std::string::npos);
  const Noise nothing{
      .processForce = 0, .processCovariance = 0, .processStiffness = 0, .finiteElements = 0};
  EXPECT_NE(why(nothing).find("nothing to weigh"), std::string::npos);
}

TEST(KalmanNoise, HasEveryReadingOfThePaperSound) {
  for (const auto reading :
       {ProcessNoiseReading::Symmetrised,
        ProcessNoiseReading::StateOrder,
        ProcessNoiseReading::Product}) {
    EXPECT_EQ(Noise::published(reading).invalidReason(), nullptr);
  }
}

}  // namespace kalman_filter_test
}  // namespace haptics::models
