// The visible spheres of a bone, and the changes that are uploaded.
#include "study/gui/scene/shapes/sphere_cloud.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <functional>

#include <gtest/gtest.h>

#include "haptics/engine/built_in_models.h"
#include "study/gui/scene/shapes/bone_tints.h"

namespace study::gui::scene {
namespace sphere_cloud_test {

using haptics::engine::SphereChange;

/// CIE L* of a tint, 0 to 100.
double lightnessOf(Tint tint) {
  const auto linear = [](std::uint8_t channel) {
    const double c = channel / 255.0;
    return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
  };
  const double y =
      0.2126 * linear(tint.red) + 0.7152 * linear(tint.green) + 0.0722 * linear(tint.blue);
  return y > 0.008856 ? 116.0 * std::cbrt(y) - 16.0 : 903.3 * y;
}

/// A renderer's copy of the instances, which counts the bytes it receives.
struct Copy {
  std::vector<SphereInstance> instances;
  std::size_t bytes = 0;

  void take(SphereCloud& cloud) {
    instances.resize(cloud.instances().size());
    const auto sent = cloud.uploadChanges([this](std::size_t first, auto some) {
      std::memcpy(instances.data() + first, some.data(), some.size_bytes());
      bytes += some.size_bytes();
    });
    EXPECT_LE(sent, instances.size());
  }
  bool isLike(const SphereCloud& cloud) const {
    const auto& wanted = cloud.instances();
    return instances.size() == wanted.size() &&
           std::memcmp(instances.data(), wanted.data(), wanted.size() * sizeof wanted[0]) == 0;
  }
};

class SphereCloudTest : public testing::Test {
 protected:
  static SphereCloud::Options seenAs(SphereColours colours) { return {.colours = colours}; }

  /// The slot of a sphere that is drawn at its initial position.
  std::uint32_t slotOf(const SphereInstance& sphere) const {
    for (std::uint32_t slot = 0; slot < field_.slotCount(); ++slot) {
      const auto centre = field_.centre(slot);
      if (std::abs(1000.0 * centre.x - static_cast<double>(sphere.x)) < 1e-4 &&
          std::abs(1000.0 * centre.y - static_cast<double>(sphere.y)) < 1e-4 &&
          std::abs(1000.0 * centre.z - static_cast<double>(sphere.z)) < 1e-4) {
        return slot;
      }
    }
    ADD_FAILURE() << "no such sphere";
    return 0;
  }

