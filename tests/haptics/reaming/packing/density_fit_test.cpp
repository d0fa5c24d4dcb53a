#include "haptics/reaming/packing/density_fit.h"

#include <algorithm>
#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "haptics/reaming/material/synthetic_series.h"
#include "haptics/reaming/packing/packed_bone.h"
#include "haptics/reaming/packing/packing_builder.h"
#include "haptics/reaming/packing/solids.h"

namespace haptics::reaming {
namespace density_fit_test {

struct Problem {
  Packing packing;
  ContactMatrix matrix;
  std::vector<double> depths;
  std::vector<double> forces;
};

const Problem& problem() {
  static const Problem made = [] {
    Problem p{.packing = *pack(Acetabulum(), {.count = 4000})};
    const std::vector<double> ones(p.packing.spheres.size(), 1.0);
    const auto plunge = plungePathInto(SphereField(p.packing, ones), 0.026);
    const auto series = noiselessSeries({.hardness = 0.5});
    for (std::size_t i = 0; i < 100; ++i) {
      const double depth = 0.016 * (static_cast<double>(i) + 0.5) / 100.0;
      const auto at =
          std::lower_bound(series.displacement.begin(), series.displacement.end(), depth);
      p.depths.push_back(depth);
      p.forces.push_back(
          std::max(0.0, series.force[static_cast<std::size_t>(at - series.displacement.begin())]));
    }
    p.matrix = contactMatrix(p.packing, p.packing.coverage(), plunge, p.depths);
    return p;
  }();
  return made;
}

std::vector<double> anyDensities(std::size_t spheres, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> density(0.0, 3e5);
  std::vector<double> densities(spheres);
  for (double& each : densities) each = density(random);
  return densities;
}

TEST(ContactMatrix, EqualsTheForceOfTheField) {
  const auto& p = problem();
  const auto densities = anyDensities(p.packing.spheres.size(), 2);
  const SphereField field(p.packing, densities);
  const auto plunge = plungePathInto(field, 0.026);
  const auto forces = p.matrix.times(densities);
  for (std::size_t k = 0; k < p.depths.size(); ++k) {
    const double felt = -field.touch(plunge.at(p.depths[k]), false).force.z / p.packing.coverage();
    ASSERT_NEAR(forces[k], felt, 1e-4 * felt + 1e-6);
  }
  // Aᵀ is the transpose: y·(A x) = x·(Aᵀ y).
  const auto back = p.matrix.transposedTimes(forces);
  double left = 0.0;
  double right = 0.0;
  for (const double f : forces) left += f * f;
  for (std::size_t i = 0; i < back.size(); ++i) right += back[i] * densities[i];
  EXPECT_NEAR(left, right, 1e-9 * left);
}

TEST(LeverMatrix, EqualsTheLeverOfTheField) {
  const auto& p = problem();
  const auto densities = anyDensities(p.packing.spheres.size(), 3);
  const SphereField field(p.packing, densities);
  const auto plunge = plungePathInto(field, 0.026);
  const auto levers =
      leverMatrix(p.packing, p.packing.coverage(), plunge, p.depths).times(densities);
  for (std::size_t k = 0; k < p.depths.size(); ++k) {
    const double felt = field.touch(plunge.at(p.depths[k]), false).lever / p.packing.coverage();
    ASSERT_NEAR(levers[k], felt, 1e-4 * felt + 1e-8);
  }
}

TEST(ContactMatrix, OfTwoIsOneAboveTheOther) {
  const ContactMatrix one{.rows = 1, .start = {0, 1, 2}, .row = {0, 0}, .value = {1.0, 2.0}};
  const ContactMatrix two{.rows = 2, .start = {0, 1, 1}, .row = {1}, .value = {5.0}};
  const std::vector<double> x{10.0, 100.0};
  EXPECT_EQ(stacked(one, two, 0.5).times(x), (std::vector<double>{210.0, 0.0, 25.0}));
}

TEST(DensityFit, ReachesTheOptimumAndProvesIt) {
  const auto& p = problem();
  const std::vector<double> prior(p.matrix.columns(), uniformDensity(p.matrix, p.forces));
  const double uniform = errorOf(p.matrix, prior, p.forces);
  const auto fit = fitNonNegative(p.matrix, p.forces, prior);
  EXPECT_GT(uniform, 0.2);
  EXPECT_LT(fit.error, 0.002);
  EXPECT_LE(fit.gap, 1e-6);
  for (const double density : fit.densities) ASSERT_GE(density, 0.0);
  // What the experiment never touches keeps its prior.
  for (std::size_t i = 0; i < prior.size(); ++i) {
    if (p.matrix.isTouched(i)) continue;
    ASSERT_EQ(fit.densities[i], prior[i]);
  }
}

TEST(DensityFit, SolvesATinyProblemExactly) {
  // One depth, two spheres, a = (1, 2), F = 10, prior (0, 0): ρ = a F / (λ + |a|²).
  const ContactMatrix matrix{.rows = 1, .start = {0, 1, 2}, .row = {0, 0}, .value = {1.0, 2.0}};
  const std::vector<double> force{10.0};
  const std::vector<double> none{0.0, 0.0};
  const double lambda = 0.1 * 5.0;  // of the mean squared row
  const auto fit = fitNonNegative(matrix, force, none, 0.1);
  EXPECT_NEAR(fit.densities[0], 10.0 / (lambda + 5.0), 1e-9);
  EXPECT_NEAR(fit.densities[1], 20.0 / (lambda + 5.0), 1e-9);
  // A force below 0 asks for densities below 0, and gets none.
  const auto pulled = fitNonNegative(matrix, std::vector<double>{-10.0}, none, 0.1);
  EXPECT_EQ(pulled.densities[0], 0.0);
  EXPECT_EQ(pulled.densities[1], 0.0);
  EXPECT_LE(pulled.gap, 1e-9);
}

/// Spheres in a row, each felt at six depths; those of the first half are nothing before the fit.
struct Row {
  ContactMatrix matrix{.rows = 40, .start = {0}, .row = {}, .value = {}};
  std::vector<double> prior;

