#include "study/trial/rig.h"

#include "protocols/orders/random_stream.h"

namespace study {
namespace {

using haptics::devices::DeviceKind;
using haptics::devices::SimulatedHand;

}  // namespace

haptics::devices::Device& SimulatedRig::device(const protocols::DeviceNeed& need) {
  auto& held = open_[need.id];
  if (!held.device) {
    const bool isPunch = need.kind == DeviceKind::Punch;
    held.hand = handFor_(need);
    held.device = std::make_unique<haptics::devices::SimulatedDevice>(
        isPunch ? haptics::devices::simulatedPunch() : haptics::devices::simulatedReamer(),
        isPunch ? haptics::devices::punchMechanism() : haptics::devices::reamerMechanism(),
        *held.hand);
  }
  return *held.device;
}

void SimulatedRig::unplug(const std::string& id) {
  const auto held = open_.find(id);
  if (held != open_.end()) held->second.device->unplug();
}

void SimulatedRig::plugIn(const std::string& id) {
  const auto held = open_.find(id);
  if (held != open_.end()) held->second.device->plugIn();
}

std::unique_ptr<haptics::devices::Hand> simulatedHandFor(
    const protocols::DeviceNeed& need,
    std::uint64_t seed,
    const std::string& cohort,
    std::uint64_t slot) {
  protocols::RandomStream random(seed, slot, "hand/" + cohort + "/" + need.id);
  SimulatedHand::Person person;
  person.pauseTime = random.uniform(0.2, 0.6);
  person.holdTime = random.uniform(0.1, 0.3);
  if (need.kind == DeviceKind::Punch) {
    person.closed = random.uniform(13.3, 14.3);
    person.closeTime = random.uniform(0.4, 1.2);
    person.openTime = random.uniform(0.3, 0.7);
    person.stiffness = random.uniform(2.6, 3.6);
    person.damping = random.uniform(0.08, 0.16);
  } else {
    person.closed = random.uniform(0.034, 0.042);
    person.closeTime = random.uniform(1.2, 2.2);
    person.openTime = random.uniform(0.8, 1.4);
    person.stiffness = random.uniform(5500.0, 7000.0);
    person.damping = random.uniform(120.0, 180.0);
  }
  person.variation = random.uniform(0.1, 0.25);
  person.seed = random.bits();
  return std::make_unique<SimulatedHand>(person);
}

std::unique_ptr<haptics::devices::PointerHand> pointerHandFor(const protocols::DeviceNeed& need) {
  using haptics::devices::PointerHand;
  return need.kind == DeviceKind::Punch
             ? std::make_unique<PointerHand>(PointerHand::Grip{})
             : std::make_unique<PointerHand>(
                   PointerHand::Grip{.stiffness = 6000.0, .damping = 150.0, .speed = 0.03});
}

double farthestFor(const protocols::DeviceNeed& need) noexcept {
  return need.kind == DeviceKind::Punch ? 13.8 : 0.038;
}

}  // namespace study
