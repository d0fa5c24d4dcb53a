#include "study/trial/device_set.h"

#include "base/random.h"

namespace study {

using haptics::devices::SimulatedHand;
haptics::devices::Device& SimulatedDeviceSet::device(const protocols::DeviceNeed& need) {
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

std::unique_ptr<haptics::devices::Hand> simulatedHandFor(
    const protocols::DeviceNeed& need,
    std::uint64_t seed,
    const std::string& cohort,
    std::uint64_t slot) {
  base::RandomStream random(seed, slot, "hand/" + cohort + "/" + need.id);
  const auto from = [&](const haptics::devices::DeviceKind::Range& range) {
    return random.uniform(range.least, range.most);
  };
  const auto& hand = need.kind->hand;
  SimulatedHand::Person person;
  person.pauseTime = random.uniform(0.2, 0.6);
  person.holdTime = random.uniform(0.1, 0.3);
  person.closed = from(hand.reach);
  person.closeTime = from(hand.closeTime);
  person.openTime = from(hand.openTime);
  person.stiffness = from(hand.stiffness);
  person.damping = from(hand.damping);
  person.variation = random.uniform(0.1, 0.25);
  person.seed = random.bits();
  return std::make_unique<SimulatedHand>(person);
}

std::unique_ptr<haptics::devices::PointerHand> pointerHandFor(const protocols::DeviceNeed& need) {
  return std::make_unique<haptics::devices::PointerHand>(need.kind->grip);
}

double farthestFor(const protocols::DeviceNeed& need) noexcept {
  return need.kind->hand.ordinaryReach;
}

}  // namespace study
