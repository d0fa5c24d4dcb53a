#pragma once

#include <memory>
#include <vector>

#include "protocols/model/protocol.h"
#include "study/trial/device_set.h"
#include "study/trial/live_trial.h"
#include "study/trial/trial.h"

namespace study::gui {

/// A virtual punch that is moved with the mouse. It ticks at 1 kHz as in a study and keeps the
/// recording in memory only.
class VirtualPunch {
 public:
  /// @param need, scene  from a sound protocol.
  VirtualPunch(protocols::DeviceRequirement need, haptics::engine::SceneSpec scene);
  ~VirtualPunch();

  const haptics::devices::DeviceKind& kind() const noexcept { return *need_.kind; }

  bool isRunning() const noexcept { return liveTrial_ != nullptr; }
  void begin();
  /// Sets the wanted hand position, from 0 (open) to 1 (closed).
  void moveTo(double share) { hands_.moveTo(need_, share); }
  LiveTrial::Status status() const {
    return liveTrial_ ? liveTrial_->status() : LiveTrial::Status{};
  }
  bool nextToPlot(haptics::engine::TickSample& sample) {
    return liveTrial_ && liveTrial_->nextToPlot(sample);
  }
  TrialRecord finish();

  /// The recording of the last trial.
  const std::vector<storage::TraceSample>& samples() const noexcept { return samples_; }

 private:
  protocols::DeviceRequirement need_;
  haptics::engine::SceneSpec scene_;
  PointerHands hands_;
  SimulatedDeviceSet deviceSet_;
  std::vector<storage::TraceSample> samples_;
  std::unique_ptr<Trial> trial_;
  std::unique_ptr<LiveTrial> liveTrial_;  // declared after the trial, so that it is destroyed first
};

}  // namespace study::gui
