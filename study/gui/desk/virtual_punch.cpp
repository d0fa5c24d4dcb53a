#include "study/gui/desk/virtual_punch.h"

#include <utility>

#include "study/session/trial_setup.h"

namespace study::gui {

VirtualPunch::VirtualPunch(protocols::DeviceRequirement need, haptics::engine::SceneSpec scene)
    : need_(std::move(need)),
      scene_(std::move(scene)),
      deviceSet_([this](const auto& wanted) { return hands_.make(wanted); }) {}

VirtualPunch::~VirtualPunch() = default;

void VirtualPunch::begin() {
  samples_.clear();
  trial_ = std::make_unique<Trial>(
      deviceSet_.device(need_),
      Trial::Setup{
          .scene = scene_,
          .limits = limitsOf(need_),
          .storeChunk = [this](int, const std::vector<storage::TraceSample>& chunk) {
            samples_.insert(samples_.end(), chunk.begin(), chunk.end());
          }});
  liveTrial_ = std::make_unique<LiveTrial>(*trial_);
}

TrialRecord VirtualPunch::finish() {
  auto record = liveTrial_->finish(TrialEnding::Finished);
  liveTrial_.reset();
  trial_.reset();
  return record;
}

}  // namespace study::gui
