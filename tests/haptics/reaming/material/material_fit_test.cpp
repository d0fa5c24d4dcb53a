#include "haptics/reaming/material/material_fit.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <gtest/gtest.h>

#include "haptics/reaming/material/synthetic_series.h"

namespace haptics::reaming {
namespace material_fit_test {

TEST(MaterialFit, MakesThreeTestSetsOfAStudy) {
  const auto study = syntheticStudy(1);
  const auto fit = fitMaterial(study, {});
  EXPECT_EQ(fit.series.size(), 72U);
  ASSERT_EQ(fit.sets.size(), 3U);
  EXPECT_EQ(fit.sets[0].used, 24);
  EXPECT_EQ(fit.sets[1].used, 22);
  EXPECT_EQ(fit.sets[2].used, 16);
  EXPECT_FALSE(fit.sets[0].torque);
  EXPECT_TRUE(fit.sets[1].torque);
  for (const auto& set : fit.sets) {
    EXPECT_GT(set.scale, 0.005);
    EXPECT_LE(set.scale, 0.02);
    for (const auto* curve : {&set.force.minimum, &set.force.average, &set.force.maximum}) {
      EXPECT_LE(curve->error.floored, 0.05 + 1e-9);
      EXPECT_LE(curve->spline.nodes.size(), 80U);
      EXPECT_EQ(curve->spline.nodes.front().position, 0.0);
      EXPECT_EQ(curve->spline.nodes.back().position, set.scale);
    }
  }
}

TEST(MaterialFit, FiltersOnlyWhatIsReamed) {
  for (const auto& series : fitMaterial(syntheticStudy(2), {}).series) {
    if (series.exclusion.isExcluded()) continue;
    EXPECT_EQ(series.cutoff > 0.0, series.set != TestSet::Static) << series.name;
  }
}

double sumOf(const FittedCurve& curve) {
  return std::accumulate(curve.data.y.begin(), curve.data.y.end(), 0.0);
}

/// The softest sample is the minimum, and the hardest the maximum.
void expectOrdered(const FittedEnvelope& envelope) {
  EXPECT_LT(sumOf(envelope.minimum), sumOf(envelope.average));
  EXPECT_LT(sumOf(envelope.average), sumOf(envelope.maximum));
}

TEST(MaterialFit, OrdersItsEnvelopesBothWays) {
  const auto study = syntheticStudy(1);
  const auto pointwise = fitMaterial(study, {.envelope = EnvelopeRule::Pointwise});
  const auto single = fitMaterial(study, {.envelope = EnvelopeRule::SingleSample});
  for (std::size_t s = 0; s < pointwise.sets.size(); ++s) {
    expectOrdered(single.sets[s].force);
    if (single.sets[s].torque) expectOrdered(*single.sets[s].torque);
    const auto& all = pointwise.sets[s].force;
    for (std::size_t i = 0; i < all.minimum.data.size(); ++i) {
      ASSERT_LE(all.minimum.data.y[i], all.average.data.y[i]);
      ASSERT_LE(all.average.data.y[i], all.maximum.data.y[i]);
      // A single sample lies within what all of them span.
      const auto& one = single.sets[s].force;
      ASSERT_GE(one.minimum.data.y[i], all.minimum.data.y[i]);
      ASSERT_LE(one.maximum.data.y[i], all.maximum.data.y[i]);
    }
  }
}

TEST(MaterialFit, RecoversTheCurveOfOneSpecimen) {
  const SyntheticTest test{.hardness = 0.6, .seed = 4};
  const auto fit = fitMaterial(std::vector{syntheticSeries(test)}, {.wantedError = 0.02});
  const auto truth = noiselessSeries(test);
  ASSERT_EQ(fit.sets.size(), 1U);
  const auto& spline = fit.sets[0].force.average.spline;
  double worst = 0.0;
  for (std::size_t i = 2000; i < truth.force.size(); ++i) {  // after the preload is gone
    worst = std::max(worst, std::abs(spline.at(truth.displacement[i]) - truth.force[i]));
  }
  EXPECT_LT(worst, 0.06 * *std::max_element(truth.force.begin(), truth.force.end()));
}

TEST(MaterialFit, BeginsWhereTheForceDoes) {
  // The noise of the very first sample must not become a step at first touch.
  for (const std::uint64_t seed : {1, 2, 3, 4}) {
    const SyntheticTest test{.seed = seed};
    const auto fit = fitMaterial(std::vector{syntheticSeries(test)}, {});
    EXPECT_NEAR(
        fit.sets[0].force.average.data.y.front(), noiselessSeries(test).force.front(), 0.25);
  }
}

TEST(MaterialFit, MeasuresTheJitterThatItTakesOut) {
  const SyntheticTest test{.seed = 5};
  const auto series = syntheticSeries(test);
  const auto truth = noiselessSeries(test);
  double sum = 0.0;
  for (std::size_t i = 0; i < series.force.size(); ++i) {
    sum += std::pow(series.force[i] - truth.force[i], 2.0);
  }
  const double wanted = std::sqrt(sum / static_cast<double>(series.force.size()));
  const auto fit = fitMaterial(std::vector{series}, {});
  EXPECT_NEAR(fit.sets[0].jitter.rms, wanted, 0.1 * wanted);
  EXPECT_EQ(fit.sets[0].jitter.rate, 100.0);
}

TEST(MaterialFit, SaysWhereCurvesCross) {
  const auto study = syntheticStudy(1);
  const auto single = fitMaterial(study, {.envelope = EnvelopeRule::SingleSample});
  const auto pointwise = fitMaterial(study, {.envelope = EnvelopeRule::Pointwise});
  const auto crossings = crossingsOf(single.sets[1].force, 1.0);
  ASSERT_FALSE(crossings.empty());  // softer specimens of this study begin earlier
  for (const auto& crossing : crossings) EXPECT_LE(crossing.from, crossing.to);
  // Where the data are in order, splines that are 5 % off may still touch.
  EXPECT_TRUE(crossingsOf(pointwise.sets[1].force, 10.0).empty());
}

TEST(MaterialFit, LeavesASetOutOfWhichNothingIsLeft) {
  const std::vector study{syntheticSeries({.mishap = Mishap::FeedChange})};
  const auto fit = fitMaterial(study, {});
  EXPECT_TRUE(fit.sets.empty());
  EXPECT_TRUE(fit.series[0].exclusion.isExcluded());
}

}  // namespace material_fit_test
}  // namespace haptics::reaming
