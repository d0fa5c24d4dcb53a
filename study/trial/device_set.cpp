#include "study/trial/device_set.h"

#include <algorithm>

#include "base/random.h"

namespace study {

using haptics::devices::SimulatedHand;
haptics::devices::Device& SimulatedDeviceSet::device(const protocols::DeviceRequirement& need) {
  auto& held = open_[need.id];
  if (!held.device) {
    held.hand = handFor_(need);
    held.device = std::make_unique<haptics::devices::SimulatedDevice>(*need.kind, *held.hand);
  }
  return *held.device;
}

void SimulatedDeviceSet::unplug(const std::string& id) {
  const auto held = open_.find(id);
  if (held != open_.end()) held->second.device->unplug();
}

void SimulatedDeviceSet::plugIn(const std::string& id) {
  const auto held = open_.find(id);
  if (held != open_.end()) held->second.device->plugIn();
}

namespace {

/// Slows a hand to the feed of a reamer: the speed of its target stays below @p mostFeed [m/s]. The
/// movement is shortened, too, to about the depth at which most bone is reamed in one stroke.
void limitToFeed(SimulatedHand::Person& person, double mostFeed) {
  constexpr double kPeakSpeedOfMinimumJerk = 1.875;
  constexpr double kShareOfFeed = 0.9;
  constexpr double kShareOfReach = 0.55;
  const auto timeFor = [&](double distance) {
    return kPeakSpeedOfMinimumJerk * distance / (kShareOfFeed * mostFeed);
  };
  if (!(mostFeed > 0.0) || timeFor(person.closed - person.open) <= person.closeTime) return;
  person.closed = person.open + kShareOfReach * (person.closed - person.open);
  person.closeTime = std::max(person.closeTime, timeFor(person.closed - person.open));
}

}  // namespace

double feedLimitOn(const protocols::Protocol& protocol, const std::string& device) {
  double slowest = std::numeric_limits<double>::infinity();
  for (const auto& condition : protocol.conditions) {
    if (condition.device != device) continue;
    slowest = std::min(slowest, haptics::engine::largestFeedOf(condition.scene()));
  }
  return slowest;
}

std::unique_ptr<haptics::devices::Hand> simulatedHandFor(
    const protocols::DeviceRequirement& need,
    std::uint64_t seed,
    const std::string& cohort,
    std::uint64_t slot,
    double mostFeed) {
  base::RandomStream random(seed, slot, "hand/" + cohort + "/" + need.id);
  const auto draw = [&](const haptics::devices::DeviceKind::Range& range) {
    return random.uniform(range.least, range.most);
  };
  const auto& hand = need.kind->hand;
  SimulatedHand::Person person;
  person.pauseTime = random.uniform(0.2, 0.6);
  person.holdTime = random.uniform(0.1, 0.3);
  person.closed = draw(hand.reach);
  person.closeTime = draw(hand.closeTime);
  person.openTime = draw(hand.openTime);
  person.stiffness = draw(hand.stiffness);
  person.damping = draw(hand.damping);
  person.variation = random.uniform(0.1, 0.25);
  person.seed = random.bits();
  limitToFeed(person, mostFeed);
  return std::make_unique<SimulatedHand>(person);
}

double pointerReachFor(const protocols::DeviceRequirement& need) noexcept {
  return need.kind->hand.typicalReach;
}

std::unique_ptr<haptics::devices::Hand> PointerHands::make(
    const protocols::DeviceRequirement& need) {
  auto hand = std::make_unique<haptics::devices::PointerHand>(need.kind->grip);
  hands_[need.id] = hand.get();
  return hand;
}

void PointerHands::moveTo(const protocols::DeviceRequirement& need, double share) {
  const auto hand = hands_.find(need.id);
  if (hand != hands_.end()) hand->second->moveTo(share * pointerReachFor(need));
}

}  // namespace study