  explicit Row(std::uint64_t seed) {
    constexpr std::uint32_t kSpheres = 400;
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> area(0.2, 1.2);
    for (std::uint32_t i = 0; i < kSpheres; ++i) {
      const std::uint32_t first = i * 40 / kSpheres;
      for (std::uint32_t depth = first; depth < std::min(40U, first + 6U); ++depth) {
        matrix.row.push_back(depth);
        matrix.value.push_back(area(random));
      }
      matrix.start.push_back(matrix.row.size());
      prior.push_back(i < kSpheres / 2 ? 0.0 : 1.0);
    }
  }
};

TEST(DensityFit, ReachesTheOptimumFromAZeroPrior) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const Row row(seed);
    std::vector<double> rising;
    for (std::size_t i = 0; i < row.matrix.rows; ++i) {
      rising.push_back(10.0 * static_cast<double>(i));
    }
    const auto fit = fitNonNegative(row.matrix, rising, row.prior);
    EXPECT_LE(fit.gap, 1e-6) << seed;
    EXPECT_LT(fit.error, 0.001) << seed;
  }
}

TEST(DensityFit, ReachesTheOptimumOfACurveThatNoSpheresCanFollow) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const Row row(seed);
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> force(0.0, 100.0);
    std::vector<double> ragged(row.matrix.rows);
    for (double& f : ragged) f = force(random);
    const auto fit = fitNonNegative(row.matrix, ragged, row.prior);
    EXPECT_LE(fit.gap, 1e-6) << seed;
    EXPECT_GT(fit.error, 0.01) << seed;
  }
}

TEST(DensityFit, TheSwarmReachesTheOptimumOfAFewLayersAndNotOfAllSpheres) {
  const auto& p = problem();
  constexpr std::size_t kLayers = 8;
  const auto few = summedByLayer(p.matrix, layersOf(p.matrix, kLayers), kLayers);
  const std::vector<double> prior(kLayers, uniformDensity(p.matrix, p.forces));
  const double best = fitNonNegative(few, p.forces, prior, 1e-9).error;
  const auto swarm = fitSwarm(few, p.forces, {.iterations = 400, .seed = 3});
  EXPECT_LT(swarm.error, 2.0 * best);
  EXPECT_GE(swarm.error, best - 1e-6);
  const auto full = fitSwarm(p.matrix, p.forces, {.iterations = 20, .seed = 3});
  EXPECT_GT(
      full.error,
      100.0 * fitNonNegative(p.matrix, p.forces, std::vector<double>(p.matrix.columns(), prior[0]))
                  .error);
  // The same seed is the same swarm, however many threads it has.
  const auto alone = fitSwarm(few, p.forces, {.iterations = 50, .seed = 3, .threads = 1});
  const auto three = fitSwarm(few, p.forces, {.iterations = 50, .seed = 3, .threads = 3});
  EXPECT_EQ(alone.densities, three.densities);
}

