// What a trial records of a torque about the tool's axis, and says where the device renders none.
#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include <gtest/gtest.h>

#include "haptics/devices/iiwa/reamer_kind.h"
#include "haptics/devices/simulated_device.h"
#include "haptics/engine/built_in_models.h"
#include "study/trial/device_set.h"
#include "study/trial/hardware_device_set.h"
#include "study/trial/trial.h"

namespace study {
namespace torque_trial_test {

using haptics::devices::Finding;
using storage::TraceSample;

bool says(const TrialRecord::Judgement& judgement, std::string_view key) {
  return std::any_of(judgement.reasons.begin(), judgement.reasons.end(), [&](const auto& reason) {
    return reason.key() == key;
  });
}

/// A bone whose torque is 0.028 m times its force, on a simulated reamer.
class TorqueTrialTest : public testing::Test {
 protected:
  TrialRecord felt(double maxTorque, double speed) {
    auto capabilities = haptics::devices::simulated(haptics::devices::reamerKind());
    capabilities.maxTorque = maxTorque;
    haptics::devices::SimulatedDevice device(
        capabilities, haptics::devices::reamerKind().mechanism, *hand_);
    const haptics::engine::MaterialSpec bone{
        .nodes = haptics::engine::parametricMaterial(), .forceScale = 0.15};
    Trial trial(
        device,
        {.scene = {.model = bone, .reamer = {.speed = speed}},
         .limits = {.maxForce = 140.0, .maxRate = 5000.0},
         .storeChunk = [this](int, const std::vector<TraceSample>& samples) {
           samples_.insert(samples_.end(), samples.begin(), samples.end());
         }});
    return runOffline(trial, 1, 20.0);
  }

  protocols::DeviceRequirement need_{
      .id = "arm",
      .kind = &haptics::devices::reamerKind(),
      .maxForce = 140.0,
      .maxForceRate = 5000.0,
      .needsTorque = true};
  std::unique_ptr<haptics::devices::Hand> hand_ = simulatedHandFor(need_, 7, "surgeons", 0);
  std::vector<TraceSample> samples_;
};

TEST_F(TorqueTrialTest, RecordsTheTorqueOfEachSample) {
  const auto record = felt(10.0, 5.0);
  EXPECT_TRUE(record.hasTorque);
  EXPECT_TRUE(record.isTorqueRendered);
  EXPECT_FALSE(says(record.judgement(), "trial.no_torque"));
  double largest = 0.0;
  for (const auto& sample : samples_) {
    ASSERT_LE(sample.torque, 0.0F) << "it is against the spin";
    largest = std::max(largest, -static_cast<double>(sample.torque));
  }
  EXPECT_GT(largest, 0.1);
  EXPECT_NEAR(record.largestTorque, largest, 1e-6);
  EXPECT_LT(record.leastRotationEnergy, 0.0) << "the wrist yields to a reamer that is driven";
}

TEST_F(TorqueTrialTest, SaysWhereTheDeviceRendersNoTorque) {
  const auto record = felt(0.0, 5.0);
  EXPECT_TRUE(record.hasTorque);
  EXPECT_FALSE(record.isTorqueRendered);
  const auto judgement = record.judgement();
  EXPECT_EQ(judgement.verdict, Verdict::Warn);
  EXPECT_TRUE(says(judgement, "trial.no_torque")) << base::describe(judgement.reasons);
  EXPECT_NE(base::describe(judgement.reasons).find("not rendered: torque"), std::string::npos);
  float asked = 0.0F;
  for (const auto& sample : samples_) {
    ASSERT_EQ(sample.torque, 0.0F);
    asked = std::min(asked, sample.desiredTorque);
  }
  EXPECT_LT(asked, -0.1F);
}

TEST_F(TorqueTrialTest, RecordsNoneOfAReamerThatStandsStill) {
  const auto record = felt(10.0, 0.0);
  EXPECT_FALSE(record.hasTorque);
  EXPECT_EQ(record.largestTorque, 0.0);
  for (const auto& sample : samples_) {
    ASSERT_EQ(sample.desiredTorque, 0.0F);
    ASSERT_EQ(sample.torque, 0.0F);
  }
}

TEST_F(TorqueTrialTest, IsPreparedByAPreflightThatNamesTheMissingTorque) {
  const auto torqueOf = [&](double maxTorque) {
    auto capabilities = haptics::devices::simulated(haptics::devices::reamerKind());
    capabilities.maxTorque = maxTorque;
    haptics::devices::SimulatedDevice device(
        capabilities, haptics::devices::reamerKind().mechanism, *hand_);
    protocols::Protocol protocol;
    protocol.devices = {need_};
    return preflight(device, &protocol, need_.id, 0.1).back();
  };
  EXPECT_EQ(torqueOf(10.0).finding, Finding::Pass);
  EXPECT_EQ(torqueOf(1.0).finding, Finding::Warn) << "less than the protocol's limit of 5 N·m";
  EXPECT_EQ(torqueOf(0.0).finding, Finding::Warn);
  EXPECT_EQ(base::describe(torqueOf(0.0).measured), "not rendered: torque");
}

}  // namespace torque_trial_test
}  // namespace study
