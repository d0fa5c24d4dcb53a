// K as it is rendered, and forces that do not rest while the hand does.
#include "haptics/engine/rendered_slope.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "haptics/devices/iiwa/reamer_kind.h"
#include "haptics/devices/punch/punch_kind.h"
#include "haptics/engine/built_in_models.h"
#include "haptics/engine/compiled_scene.h"

namespace haptics::engine {
namespace rendered_slope_test {

using Basis = RenderedSlope::Basis;
using models::KalmanScheme;

RenderedSlope slopeOf(const ModelSpec& model, double rate) {
  return renderedSlope({.model = model}, devices::punchKind(), rate);
}

RenderedSlope slopeOfBone(const ModelSpec& model) {
  return renderedSlope({.model = model}, devices::reamerKind(), 1000.0);
}

/// A material that is not removed, with @p first [N] at its first node.
MaterialSpec materialFrom(double depth, double first) {
  MaterialSpec spec;
  spec.nodes = {{depth, first, first}, {0.01, 60.0, 60.0}, {0.02, 70.0, 70.0}};
  return spec;
}

/// Largest slope of @p spec between travels that are @p step apart, from @p from to @p to, when the
/// tool goes back and forth on every tenth of the way.
double feltSlope(const ModelSpec& spec, double from, double to, double step) {
  CompiledScene scene({.model = spec});
  double steepest = 0.0;
  double force = scene.respond({.travel = from}).force;
  const auto steps = std::lround((to - from) / step);
  for (long i = 1; i <= 10 * steps; ++i) {
    const long phase = i % (2 * steps);
    const long place = phase < steps ? phase : 2 * steps - phase;
    const double next = scene.respond({.travel = from + step * static_cast<double>(place)}).force;
    steepest = std::max(steepest, std::abs(next - force) / step);
    force = next;
  }
  return steepest;
}

TEST(RenderedSlope, FindsTheLimitCycleOfThePapersText) {
  for (const double rate : {375.0, 1000.0}) {
    const auto slope = slopeOf(publishedFilter(KalmanScheme::PaperText, 5), rate);
    ASSERT_TRUE(slope.limitCycle.has_value()) << rate;
    EXPECT_NEAR(slope.limitCycle->frequency, rate / 2.0, 0.01 * rate);
    // Where only one force is there (7 N of the elements, 0 N of the recording beyond its ramp) the
    // two differ most: by K₁ of eq. (16) times 7 N, Q₁₁ / (Q₁₁ + R) = 6.1024 / (6.1024 + 7.742).
    EXPECT_NEAR(slope.limitCycle->amplitude, 7.0 * 6.1024 / (6.1024 + 7.742), 0.01);
    const Passivity passivity{
        .stiffness = slope.steepest, .period = 1.0 / rate, .limitCycle = slope.limitCycle};
    EXPECT_FALSE(passivity.isPassiveWith(1e9));
  }
}

TEST(RenderedSlope, FindsNoLimitCycleInAFilterThatSettles) {
  for (const double rate : {375.0, 1000.0}) {
    for (const auto scheme :
         {KalmanScheme::AuthorsFirmware, KalmanScheme::Sequential, KalmanScheme::SpaceDomain}) {
      for (const auto beyond :
           {models::Extrapolation::RampOut,
            models::Extrapolation::AuthorsClamp,
            models::Extrapolation::Absent}) {
        auto spec = publishedFilter(scheme, 5);
        spec.interpolation.options.extrapolation = beyond;
        const auto slope = slopeOf(spec, rate);
        EXPECT_FALSE(slope.limitCycle.has_value()) << rate << " " << static_cast<int>(scheme);
        EXPECT_EQ(slope.basis, Basis::Swept);
      }
    }
    auto smoothed = publishedFilter(KalmanScheme::PaperText, 5);
    smoothed.smoothing = models::Smoothing::TwoPoint;
    EXPECT_FALSE(slopeOf(smoothed, rate).limitCycle.has_value()) << "two-point hides it";
  }
}

TEST(RenderedSlope, OfAFilterIsSteeperThanTheTwoThatItFuses) {
  const auto spec = publishedFilter(KalmanScheme::AuthorsFirmware, 5);
  const double fused = CompiledScene({.model = spec}).largestStiffness();
  const auto slope = slopeOf(spec, 1000.0);
  EXPECT_GT(slope.steepest, 1.5 * fused);
  const Passivity passivity{.stiffness = slope.steepest, .period = 0.001};
  EXPECT_TRUE(passivity.isPassiveWith(devices::punchKind().mechanism.damping));
}

TEST(RenderedSlope, IsTheBoundOfACurveIfThereIsOne) {
  const auto elements = slopeOf(publishedElements(5), 1000.0);
  EXPECT_EQ(elements.basis, Basis::Proved);
  EXPECT_DOUBLE_EQ(elements.steepest, 12.0 / 7.0);
  EXPECT_EQ(slopeOf(publishedInterpolation(), 1000.0).basis, Basis::Proved);
  const MaterialSpec bone{.nodes = parametricMaterial()};
  EXPECT_EQ(slopeOfBone(bone).basis, Basis::Proved);
}

TEST(RenderedSlope, FindsTheJumpAtTheEndOfACut) {
  auto cut = publishedInterpolation();
  cut.options.extrapolation = models::Extrapolation::Zero;
  const auto slope = slopeOf(cut, 1000.0);
  EXPECT_EQ(slope.basis, Basis::Swept);
  // 5 N within one step of the slowest passage over the end: 10 units/s at 1 kHz is 0.01 units.
  EXPECT_GE(slope.steepest, 5.0 / 0.01 * 0.99);
}

TEST(RenderedSlope, FindsTheJumpWithWhichAMaterialBegins) {
  EXPECT_EQ(slopeOfBone(materialFrom(0.001, 0.0)).basis, Basis::Proved);
  for (const double depth : {0.0, 0.001}) {  // also where the device's travel begins
    const auto slope = slopeOfBone(materialFrom(depth, 50.0));
    EXPECT_EQ(slope.basis, Basis::Swept);
    // 50 N within one step: 10 mm/s at 1 kHz is 10 µm.
    EXPECT_GE(slope.steepest, 50.0 / 10e-6 * 0.99) << depth;
  }
  auto removed = materialFrom(0.001, 50.0);
  removed.isRemoved = true;
  EXPECT_EQ(slopeOfBone(removed).basis, Basis::Proved) << "the spring bounds it";
}

TEST(RenderedSlope, IsOfTheForceWithoutItsJitter) {
  auto spec = materialFrom(0.001, 0.0);
  const auto still = slopeOfBone(spec);
  EXPECT_EQ(still.jitter, 0.0);
  spec.jitter = {.rms = 5.0, .rate = 500.0};
  spec.forceScale = 0.5;
  const auto slope = slopeOfBone(spec);
  EXPECT_DOUBLE_EQ(slope.jitter, 2.5);
  EXPECT_DOUBLE_EQ(slope.steepest, 0.5 * still.steepest);
  EXPECT_FALSE(slope.limitCycle.has_value());
  spec.isRemoved = true;
  EXPECT_DOUBLE_EQ(slopeOfBone(spec).jitter, 2.5);
  const SceneSpec stopped{.model = spec, .reamer = {.speed = 0.0}};
  EXPECT_EQ(renderedSlope(stopped, devices::reamerKind(), 1000.0).jitter, 0.0)
      << "a reamer that stands still renders none";
}

TEST(RenderedSlope, OfHysteresisHoldsWhereTheBranchesAreFarthestApartBetweenNodes) {
  InterpolationSpec cut;
  cut.branches = Branches::Hysteresis;
  // The gap is 0 at every node, and 4.25 N where the ramp of the closing branch ends, at 11.5.
  cut.curve = {{2.0, 0.0}, {9.0, 5.0}, {10.0, 5.0}};
  cut.opening = {{2.0, 0.0}, {9.0, 5.0}, {10.0, 5.0}, {20.0, 0.0}};
  const auto ramp = slopeOf(cut, 1000.0);
  EXPECT_EQ(ramp.basis, Basis::Proved);
  EXPECT_GE(ramp.steepest, feltSlope(cut, 10.8, 11.5, 0.01));
  // Both are clamped to 0.01 N at every node but the highest, and apart where one leaves the clamp.
  cut.options.extrapolation = models::Extrapolation::AuthorsClamp;
  cut.curve = {{2.0, -100.0}, {9.0, 4.0}, {10.0, 0.0}};
  cut.opening = {{2.0, 0.0}, {9.0, 4.0}, {10.0, 0.0}};
  const auto clamped = slopeOf(cut, 1000.0);
  EXPECT_EQ(clamped.basis, Basis::Proved);
  EXPECT_GE(clamped.steepest, feltSlope(cut, 8.5, 8.8, 0.01));
}

TEST(RenderedSlope, OfAPackingThatIsNotRemovedIsSampledAsDeepAsItGoes) {
  const PackingSpec spec{.bone = parametricBone(), .isRemoved = false};
  const auto slope = slopeOfBone(spec);
  EXPECT_EQ(slope.basis, Basis::Sampled);
  EXPECT_GE(slope.steepest * (1.0 + 1e-9), feltSlope(spec, 0.02, 0.04, 20e-6));
}

}  // namespace rendered_slope_test
}  // namespace haptics::engine
