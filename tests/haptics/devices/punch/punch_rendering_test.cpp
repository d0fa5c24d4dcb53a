// Scenes that the board of a punch renders by itself.
#include <algorithm>
#include <cmath>
#include <utility>

#include <gtest/gtest.h>

#include "haptics/recordings/cut.h"
#include "tests/haptics/devices/punch/emulated_punch.h"

namespace haptics::devices {
namespace punch_rendering_test {

using namespace emulated_punch;

class PunchRenderingTest : public EmulatedPunch {};

engine::InterpolationSpec recordedCut() {
  engine::InterpolationSpec spec;
  const auto cut = recordings::parametricCut();
  for (const auto& node : cut.curve.nodes()) spec.curve.push_back({node.travel, node.force});
  return spec;
}

TEST_F(PunchRenderingTest, LetsTheBoardRenderAsTheEngineWould) {
  connect({});
  device_->open();
  const engine::FiniteElementsSpec spec;
  device_->renderOnDevice({.model = spec}, 7.5);
  device_->arm();
  board_->hold();
  const models::FiniteElements<double> elements(spec.parameters);
  models::FiniteElements<double>::State state;
  double most = 0.0;
  int settled = 20;
  std::int64_t last = timing::now();
  for (int i = 0; i < 1400; ++i) {
    const auto sample = turn(7.5);  // as much as the board may give
    timing::sleepUntil(soon(kMillisecond / 2));
    ASSERT_FALSE(isFaulted()) << base::describe(device_->fault());
    // Where we were late the board has let go, and comes back as fast as it may.
    if (timing::now() - std::exchange(last, timing::now()) > 5 * kMillisecond) settled = i + 20;
    if (i < settled || sample.status != DeviceStatus::Ok) continue;
    const double counts = std::round(board_->travel() / kTravelPerCount);
    const double expected =
        std::clamp(elements.at(kTravelPerCount * counts, state).force, -7.5, 7.5);
    ASSERT_NEAR(board_->force(), expected, 0.0015 * kNewtonsPerVolt) << i;
    most = std::max(most, board_->force());
  }
  EXPECT_NEAR(most, 7.0, 0.001);
  EXPECT_EQ(device_->lifecycle(), Lifecycle::Running);
}

TEST_F(PunchRenderingTest, LetsTheBoardRenderNoMoreThanTheEngineLetsThrough) {
  connect({});
  device_->open();
  device_->renderOnDevice({.model = engine::FiniteElementsSpec{}}, 7.5);
  device_->arm();
  board_->hold();
  double most = 0.0;
  for (int i = 0; i < 1200; ++i) {
    turn(0.0);
    most = std::max(most, std::abs(board_->force()));
  }
  EXPECT_EQ(most, 0.0) << "stopped, and felt all the same";
  for (int i = 0; i < 1200; ++i) {
    turn(2.0);
    timing::sleepUntil(soon(kMillisecond / 4));  // the voltage takes its time
    most = std::max(most, std::abs(board_->force()));
  }
  EXPECT_GT(most, 2.0);
  EXPECT_LE(most, 1.25 * 2.0 + 0.3 + 0.001);
}

TEST_F(PunchRenderingTest, SendsEverySceneThatFits) {
  connect(atRest());
  device_->open();
  engine::KalmanSpec both;
  both.interpolation = recordedCut();
  EXPECT_EQ(whyNot([&] { device_->renderOnDevice({.model = recordedCut()}, 8.0); }), "");
  EXPECT_EQ(whyNot([&] { device_->renderOnDevice({.model = both}, 8.0); }), "");
}

TEST_F(PunchRenderingTest, SaysWhichScenesStayWithTheHost) {
  connect(atRest());
  device_->open();
  const auto refused = [&](const auto& model) {
    return whyNot([&] { device_->renderOnDevice({.model = model}, 8.0); });
  };
  auto hysteresis = recordedCut();
  hysteresis.branches = engine::Branches::Hysteresis;
  EXPECT_TRUE(says(refused(hysteresis), "an opening branch"));
  engine::InterpolationSpec longer;
  for (int i = 0; i < 129; ++i) longer.curve.push_back({0.1 * i, 1.0});
  EXPECT_TRUE(says(refused(longer), "more than 128 points"));
  engine::FiniteElementsSpec uneven;
  uneven.elementStiffnesses = {1.0, 2.0, 3.0, 2.0, 1.0};
  EXPECT_TRUE(says(refused(uneven), "different stiffness"));
  engine::KalmanSpec smooth;
  smooth.interpolation = recordedCut();
  smooth.smoothing = models::Smoothing::TwoPoint;
  EXPECT_TRUE(says(refused(smooth), "smoothing"));
  EXPECT_TRUE(says(refused(engine::MaterialSpec{}), "bone"));
  engine::FiniteElementsSpec unsound;
  unsound.parameters.toolPosition = unsound.parameters.end;
  EXPECT_TRUE(says(refused(unsound), "unsound"));
}

TEST_F(PunchRenderingTest, FaultsWhenTheBoardDoesNotConfirmAScene) {
  connect(atRest());
  device_->open();
  board_->order("mute 1000");
  EXPECT_TRUE(says(
      whyNot([&] { device_->renderOnDevice({.model = recordedCut()}, 8.0); }), "does not answer"));
  EXPECT_TRUE(waitUntil([&] { return isFaulted(); }));
  EXPECT_TRUE(says(
      whyNot([&] { device_->renderOnDevice({.model = recordedCut()}, 8.0); }), "is not ready"));
}

}  // namespace punch_rendering_test
}  // namespace haptics::devices
