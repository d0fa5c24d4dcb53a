#pragma once

#include <functional>
#include <vector>

#include "haptics/engine/compiled_scene.h"
#include "haptics/engine/force_engine.h"
#include "haptics/engine/rendered_slope.h"
#include "study/model/trial_record.h"
#include "study/storage/trace_store.h"
#include "study/trial/trial_statistics.h"

namespace study {

/// One condition on one device, ready to be felt and recorded: the same for a study day and for a
/// simulated cohort. step() belongs to the haptic thread, keep() to the recorder's; a simulation
/// calls both in turn.
class Trial {
 public:
  /// Keeps a chunk of about a second of what was felt; may throw storage::StorageError.
  using Keep = std::function<void(int number, const std::vector<storage::TraceSample>& samples)>;

  struct Setup {
    haptics::engine::SceneSpec scene;
    haptics::engine::SafetyLimits limits;
    Keep keep;
  };

  /// Builds the scene and arms the device, which is open and outlives the trial.
  /// @throws std::invalid_argument  for a scene or limits that are not sound: the protocol's check
  ///                                refuses those before.
  /// @throws haptics::devices::DeviceError  if the device is not ready, in words.
  Trial(haptics::devices::Device& device, Setup setup);

  /// Lets go of the tool.
  ~Trial();
  Trial(const Trial&) = delete;
  Trial& operator=(const Trial&) = delete;

  double rate() const noexcept { return device_.capabilities().rate; }
  /// What sets the pace, where it is the device; otherwise nothing, and a timer does.
  haptics::devices::Pacer* pacer() const noexcept { return device_.pacer(); }
  const haptics::engine::CompiledScene& scene() const noexcept { return scene_; }

  /// One tick of @p dt [s], after @p missedPeriods that the clock let pass. Never allocates, waits
  /// or throws.
  haptics::engine::TickSample step(double dt, int missedPeriods = 0) noexcept {
    return engine_.tick(dt, missedPeriods);
  }

  /// Any thread: no force at once.
  void stop() noexcept { engine_.stop(); }
  bool isStopped() const noexcept { return engine_.isStopped(); }

  /// Records a tick. @throws storage::StorageError  if a chunk could not be kept.
  void keep(const haptics::engine::TickSample& sample);

  /// Keeps what is left, and says what happened. Once, when nobody steps any more.
  TrialRecord finish(TrialEnding ending);

 private:
  void keepChunk();

  haptics::devices::Device& device_;
  haptics::engine::CompiledScene scene_;
  haptics::engine::RenderedSlope slope_;  ///< of the scene, at the device's rate
  haptics::engine::ForceEngine engine_;
  Keep keep_;
  TrialStatistics statistics_;
  std::vector<storage::TraceSample> chunk_;
  int chunks_ = 0;
  std::int64_t kept_ = 0;
};

/// Lets the device's (simulated) hand feel @p trial as fast as this computer goes, until it has cut
/// @p cuts times and opened again, or @p longest [s] of its own time have passed.
TrialRecord runOffline(Trial& trial, int cuts, double longest);

}  // namespace study
