#include <cmath>
#include <stdexcept>

#include <gtest/gtest.h>

#include "analysis/reliability/reliability.h"

namespace one_factor_model_test {

using analysis::fitOneFactor;
using Matrix = std::vector<std::vector<double>>;

Matrix correlationsOf(const std::vector<double>& loadings) {
  Matrix correlations(loadings.size(), std::vector<double>(loadings.size(), 1.0));
  for (std::size_t i = 0; i < loadings.size(); ++i) {
    for (std::size_t j = 0; j < loadings.size(); ++j) {
      if (i != j) correlations[i][j] = loadings[i] * loadings[j];
    }
  }
  return correlations;
}

TEST(OneFactorModel, RecoversTheLoadingsOfExactCorrelations) {
  const std::vector<double> loadings{0.9, 0.3, 0.75, 0.5, 0.62};
  const auto model = fitOneFactor(correlationsOf(loadings));

  ASSERT_TRUE(model.hasConverged);
  EXPECT_FALSE(model.isImproper);
  for (std::size_t i = 0; i < loadings.size(); ++i) {
    EXPECT_NEAR(model.loadings[i], loadings[i], 1e-13);
  }
}

TEST(OneFactorModel, OfThreeItemsIsSpearmans) {
  // λ₁² = r₁₂ r₁₃ / r₂₃ and so on (Spearman 1904)
  const auto model = fitOneFactor(Matrix{{1.0, 0.5, 0.4}, {0.5, 1.0, 0.3}, {0.4, 0.3, 1.0}});

  EXPECT_NEAR(model.loadings[0], std::sqrt(0.5 * 0.4 / 0.3), 1e-13);
  EXPECT_NEAR(model.loadings[1], std::sqrt(0.5 * 0.3 / 0.4), 1e-13);
  EXPECT_NEAR(model.loadings[2], std::sqrt(0.4 * 0.3 / 0.5), 1e-13);
}

TEST(OneFactorModel, AllowsNegativeLoadings) {
  const auto model = fitOneFactor(correlationsOf({0.8, 0.7, -0.6, 0.5}));
  EXPECT_NEAR(model.loadings[2], -0.6, 1e-13);
  EXPECT_NEAR(model.loadings[0], 0.8, 1e-13);
}

TEST(OneFactorModel, FindsAMinimum) {
  const Matrix correlations{
      {1.0, 0.6, 0.2, 0.4}, {0.6, 1.0, 0.3, 0.35}, {0.2, 0.3, 1.0, 0.5}, {0.4, 0.35, 0.5, 1.0}};
  const auto unexplained = [&](const std::vector<double>& loadings) {
    double sum = 0.0;
    for (std::size_t i = 0; i < 4; ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        sum += std::pow(correlations[i][j] - loadings[i] * loadings[j], 2);
      }
    }
    return sum;
  };
  const auto model = fitOneFactor(correlations);
  const double least = unexplained(model.loadings);
  for (std::size_t i = 0; i < 4; ++i) {
    for (const double step : {-1e-3, 1e-3}) {
      auto moved = model.loadings;
      moved[i] += step;
      EXPECT_GT(unexplained(moved), least);
    }
  }
}

TEST(OneFactorModel, ReportsAnImproperSolution) {
  // λ₁² would be .8 · .8 / .3 > 1
  const auto model = fitOneFactor(Matrix{{1.0, 0.8, 0.8}, {0.8, 1.0, 0.3}, {0.8, 0.3, 1.0}});
  EXPECT_TRUE(model.isImproper);
  EXPECT_EQ(model.loadings[0], 1.0);
}

TEST(OneFactorModel, RejectsInvalidCorrelationMatrices) {
  EXPECT_THROW(fitOneFactor(Matrix{{1.0, 0.5}, {0.5, 1.0}}), std::invalid_argument);
  EXPECT_THROW(fitOneFactor(Matrix{{1.0}, {0.5}, {0.5}}), std::invalid_argument);
  EXPECT_THROW(fitOneFactor(correlationsOf({2.0, 0.9, 0.9})), std::invalid_argument);
}

}  // namespace one_factor_model_test
