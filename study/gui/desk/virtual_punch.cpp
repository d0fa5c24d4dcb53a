#include "study/gui/desk/virtual_punch.h"

#include <utility>

namespace study::gui {

VirtualPunch::VirtualPunch(protocols::DeviceRequirement need, haptics::engine::SceneSpec scene)
    : need_(std::move(need)),
      scene_(std::move(scene)),
      deviceSet_(
          [this](const protocols::DeviceRequirement& wanted)
              -> std::unique_ptr<haptics::devices::Hand> {
            auto hand = pointerHandFor(wanted);
            hand_ = hand.get();
            return hand;
          }) {}

VirtualPunch::~VirtualPunch() = default;

void VirtualPunch::begin() {
  samples_.clear();
  trial_ = std::make_unique<Trial>(
      deviceSet_.device(need_),
      Trial::Setup{
          .scene = scene_,
          .limits =
              {.maxForce = need_.maxForce,
               .maxRate = need_.maxForceRate,
               .maxTorque = need_.maxTorque,
               .maxTorqueRate = need_.maxTorqueRate,
               .maxVelocity = need_.maxVelocity,
               .isPassivityControlled = need_.isPassivityControlled},
          .storeChunk = [this](int, const std::vector<storage::TraceSample>& chunk) {
            samples_.insert(samples_.end(), chunk.begin(), chunk.end());
          }});
  liveTrial_ = std::make_unique<LiveTrial>(*trial_);
}

void VirtualPunch::moveTo(double share) {
  if (hand_ != nullptr) hand_->moveTo(share * pointerReachFor(need_));
}

TrialRecord VirtualPunch::finish() {
  auto record = liveTrial_->finish(TrialEnding::Finished);
  liveTrial_.reset();
  trial_.reset();
  return record;
}

}  // namespace study::gui
