#include "haptics/registry/device_kinds.h"

#include <cmath>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "haptics/devices/hand.h"
#include "haptics/devices/simulated_device.h"
#include "haptics/models/cut_detector.h"

namespace haptics {
namespace device_kinds_test {

using devices::DeviceKind;

class EveryDeviceKind : public testing::TestWithParam<std::string> {
 protected:
  static const DeviceKind& kind() { return *deviceKindNamed(GetParam()); }
};

TEST_P(EveryDeviceKind, IsFoundByItsName) {
  ASSERT_NE(deviceKindNamed(GetParam()), nullptr);
  EXPECT_EQ(kind().name, GetParam());
}

TEST_P(EveryDeviceKind, HasFactsThatFitTogether) {
  EXPECT_LT(kind().travel.least, kind().travel.most);
  EXPECT_GT(kind().travel.fastest, kind().travel.playSpeed);
  EXPECT_GT(kind().travel.playSpeed, 0.0);
  EXPECT_FALSE(kind().travel.unit.empty());
  EXPECT_FALSE(kind().travel.unitName.empty());
  EXPECT_GT(kind().shown.factor, 0.0);
  EXPECT_GT(kind().plot.force, 0.0);
  EXPECT_GE(kind().plot.travel, kind().shown.factor * kind().travel.most);
  EXPECT_GT(kind().simulatedMaxForce, 0.0);
  EXPECT_LT(kind().stroke.openBelow, kind().stroke.closedAbove);
  EXPECT_LT(kind().stroke.closedAbove, kind().travel.most);
  EXPECT_GT(kind().hand.typicalReach, kind().travel.most);
  if (kind().wire != devices::Wire::Serial) return;
  EXPECT_NE(kind().serial.travelPerCount, 0.0);
  EXPECT_LE(kind().serial.plausibleTravel.least, kind().travel.least);
  EXPECT_GE(kind().serial.plausibleTravel.most, kind().travel.most);
}

TEST_P(EveryDeviceKind, HasItsWordsAlsoInOtherLanguages) {
  for (const auto* text :
       {&kind().strokeName, &kind().strokesName, &kind().strokeHint, &kind().pointerHint}) {
    EXPECT_FALSE(text->in("en").empty());
    for (const auto& [language, words] : text->others()) EXPECT_FALSE(words.empty()) << language;
    EXPECT_EQ(text->in("de-CH"), text->in("de"));
    EXPECT_EQ(text->in("fi"), text->in("en"));
  }
}

TEST_P(EveryDeviceKind, CountsTheStrokesOfAnOrdinaryHand) {
  devices::SimulatedHand hand(
      {.closed = kind().hand.typicalReach,
       .pauseTime = 0.3,
       .closeTime = 1.0,
       .holdTime = 0.2,
       .openTime = 0.5,
       .stiffness = kind().grip.stiffness,
       .damping = kind().grip.damping});
  devices::SimulatedDevice device(kind(), hand);
  models::CutDetector<double> detector(kind().stroke);
  int strokes = 0;
  for (int tick = 0; tick < 6000; ++tick) {
    const auto sample = device.read(0.001);
    ASSERT_EQ(sample.status, devices::DeviceStatus::Ok);
    EXPECT_LT(std::abs(sample.velocity), kind().travel.fastest);
    const auto event = detector.feed(sample.travel, 0.0);
    strokes += event == models::CutDetector<double>::Event::CutCompleted ? 1 : 0;
  }
  EXPECT_EQ(strokes, 3);
}

std::vector<std::string> names() {
  std::vector<std::string> names;
  for (const auto* kind : deviceKinds()) names.emplace_back(kind->name);
  return names;
}
INSTANTIATE_TEST_SUITE_P(
    Registered, EveryDeviceKind, testing::ValuesIn(names()), [](const auto& each) {
      return each.param;
    });

TEST(DeviceKinds, HaveNamesOfTheirOwn) {
  std::set<std::string_view> names;
  for (const auto* kind : deviceKinds()) names.insert(kind->name);
  EXPECT_EQ(names.size(), deviceKinds().size());
  EXPECT_EQ(deviceKindNamed("spoon"), nullptr);
}

}  // namespace device_kinds_test
}  // namespace haptics