  std::shared_ptr<const haptics::reaming::PackedBone> bone_ = haptics::engine::parametricBone();
  haptics::reaming::SphereField field_{bone_->packing, bone_->densities(0.5, 1.0)};
};

TEST_F(SphereCloudTest, DrawsOnlyVisibleSpheres) {
  const SphereCloud cloud(field_, {});
  EXPECT_GT(cloud.shown(), bone_->packing.spheres.size() / 50);
  EXPECT_LT(cloud.shown(), bone_->packing.spheres.size() / 3);
  for (const auto& sphere : cloud.instances())
    EXPECT_GE(sphere.y, 0.0F);  // the half behind the section
  const SphereCloud whole(field_, {.isHalved = false});
  bool isInFront = false;
  for (const auto& sphere : whole.instances()) isInFront |= sphere.y < -1.0F;
  EXPECT_TRUE(isInFront);
}

TEST_F(SphereCloudTest, UploadsEverythingOnceAndThenOnlyChanges) {
  SphereCloud cloud(field_, {});
  Copy copy;
  copy.take(cloud);
  EXPECT_EQ(copy.bytes, cloud.instances().size() * sizeof(SphereInstance));
  copy.bytes = 0;
  copy.take(cloud);
  EXPECT_EQ(copy.bytes, 0U);

  auto sphere = cloud.instances()[10];
  const std::uint32_t slot = slotOf(sphere);
  cloud.apply({slot, {sphere.x / 1000.0F, sphere.y / 1000.0F, sphere.z / 1000.0F, 1e-4F}});
  copy.take(cloud);  // the removed sphere, and those that it uncovers
  EXPECT_GT(copy.bytes, 0U);
  EXPECT_LT(copy.bytes, 300 * sizeof(SphereInstance));
  EXPECT_TRUE(copy.isLike(cloud));
  copy.bytes = 0;
  cloud.apply({slot, {sphere.x / 1000.0F, sphere.y / 1000.0F, sphere.z / 1000.0F, 0.9e-4F}});
  copy.take(cloud);
  EXPECT_EQ(copy.bytes, sizeof(SphereInstance));
  EXPECT_TRUE(copy.isLike(cloud));
}

TEST_F(SphereCloudTest, ShowsWhatIsBehindARemovedSphere) {
  SphereCloud cloud(field_, {});
  constexpr std::size_t kGone = 300;
  const std::size_t before = cloud.shown();
  std::vector<std::uint32_t> taken;
  for (std::size_t i = 0; i < kGone; ++i) taken.push_back(slotOf(cloud.instances()[i]));
  cloud.apply({taken[0], {}});
  EXPECT_EQ(cloud.instances()[0].radius, 0.0F);
  for (const auto slot : taken) cloud.apply({slot, {}});
  EXPECT_GT(cloud.shown(), before - kGone + 50);
}

TEST_F(SphereCloudTest, IsRestoredByAReset) {
  SphereCloud cloud(field_, {});
  const std::size_t before = cloud.shown();
  Copy copy;
  copy.take(cloud);
  for (std::uint32_t slot = 0; slot < 2000; ++slot) cloud.apply({slot, {}});
  copy.take(cloud);
  EXPECT_TRUE(copy.isLike(cloud));
  cloud.apply({SphereChange::kWholeBoneReset, {}});
  EXPECT_EQ(cloud.shown(), before);
  copy.take(cloud);
  EXPECT_TRUE(copy.isLike(cloud));
}

TEST_F(SphereCloudTest, IgnoresAnInvalidSlot) {
  SphereCloud cloud(field_, {});
  const std::size_t before = cloud.shown();
  cloud.apply({static_cast<std::uint32_t>(field_.slotCount()), {}});
  EXPECT_EQ(cloud.shown(), before);
}

TEST_F(SphereCloudTest, ColoursSpheresByDensityOrRemoval) {
  const SphereCloud neutral(field_, seenAs(SphereColours::Neutral));
  const SphereCloud density(field_, seenAs(SphereColours::Density));
  SphereCloud removal(field_, seenAs(SphereColours::Removal));
  ASSERT_EQ(neutral.instances().size(), density.instances().size());
  EXPECT_NE(neutral.instances()[7].tint.green, density.instances()[7].tint.green);
  auto sphere = removal.instances()[7];
  const Tint before = sphere.tint;
  removal.apply(
      {slotOf(sphere), {sphere.x / 1000.0F, sphere.y / 1000.0F, sphere.z / 1000.0F, 1e-5F}});
  EXPECT_LT(lightnessOf(removal.instances()[7].tint), lightnessOf(before) - 20.0);
  EXPECT_GT(lightnessOf(before), 75.0) << "untouched bone is ivory";
}

TEST(BoneTints, ChangeEvenlyInLightnessFromEndToEnd) {
  const auto removalFromTheEnd = [](float share) { return removalTint(1.0F - share); };
  struct Scale {
    std::function<Tint(float)> tint;
    double darkest;  // largest lightness of its darker end
  };
  // The scale of hardness begins lighter, so that soft bone can be told apart on a dark ground.
  for (const auto& [scale, darkest] : {Scale{scaleTint, 45.0}, Scale{removalFromTheEnd, 25.0}}) {
    double before = lightnessOf(scale(0.0F));
    EXPECT_LT(before, darkest);
    for (int i = 1; i <= 20; ++i) {
      const double lightness = lightnessOf(scale(static_cast<float>(i) / 20.0F));
      EXPECT_GT(lightness, before + 1.2) << i;
      before = lightness;
    }
    EXPECT_GT(before, 85.0);
  }
}

TEST(BoneTints, HaveAScaleWithRoundMarks) {
  const auto expectRange = [](DensityRange range, double softest, double hardest, double step) {
    EXPECT_DOUBLE_EQ(range.softest, softest);
    EXPECT_DOUBLE_EQ(range.hardest, hardest);
    EXPECT_DOUBLE_EQ(range.step, step);
  };
  expectRange(roundedRange(0.3e3, 183.2e3), 0.0, 200e3, 50e3);
  expectRange(roundedRange(1.2e6, 4.9e6), 1e6, 5e6, 1e6);
  expectRange(roundedRange(97.0, 103.0), 96.0, 104.0, 2.0);
  for (const double same : {0.0, 1.0, 7.3e6}) {
    const auto range = roundedRange(same, same);
    EXPECT_LE(range.softest, same);
    EXPECT_GE(range.hardest, same);
    EXPECT_GT(range.hardest, range.softest);
  }
}

TEST(BoneTints, DistinguishRemovedFromUntouchedForTheColourBlind) {
  for (int i = 0; i <= 40; ++i) {
    const Tint tint = removalTint(static_cast<float>(i) / 40.0F);
    // Red-blind and green-blind eyes see lightness, and blue against yellow.
    const Tint none = untouchedTint();
    const double light = lightnessOf(tint) - lightnessOf(none);
    const auto yellow = [](Tint t) { return 0.5 * (t.red + t.green) - t.blue; };
    const double hue = 100.0 * (yellow(tint) - yellow(none)) / 255.0;
    EXPECT_GT(std::hypot(light, hue), 20.0) << i;
  }
}

TEST_F(SphereCloudTest, LightsSpheresWhoseNeighboursHaveGone) {
  SphereCloud cloud(field_, {});
  const auto greenAt = [&](const SphereInstance& place) {
    for (const auto& sphere : cloud.instances()) {
      const bool isThere =
          sphere.x == place.x && sphere.y == place.y && sphere.z == place.z && sphere.radius > 0.0F;
      if (isThere) return static_cast<int>(sphere.tint.green);
    }
    return -1;
  };
  // A dark one lies in a gap; all spheres within 3 mm of it are taken away.
  const auto dark = *std::min_element(
      cloud.instances().begin(), cloud.instances().end(), [](const auto& a, const auto& b) {
        return a.tint.green < b.tint.green;
      });
  const std::uint32_t kept = slotOf(dark);
  const int before = greenAt(dark);
  for (std::uint32_t slot = 0; slot < field_.slotCount(); ++slot) {
    const auto centre = field_.centre(slot);
    const double away = std::hypot(
        1000.0 * centre.x - static_cast<double>(dark.x),
        1000.0 * centre.y - static_cast<double>(dark.y),
        1000.0 * centre.z - static_cast<double>(dark.z));
    if (slot != kept && away < 6.0) cloud.apply({slot, {}});
  }
  EXPECT_GT(greenAt(dark), before + 20);
}

TEST_F(SphereCloudTest, ReproducesItsStateInASecondCloud) {
  SphereCloud cloud(field_, {});
  EXPECT_TRUE(cloud.changesSoFar().empty());
  for (std::uint32_t slot = 0; slot < 2000; slot += 2) cloud.apply({slot, {}});
  auto sphere = cloud.instances()[10];
  cloud.apply({slotOf(sphere), {0.01F, 0.02F, 0.03F, 2e-4F}});
  SphereCloud other(field_, {});
  for (const auto& change : cloud.changesSoFar()) other.apply(change);
  EXPECT_EQ(other.shown(), cloud.shown());
  EXPECT_EQ(other.changesSoFar().size(), cloud.changesSoFar().size());
  cloud.apply({SphereChange::kWholeBoneReset, {}});
  EXPECT_TRUE(cloud.changesSoFar().empty());
}

}  // namespace sphere_cloud_test
}  // namespace study::gui::scene
