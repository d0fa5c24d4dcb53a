// K as it is rendered, and forces that do not rest while the hand does.
#include "haptics/engine/rendered_slope.h"

#include <cmath>

#include <gtest/gtest.h>

#include "haptics/devices/iiwa/reamer_kind.h"
#include "haptics/devices/punch/punch_kind.h"
#include "haptics/engine/built_in_models.h"
#include "haptics/engine/compiled_scene.h"

namespace haptics::engine {
namespace rendered_slope_test {

using models::KalmanScheme;

RenderedSlope slopeOf(const ModelSpec& model, double rate) {
  return renderedSlope({.model = model}, devices::punchKind(), rate);
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
        EXPECT_FALSE(slope.isProved);
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
  EXPECT_TRUE(elements.isProved);
  EXPECT_DOUBLE_EQ(elements.steepest, 12.0 / 7.0);
  EXPECT_TRUE(slopeOf(publishedInterpolation(), 1000.0).isProved);
  const MaterialSpec bone{.nodes = parametricMaterial()};
  EXPECT_TRUE(renderedSlope({.model = bone}, devices::reamerKind(), 1000.0).isProved);
}

TEST(RenderedSlope, FindsTheJumpAtTheEndOfACut) {
  auto cut = publishedInterpolation();
  cut.options.extrapolation = models::Extrapolation::Zero;
  const auto slope = slopeOf(cut, 1000.0);
  EXPECT_FALSE(slope.isProved);
  // 5 N within one step of the slowest passage over the end: 10 units/s at 1 kHz is 0.01 units.
  EXPECT_GE(slope.steepest, 5.0 / 0.01 * 0.99);
}

}  // namespace rendered_slope_test
}  // namespace haptics::engine
