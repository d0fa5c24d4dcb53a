#include "haptics/models/kalman_filter.h"

#include <cmath>

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include "haptics/models/finite_elements.h"
#include "haptics/models/interpolation.h"

namespace haptics::models {
namespace {

using Filter = KalmanFilter<double>;

/// Eq. (14)–(21) with matrices, as a textbook writes them.
class Textbook {
 public:
  explicit Textbook(const Filter::Noise& n) : noise_(n) {
    q_ << n.processForce, n.processCovariance, n.processCovariance, n.processStiffness;
    p_ = q_;
  }

  double step(double travelled, double finiteElements, double interpolation) {
    predict(travelled);
    correct(finiteElements, noise_.finiteElements);
    predict(travelled);
    correct(interpolation, noise_.interpolation);
    return x_(0);
  }

 private:
  void predict(double travelled) {
    Eigen::Matrix2d a;
    a << 1.0, travelled, 0.0, 1.0;
    x_ = a * x_;
    p_ = a * p_ * a.transpose() + q_;
  }
  void correct(double z, double r) {
    const Eigen::RowVector2d h(1.0, 0.0);
    const Eigen::Vector2d k = p_ * h.transpose() / (h * p_ * h.transpose() + r);
    x_ += k * (z - h * x_);
    p_ = (Eigen::Matrix2d::Identity() - k * h) * p_;
  }

  Filter::Noise noise_;
  Eigen::Matrix2d q_;
  Eigen::Matrix2d p_;
  Eigen::Vector2d x_ = Eigen::Vector2d::Zero();
};

TEST(KalmanFilter, EqualsTheTextbookWithMatrices) {
  Filter filter({});
  Textbook textbook({});
  for (int i = 0; i < 2000; ++i) {
    const double travelled = 0.02 * std::sin(0.01 * i);
    const double elastic = 3.0 + std::sin(0.05 * i);
    const double recorded = 2.0 + std::cos(0.03 * i);
    EXPECT_NEAR(
        filter.step(travelled, elastic, recorded), textbook.step(travelled, elastic, recorded), 1e-9);
  }
}

TEST(KalmanFilter, WeighsBothForcesAboutEqually) {
  // paper-discrepancies §6.1: with `authors-firmware` the interpolation weighs 0.48–0.53, and the
  // steady gain is 7.0275 / (7.0275 + 7.742) = 0.476 where the handle hardly moves.
  Filter filter({});
  double force = 0.0;
  for (int i = 0; i < 1000; ++i) force = filter.step(0.0, 2.0, 3.0);
  EXPECT_NEAR(force - 2.0, 0.4758, 1e-3);
}

TEST(KalmanFilter, FollowsAForceThatBothAgreeOn) {
  Filter filter({});
  double force = 0.0;
  for (int i = 0; i < 100; ++i) force = filter.step(0.01, 4.0, 4.0);
  EXPECT_NEAR(force, 4.0, 0.01);
}

TEST(KalmanFilter, ForgetsWhenReset) {
  Filter fresh({});
  Filter used({});
  for (int i = 0; i < 50; ++i) used.step(0.1, 5.0, 1.0);
  used.reset();
  EXPECT_EQ(used.step(0.1, 2.0, 3.0), fresh.step(0.1, 2.0, 3.0));
}

TEST(KalmanFilter, KnowsUnsoundNoise) {
  EXPECT_TRUE(Filter::isSound({}));
  EXPECT_FALSE(Filter::isSound({.processForce = -1.0}));
  EXPECT_FALSE(Filter::isSound({.processCovariance = 7.0}));  // 7² > 7.0275 · 6.1024
  EXPECT_FALSE(Filter::isSound({.interpolation = -0.1}));
  EXPECT_FALSE(Filter::isSound({.interpolation = std::nan("")}));
  EXPECT_FALSE(Filter::isSound(
      {.processForce = 0, .processCovariance = 0, .processStiffness = 0, .finiteElements = 0}));
}

TEST(KalmanFilter, StaysFiniteOnARestingHandForAMinute) {
  Filter filter({});
  for (int i = 0; i < 60'000; ++i) ASSERT_TRUE(std::isfinite(filter.step(0.0, 3.0, 2.0)));
}

}  // namespace
}  // namespace haptics::models
