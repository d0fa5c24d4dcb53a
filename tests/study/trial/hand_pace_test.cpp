// How fast a simulated hand reams: below what the reamer's teeth can take.
#include <algorithm>
#include <limits>

#include <gtest/gtest.h>

#include "haptics/devices/iiwa/reamer_kind.h"
#include "haptics/engine/built_in_models.h"
#include "protocols/load_protocol.h"
#include "study/trial/device_set.h"
#include "study/trial/trial.h"

namespace study {
namespace hand_pace_test {

namespace engine = haptics::engine;

protocols::Protocol libraryProtocol(const std::string& name) {
  questionnaires::Problems problems;
  const auto loaded = protocols::loadProtocolFile(name, problems);
  EXPECT_TRUE(loaded.has_value()) << describe(problems.all());
  return loaded ? loaded->protocol : protocols::Protocol();
}

TEST(HandPace, IsThatOfTheSlowestReamerOnTheDevice) {
  auto protocol = libraryProtocol("two-devices");
  EXPECT_DOUBLE_EQ(feedLimitOn(protocol, "reamer"), 0.002);
  EXPECT_EQ(feedLimitOn(protocol, "punch"), std::numeric_limits<double>::infinity());
  for (auto& condition : protocol.conditions) {
    if (condition.id == "bone-soft") condition.reamer.teeth = 2;
  }
  EXPECT_DOUBLE_EQ(feedLimitOn(protocol, "reamer"), 0.001);
}

/// A trial of two strokes in bone of a hardness, and the fastest that the tool advanced [m/s].
struct Reamed {
  TrialRecord record;
  double fastest = 0.0;
};

Reamed ream(double hardness, std::uint64_t slot) {
  const protocols::DeviceRequirement need{
      .id = "reamer",
      .kind = &haptics::devices::reamerKind(),
      .maxForce = 140.0,
      .maxForceRate = 5000.0};
  const engine::MaterialSpec bone{
      .nodes = engine::parametricMaterial(),
      .hardness = hardness,
      .forceScale = 0.15,
      .isRemoved = true};
  const auto hand = simulatedHandFor(need, 1, "surgeons", slot, engine::Reamer().mostFeed());
  haptics::devices::SimulatedDevice device(*need.kind, *hand);
  Reamed reamed;
  Trial trial(
      device,
      {.scene = {.model = bone},
       .limits = {.maxForce = need.maxForce, .maxRate = need.maxForceRate, .maxVelocity = 1.0},
       .storeChunk = [&](int, const std::vector<storage::TraceSample>& samples) {
         for (const auto& sample : samples) {
           reamed.fastest = std::max(reamed.fastest, double{sample.velocity});
         }
       }});
  reamed.record = runOffline(trial, 2, 120.0);
  return reamed;
}

TEST(HandPace, LetsASimulatedHandFinishItsStrokesBelowTheFeedOfTheReamer) {
  for (const double hardness : {0.0, 1.0}) {
    for (std::uint64_t slot = 0; slot < 4; ++slot) {
      const auto reamed = ream(hardness, slot);
      EXPECT_EQ(reamed.record.ending, TrialEnding::Finished) << hardness << " " << slot;
      EXPECT_LT(reamed.fastest, 1.05 * engine::Reamer().mostFeed()) << hardness << " " << slot;
      // A stroke goes 8 mm into the bone: two take eight seconds at least.
      EXPECT_GT(reamed.record.duration, 8.0);
      EXPECT_EQ(reamed.record.saturated, 0.0);
    }
  }
}

}  // namespace hand_pace_test
}  // namespace study
