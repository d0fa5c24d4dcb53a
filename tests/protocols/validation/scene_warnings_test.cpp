// A filter that listens to one of its forces only is no fusion; its researcher should know.
#include <gtest/gtest.h>

#include "haptics/engine/punch_models.h"
#include "haptics/recordings/cut.h"
#include "protocols/model/messages.h"
#include "protocols/reading/cut_file.h"
#include "protocols/validation/validation.h"

namespace protocols {
namespace scene_warnings_test {

using haptics::engine::InterpolationSpec;
using haptics::engine::KalmanSpec;
using haptics::models::KalmanScheme;
using haptics::models::ProcessNoiseReading;

KalmanSpec filter(KalmanScheme scheme, double interpolationNoise) {
  KalmanSpec spec{
      .noise = haptics::models::KalmanNoise<double>::published(ProcessNoiseReading::StateOrder),
      .scheme = scheme};
  spec.noise.interpolation = interpolationNoise;
  return spec;
}

std::vector<questionnaires::Problem> warningsOf(auto model) {
  Protocol protocol;
  protocol.conditions.push_back({.id = "a", .model = std::move(model)});
  questionnaires::Problems problems;
  addSceneWarnings(protocol, problems);
  return problems.all();
}

TEST(SceneWarnings, ComputesTheWeightOfTheInterpolation) {
  // The weights of the four schemes with the published noise, and of space-domain at equal R.
  using haptics::engine::interpolationWeight;
  EXPECT_NEAR(interpolationWeight(filter(KalmanScheme::PaperText, 7.742)), 0.22, 0.03);
  EXPECT_NEAR(interpolationWeight(filter(KalmanScheme::AuthorsFirmware, 7.742)), 0.46, 0.05);
  EXPECT_LT(interpolationWeight(filter(KalmanScheme::Sequential, 7.742)), 0.001);
  EXPECT_LT(interpolationWeight(filter(KalmanScheme::SpaceDomain, 7.742)), 0.001);
  EXPECT_NEAR(interpolationWeight(filter(KalmanScheme::SpaceDomain, 0.001)), 0.5, 1e-6);
}

TEST(SceneWarnings, WarnsOfAFilterThatUsesOneForceOnly) {
  EXPECT_TRUE(warningsOf(filter(KalmanScheme::AuthorsFirmware, 7.742)).empty());
  EXPECT_TRUE(warningsOf(filter(KalmanScheme::SpaceDomain, 0.001)).empty());
  const auto deaf = warningsOf(filter(KalmanScheme::SpaceDomain, 7.742));
  ASSERT_EQ(deaf.size(), 1U);
  EXPECT_EQ(deaf[0].path, "$.conditions[0].scene.parameters");
  EXPECT_EQ(deaf[0].what, message("cut_not_felt"));
  const auto other = warningsOf(filter(KalmanScheme::SpaceDomain, 1e-7));
  ASSERT_EQ(other.size(), 1U);
  EXPECT_EQ(other[0].what, message("elements_not_felt"));
}

TEST(SceneWarnings, WarnsOfACutThatAsksForMoreThanItsDeviceMayGive) {
  InterpolationSpec spec{.curve = {{0.0, 0.0}, {4.0, 6.0}, {6.0, 12.0}, {7.0, 9.0}, {9.0, 1.0}}};
  Protocol protocol;
  protocol.devices.push_back({.id = "punch", .maxForce = 8.0});
  protocol.conditions.push_back({.id = "a", .device = "punch", .model = spec});
  questionnaires::Problems problems;
  addSceneWarnings(protocol, problems);
  const auto said = problems.all();
  ASSERT_EQ(said.size(), 1U);
  EXPECT_EQ(said[0].path, "$.conditions[0].scene.parameters");
  EXPECT_EQ(said[0].what, message("cut_beyond_limit", "12", "8", "6", "7"));
  protocol.devices[0].maxForce = 12.0;
  questionnaires::Problems none;
  addSceneWarnings(protocol, none);
  EXPECT_TRUE(none.all().empty());
}

TEST(SceneWarnings, WarnsOfAnOpeningThatGivesBackMoreThanClosingTook) {
  const auto cut = haptics::recordings::parametricCut();
  InterpolationSpec spec{.curve = nodesOf(cut.curve)};
  spec.branches = haptics::engine::Branches::Hysteresis;
  spec.opening = nodesOf(*cut.opening);
  EXPECT_TRUE(warningsOf(spec).empty());
  for (auto& node : spec.opening) node.force += 0.5;
  const auto said = warningsOf(spec);
  ASSERT_EQ(said.size(), 1U);
  EXPECT_NE(base::describe(said[0].what).find("0.5"), std::string::npos)
      << base::describe(said[0].what);
  spec.branches = haptics::engine::Branches::ClosingOnly;
  EXPECT_TRUE(warningsOf(spec).empty());
}

TEST(SceneWarnings, WarnsOfAnOpeningThatGivesBackMoreBetweenItsPoints) {
  InterpolationSpec spec{.curve = {{2.0, 0.0}, {6.0, 1.0}, {10.0, 5.0}}};
  spec.branches = haptics::engine::Branches::Hysteresis;
  spec.opening = {{2.0, 0.0}, {10.0, 5.0}};
  const auto said = warningsOf(spec);
  ASSERT_EQ(said.size(), 1U);
  EXPECT_NE(base::describe(said[0].what).find("1.500 N"), std::string::npos)
      << base::describe(said[0].what);
}

}  // namespace scene_warnings_test
}  // namespace protocols
