#include "study/app/scene_play.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "haptics/engine/built_in_models.h"
#include "study/model/user_error.h"

namespace study::app {
namespace scene_play_test {

std::vector<PlayedCurve> playReamed(double from, double speed) {
  const haptics::engine::PackingSpec reamed{
      .bone = haptics::engine::parametricBone(), .forceScale = 0.15};
  const auto profile = profileOf({.least = from, .most = 0.02, .speed = speed});
  return play("reamed", "Reamed", {.model = reamed}, profile, false);
}

TEST(ScenePlay, AReamedBoneGivesAForceInEveryStepAtAnySpeed) {
  // In every tick the bone checks 16,384 of its 20,000 spheres for the tool being outside. At 0.05
  // m/s the second tick is already inside.
  for (const double speed : {0.001, 0.005, 0.05}) {
    const auto curves = playReamed(0.0, speed);
    ASSERT_EQ(curves.size(), 1U);
    const auto& force = curves.front().force;
    EXPECT_TRUE(std::all_of(force.begin(), force.end(), [](double f) { return std::isfinite(f); }))
        << speed;
    EXPECT_GT(*std::max_element(force.begin(), force.end()), 10.0) << speed;
  }
}

TEST(ScenePlay, RefusesABoneInWhichTheToolBegins) {
  EXPECT_THROW(playReamed(0.005, 0.005), UserError);
}

}  // namespace scene_play_test
}  // namespace study::app
