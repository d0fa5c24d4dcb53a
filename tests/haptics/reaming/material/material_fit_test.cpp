#include "haptics/reaming/material/material_fit.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <gtest/gtest.h>

#include "haptics/reaming/material/synthetic_series.h"
#include "tests/support/long_form.h"

namespace haptics::reaming {
namespace material_fit_test {

/// The fit of all 72 series: it takes seconds, and tests in one process share it.
const MaterialFit& fitOfStudy() {
  static const MaterialFit fit = fitMaterial(syntheticStudy(1), {});
  return fit;
}

TEST(WholeStudyFit, HasThreeTestSets) {
  const auto& fit = fitOfStudy();
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

TEST(WholeStudyFit, FiltersOnlyReamedSeries) {
  for (const auto& series : fitOfStudy().series) {
    if (series.exclusion.isExcluded()) continue;
    EXPECT_EQ(series.cutoff > 0.0, series.set != TestSet::Static) << series.name;
  }
}

/// Six specimens with their three tests each.
std::vector<Series> sixSpecimens() {
  std::vector<Series> all;
  for (int i = 0; i < 6; ++i) {
    SyntheticTest test{.hardness = 0.1 + 0.16 * i, .feed = 0.03e-3};
    for (const TestSet set : {TestSet::Static, TestSet::Dynamic1, TestSet::Dynamic2}) {
      test.set = set;
      test.seed = static_cast<std::uint64_t>(10 * i) + static_cast<std::uint64_t>(set);
      all.push_back(syntheticSeries(test));
    }
  }
  return all;
}

TEST(MaterialFit, OrdersItsEnvelopesBothWays) {
  const auto study = sixSpecimens();
  const auto pointwise = fitMaterial(study, {.envelope = EnvelopeRule::Pointwise});
  const auto single = fitMaterial(study, {.envelope = EnvelopeRule::SingleSample});
  for (std::size_t s = 0; s < pointwise.sets.size(); ++s) {
    const auto& all = pointwise.sets[s].force;
    const auto& one = single.sets[s].force;
    EXPECT_TRUE(all.isOrdered);
    EXPECT_FALSE(one.isOrdered);
    for (std::size_t i = 0; i < all.minimum.data.size(); ++i) {
      ASSERT_LE(all.minimum.data.y[i], all.average.data.y[i]);
      ASSERT_LE(all.average.data.y[i], all.maximum.data.y[i]);
    }
    // Where all specimens are measured, a single one lies within what they span.
    for (std::size_t i = 0; all.measured[i] == all.measured[0]; ++i) {
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

TEST(MaterialFit, KeepsItsCurvesInOrderEverywhere) {
  const auto study = sixSpecimens();
  for (const auto spline : {SplineKind::HermiteDataSlope, SplineKind::Pchip, SplineKind::Makima}) {
    for (const double wanted : {0.3, 0.05}) {
      const auto fit = fitMaterial(study, {.spline = spline, .wantedError = wanted});
      for (const auto& set : fit.sets) {
        for (const auto* envelope : {&set.force, set.torque ? &*set.torque : &set.force}) {
          EXPECT_TRUE(envelope->isOrdered);
          EXPECT_LE(envelope->minimum.error.floored, wanted);
          EXPECT_LE(envelope->average.error.floored, wanted);
          EXPECT_LE(envelope->maximum.error.floored, wanted);
          for (int i = 0; i <= 20'000; ++i) {
            const double x = set.scale * i / 20'000.0;
            const double middle = envelope->average.spline.at(x);
            ASSERT_LE(envelope->minimum.spline.at(x), middle + 1e-9) << x;
            ASSERT_LE(middle, envelope->maximum.spline.at(x) + 1e-9) << x;
          }
        }
      }
    }
  }
}

/// Force = start + slope · depth, over 1001 samples.
Series ramp(double start, double slope, double end) {
  Series series{.set = TestSet::Static};
  for (int i = 0; i <= 1000; ++i) {
    series.displacement.push_back(end * i / 1000.0);
    series.force.push_back(start + slope * series.displacement.back());
  }
  return series;
}

TEST(MaterialFit, ReportsWhereCurvesCrossAndTheRemedy) {
  const std::vector study{ramp(30.0, 10e3, 0.010), ramp(10.0, 20e3, 0.010)};
  const FitOptions options{
      .envelope = EnvelopeRule::SingleSample, .spline = SplineKind::NaturalCubic};
  const auto fit = fitMaterial(study, options);
  const auto crossings = crossingsOf(fit.sets[0].force, 1.0);
  ASSERT_EQ(crossings.size(), 1U);  // to 2 mm, where both have 50 N
  EXPECT_EQ(crossings[0].from, 0.0);
  EXPECT_NEAR(crossings[0].to, 0.002, 0.0002);
  EXPECT_EQ(
      optionsAgainstCrossing(options),
      (std::vector<std::string>{"--envelope pointwise", "--spline hermite-data-slope"}));
  // What is on is not recommended.
  EXPECT_TRUE(optionsAgainstCrossing({}).empty());
  EXPECT_EQ(
      optionsAgainstCrossing({.nodeCount = 12}), (std::vector<std::string>{"--nodes greedy"}));
}

TEST(WholeStudyFit, LeavesOutNoSpecimenThatEndedAtItsForceLimit) {
  const auto& fit = fitOfStudy();
  const auto left = specimenCountsOf(fit.sets[0].force);
  EXPECT_EQ(left.front().measured, 24);
  EXPECT_EQ(left.front().held, 0);
  for (const auto& stretch : left) EXPECT_EQ(stretch.measured + stretch.held, 24);
  EXPECT_EQ(left.back().measured, 1);
  // Those that stalled leave.
  const auto reamed = specimenCountsOf(fit.sets[1].force);
  EXPECT_EQ(reamed.front().measured, 22);
  EXPECT_LT(reamed.back().measured, 22);
  for (const auto& stretch : reamed) EXPECT_EQ(stretch.held, 0);
}

TEST(MaterialFit, FiltersATorqueByItsOwnSpectrum) {
  auto series = syntheticSeries({.seed = 6});
  const auto before = prepared(series, {});
  std::reverse(series.torque.begin(), series.torque.end());
  for (double& torque : series.torque) torque = torque * torque;
  const auto after = prepared(series, {});
  EXPECT_EQ(after.cutoff, before.cutoff);
  EXPECT_EQ(
      after.torqueCutoff,
      filters::cutoffOf(series.torque, series.rate, filters::CutoffRule::Floor));
  EXPECT_NE(after.torqueCutoff, after.cutoff);
  const auto asked = prepared(series, {.cutoff = 0.2, .torqueCutoff = 0.3});
  EXPECT_EQ(asked.cutoff, 0.2);
  EXPECT_EQ(asked.torqueCutoff, 0.3);
}

TEST(MaterialFit, NormalisesInBothReadingsOfThePaper) {
  // A stiff specimen that ended at half the depth of a soft one.
  const std::vector study{ramp(0.0, 160e3, 0.005), ramp(0.0, 80e3, 0.010)};
  const auto maximumAt = [&](DepthAxis axis, double x) {
    const auto fit = fitMaterial(study, {.axis = axis, .wantedError = 1e-3});
    return fit.sets[0].force.maximum.spline.at(x);
  };
  EXPECT_NEAR(maximumAt(DepthAxis::Depth, 0.004), 640.0, 1.0);
  EXPECT_NEAR(maximumAt(DepthAxis::Normalised, 0.004), 640.0, 1.0);
  EXPECT_NEAR(maximumAt(DepthAxis::NormalisedSeries, 0.004), 320.0, 1.0);
  // Beyond the stiff one's end it is held at its limit, absent, or still there, stretched.
  EXPECT_NEAR(maximumAt(DepthAxis::Depth, 0.008), 800.0, 1.0);
  EXPECT_NEAR(maximumAt(DepthAxis::Normalised, 0.008), 640.0, 1.0);
  EXPECT_NEAR(maximumAt(DepthAxis::NormalisedSeries, 0.008), 640.0, 1.0);
}

TEST(MaterialFit, TakesTheNodesOfAnotherSpline) {
  const std::vector study{syntheticSeries({.set = TestSet::Static, .seed = 4})};
  const std::size_t count = tests::isLong() ? 12 : 6;
  const auto nodesWith = [&](SplineKind spline, std::optional<SplineKind> nodesOf) {
    const auto fit = fitMaterial(study, {.nodeCount = count, .spline = spline, .nodesOf = nodesOf});
    std::vector<double> depths;
    for (const auto& node : fit.sets[0].force.maximum.spline.nodes) depths.push_back(node.position);
    return depths;
  };
  const auto ofCubic = nodesWith(SplineKind::NaturalCubic, {});
  EXPECT_EQ(ofCubic.size(), count);
  EXPECT_EQ(nodesWith(SplineKind::HermiteDataSlope, SplineKind::NaturalCubic), ofCubic);
  EXPECT_NE(nodesWith(SplineKind::HermiteDataSlope, {}), ofCubic);
}

TEST(MaterialFit, LeavesOutASetWithoutValidSeries) {
  const std::vector study{syntheticSeries({.simulatedFault = SyntheticFault::FeedChange})};
  const auto fit = fitMaterial(study, {});
  EXPECT_TRUE(fit.sets.empty());
  EXPECT_TRUE(fit.series[0].exclusion.isExcluded());
}

}  // namespace material_fit_test
}  // namespace haptics::reaming