TEST(DensityFit, GoesOnBelowWhatWasTouchedAsInTheDeepestLayerThatWas) {
  const auto& p = problem();
  const auto fit = fitBone(p.matrix, p.forces);
  std::size_t below = 0;
  for (std::size_t i = 0; i < p.matrix.columns(); ++i) {
    if (p.matrix.isTouched(i)) continue;
    ++below;
    ASSERT_GT(fit.densities[i], 0.0) << i;
  }
  EXPECT_GT(below, p.matrix.columns() / 10);
}

TEST(DensityFit, AcceptsACurveOfZero) {
  const auto& p = problem();
  const std::vector<double> nothing(p.forces.size(), 0.0);
  EXPECT_EQ(fitBone(p.matrix, nothing).spheres.error, 0.0);
  const auto swarm = fitSwarm(p.matrix, nothing, {.iterations = 3});
  EXPECT_EQ(swarm.densities.size(), p.matrix.columns());
}

TEST(DensityFit, OfABoneByASwarmGivesEverySphereADensity) {
  const auto& p = problem();
  const auto exact = fitBone(p.matrix, p.forces);
  const auto swarm = fitBoneBySwarm(p.matrix, p.forces, 12, {.iterations = 400, .seed = 3});
  ASSERT_EQ(swarm.densities.size(), p.matrix.columns());
  EXPECT_EQ(swarm.touchedShare, exact.touchedShare);
  // What the layers came to is what the spheres feel like; it comes near the optimum of 12 layers.
  EXPECT_NEAR(errorOf(p.matrix, swarm.densities, p.forces), swarm.spheres.error, 1e-9);
  EXPECT_GE(swarm.spheres.error, exact.layers.error - 1e-6);
  EXPECT_LT(swarm.spheres.error, 2.0 * exact.layers.error);
  const auto alone = fitBoneBySwarm(p.matrix, p.forces, 0, {.iterations = 20});
  ASSERT_EQ(alone.densities.size(), p.matrix.columns());
  EXPECT_NEAR(errorOf(p.matrix, alone.densities, p.forces), alone.spheres.error, 1e-9);
}

TEST(PackedBone, HasTheForceOfItsMaterialAtEveryHardness) {
  PackedBone bone{.packing = problem().packing};
  const auto curve = [](double scale) {
    return CurveNodes{
        {0.0, 0.0, 0.0}, {0.004, 50.0 * scale, 1e4 * scale}, {0.016, 300.0 * scale, 2e4}};
  };
  const HardnessCurves curves{curve(0.2), curve(1.0), curve(2.0)};
  const auto report = fitBoneToMaterial(bone, curves, {}, {.depths = 80});
  ASSERT_EQ(report.curves.size(), 3U);
  EXPECT_GT(report.curves[0].fit.touchedShare, 0.1);
  EXPECT_LT(report.curves[0].fit.touchedShare, 0.6);
  for (const double h : {0.0, 0.3, 0.5, 0.8, 1.0}) {
    const SphereField field(bone.packing, bone.densities(h, 0.5));
    const auto plunge = plungePathInto(field, bone.reamerRadius);
    const auto wanted = curveOf(curves, h);
    for (const double depth : report.curves[0].depths) {
      const double felt = -field.touch(plunge.at(depth), false).force.z / bone.packing.coverage();
      ASSERT_NEAR(felt, 0.5 * forceOf(wanted, depth), 0.5) << h << " " << depth;
    }
  }
}

TEST(VirtualExperiment, ReamsTheCurveThatWasFitted) {
  PackedBone bone{.packing = problem().packing};
  const auto curve = [](double scale) {
    return CurveNodes{
        {0.0, 0.0, 0.0}, {0.004, 50.0 * scale, 1e4 * scale}, {0.012, 300.0 * scale, 2e4}};
  };
  const auto report =
      fitBoneToMaterial(bone, {curve(0.2), curve(1.0), curve(4.0)}, {}, {.depths = 200});
  const auto result = ream(bone, 0.5, {.mostDepth = 0.012});
  EXPECT_EQ(result.stop, "the largest depth");
  EXPECT_GT(result.removedShare, 0.01);
  EXPECT_LT(errorOf(result, report.curves[1].depths, report.curves[1].wanted), 0.02);
  const auto hard = ream(bone, 1.0, {.mostDepth = 0.012});
  EXPECT_EQ(hard.stop, "the largest force");
  EXPECT_NEAR(hard.force.back(), 800.0, 20.0);
}

}  // namespace density_fit_test
}  // namespace haptics::reaming
