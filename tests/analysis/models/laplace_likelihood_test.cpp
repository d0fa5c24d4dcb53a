#include "analysis/models/laplace_likelihood.h"

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "analysis/data/factor.h"

namespace laplace_likelihood_test {

using analysis::Factor;
using analysis::LaplaceLikelihood;

/// Five participants, two methods, three answers to each, levels 0 to 3.
const std::vector<std::size_t> kAnswers{0, 1, 1, 2, 3, 1, 2, 2, 1, 3, 3, 3, 0, 0, 2,
                                        1, 0, 1, 1, 2, 3, 3, 2, 2, 0, 1, 0, 2, 1, 1};

Factor blocks(const std::string& name, std::size_t each) {
  std::vector<std::string> labels;
  for (std::size_t i = 0; i < kAnswers.size(); ++i) labels.push_back(std::to_string(i / each));
  return analysis::factorOf(name, labels);
}

Factor statements() {
  std::vector<std::string> labels;
  for (std::size_t i = 0; i < kAnswers.size(); ++i) labels.push_back(std::to_string(i % 3));
  return analysis::factorOf("statement", labels);
}

Eigen::MatrixXd method() {
  Eigen::MatrixXd column(kAnswers.size(), 1);
  for (Eigen::Index i = 0; i < column.size(); ++i) column(i) = i / 3 % 2 == 0 ? 0.0 : 1.0;
  return column;
}

Eigen::VectorXd vectorOf(const std::vector<double>& numbers) {
  return Eigen::VectorXd::Map(numbers.data(), static_cast<Eigen::Index>(numbers.size()));
}

TEST(CumulativeLogit, IsTheDifferenceOfTwoLogisticProbabilities) {
  const analysis::CumulativeLogit at(0.7, -0.4);
  const auto logistic = [](double x) { return 1.0 / (1.0 + std::exp(-x)); };
  EXPECT_NEAR(std::exp(at.logProbability), logistic(0.7) - logistic(-0.4), 1e-15);
  // Far out, where both probabilities round to one: π ≈ e^{−50} − e^{−51}.
  const analysis::CumulativeLogit far(51.0, 50.0);
  EXPECT_NEAR(far.logProbability, -50.0 + std::log1p(-std::exp(-1.0)), 1e-13);
}

TEST(LaplaceLikelihood, HasTheDerivativesOfItsValue) {
  // Nested and crossed at once.
  const std::vector<Factor> random{blocks("participant", 6), blocks("cell", 3), statements()};
  LaplaceLikelihood likelihood(kAnswers, 4, method(), random);
  const Eigen::VectorXd at = vectorOf({-1.2, 0.1, 1.4, 0.6, 0.9, 0.5, 0.3});
  const auto derivatives = likelihood.derivatives(at).value();
  const auto value = [&](Eigen::Index j, double a, Eigen::Index k, double b) {
    Eigen::VectorXd point = at;
    point(j) += a;
    point(k) += b;
    return likelihood.value(point).value();
  };

  ASSERT_EQ(likelihood.parameters(), at.size());
  for (Eigen::Index j = 0; j < at.size(); ++j) {
    constexpr double kStep = 1e-4;
    const double slope = (value(j, kStep, j, 0.0) - value(j, -kStep, j, 0.0)) / (2.0 * kStep);
    EXPECT_NEAR(derivatives.gradient(j), slope, 1e-7) << j;
    for (Eigen::Index k = 0; k <= j; ++k) {
      constexpr double kWide = 1e-3;
      const double curvature = (value(j, kWide, k, kWide) - value(j, kWide, k, -kWide) -
                                value(j, -kWide, k, kWide) + value(j, -kWide, k, -kWide)) /
                               (4.0 * kWide * kWide);
      EXPECT_NEAR(derivatives.hessian(j, k), curvature, 3e-5) << j << " " << k;
    }
  }
}

/// Laplace's approximation against the integral itself, by the trapezium rule in u, one
/// participant after the other.
TEST(LaplaceLikelihood, ApproximatesTheIntegral) {
  const std::vector<double> at{-1.2, 0.1, 1.4, 0.6, 0.8};
  const Eigen::MatrixXd x = method();
  LaplaceLikelihood likelihood(kAnswers, 4, x, {{blocks("participant", 6)}});

  double exact = 0.0;
  for (std::size_t person = 0; person < 5; ++person) {
    double integral = 0.0;
    constexpr double kStep = 0.01;
    for (double u = -9.0; u <= 9.0; u += kStep) {
      double joint = -0.5 * u * u - 0.5 * std::log(2.0 * std::numbers::pi);
      for (std::size_t i = 6 * person; i < 6 * person + 6; ++i) {
        const double eta = at[3] * x(static_cast<Eigen::Index>(i)) + at[4] * u;
        const double above = kAnswers[i] < 3 ? at[kAnswers[i]] - eta : HUGE_VAL;
        const double below = kAnswers[i] > 0 ? at[kAnswers[i] - 1] - eta : -HUGE_VAL;
        joint += analysis::CumulativeLogit(above, below).logProbability;
      }
      integral += kStep * std::exp(joint);
    }
    exact -= std::log(integral);
  }

  EXPECT_NEAR(
      likelihood.value(vectorOf(at)).value(), exact, 0.05);  // five participants, 0.006 each
  const Eigen::VectorXd small = vectorOf({-1.2, 0.1, 1.4, 0.6, 0.0});
  LaplaceLikelihood plain(kAnswers, 4, x, {});
  EXPECT_NEAR(
      likelihood.value(small).value(), plain.value(vectorOf({-1.2, 0.1, 1.4, 0.6})).value(), 1e-12);
}

TEST(LaplaceLikelihood, IsNotDefinedForThresholdsOutOfOrder) {
  LaplaceLikelihood likelihood(kAnswers, 4, method(), {});
  EXPECT_FALSE(likelihood.value(vectorOf({0.2, 0.1, 1.4, 0.6})).has_value());
  EXPECT_FALSE(likelihood.gradient(vectorOf({0.1, 0.1, 1.4, 0.6})).has_value());
}

}  // namespace laplace_likelihood_test
