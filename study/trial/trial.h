#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include "haptics/engine/compiled_scene.h"
#include "haptics/engine/force_engine.h"
#include "haptics/engine/rendered_slope.h"
#include "study/model/trial_record.h"
#include "study/storage/trace_store.h"

namespace study {

/// Counts what happens in a trial while it is recorded.
class TrialStatistics {
 public:
  /// @param rate  of the ticks [Hz].
  TrialStatistics(const haptics::devices::DeviceKind& device, double rate);

  void add(const haptics::engine::TickSample& sample);

  /// Writes the results into @p record, but not the timing of the loop or the number of stored
  /// samples.
  void fillIn(TrialRecord& record) const;

 private:
  double rate_;
  haptics::engine::CutDetector detector_;
  std::vector<TrialRecord::Cut> cuts_;
  std::int64_t ticks_ = 0;
  std::int64_t invalid_ = 0;
  std::int64_t saturated_ = 0;
  std::int64_t slewed_ = 0;
  std::int64_t undefined_ = 0;
  std::int64_t contact_ = 0;
  void count(SafetyKind kind, bool isNow);

  /// Occurrences of one safety function.
  struct Tally {
    std::int64_t times = 0;
    std::int64_t ticks = 0;
    bool wasActiveBefore = false;  ///< whether it was active in the previous tick
  };

  double largestForce_ = 0.0;
  double leastEnergy_ = 0.0;
  std::int64_t torqueSaturated_ = 0;
  double largestTorque_ = 0.0;
  double leastRotationEnergy_ = 0.0;
  std::array<Tally, 13> tallies_{};  ///< by SafetyKind
};

/// One condition on one device, ready to be rendered and recorded, in real and in simulated
/// sessions. The haptic thread calls step() and the recorder thread calls keep(); a simulation
/// calls both in turn.
class Trial {
 public:
  /// Stores a chunk of about one second of samples; may throw storage::StorageError.
  using StoreChunk =
      std::function<void(int number, const std::vector<storage::TraceSample>& samples)>;

  /// What a trial renders, with which limits, and how samples are stored.
  struct Setup {
    haptics::engine::SceneSpec scene;
    haptics::engine::SafetyLimits limits;
    StoreChunk storeChunk;
    bool needsDevice = false;  ///< somebody is to feel the force: a simulated device will not do
  };

  /// Builds the scene and arms the device, which must be open and outlive the trial.
  /// @throws std::invalid_argument  for an invalid scene or limits; the validation of the protocol
  ///     finds those earlier.
  /// @throws haptics::devices::DeviceError  if the device is not ready.
  Trial(haptics::devices::Device& device, Setup setup);

  /// Disarms the device.
  ~Trial();
  Trial(const Trial&) = delete;
  Trial& operator=(const Trial&) = delete;

  double rate() const noexcept { return device_.capabilities().rate; }
  /// The device's own pacer if it has one; otherwise nullptr, and a timer sets the pace.
  haptics::devices::Pacer* pacer() const noexcept { return device_.pacer(); }
  const haptics::engine::CompiledScene& scene() const noexcept { return scene_; }

  /// One tick of @p dt [s], after @p missedPeriods periods without a tick. Never allocates, waits
  /// or throws.
  haptics::engine::TickSample step(double dt, int missedPeriods = 0) noexcept {
    return engine_.tick(dt, missedPeriods);
  }

  /// May be called by any thread: switches the force off at once.
  void stop() noexcept { engine_.stop(); }
  bool isStopped() const noexcept { return engine_.isStopped(); }

  /// May be called by any thread: switches the reamer on or off, as a pedal does. It is on
  /// initially.
  void switchReamer(bool isOn) noexcept { engine_.switchReamer(isOn); }

  /// Records a tick. @throws storage::StorageError  if a chunk could not be stored.
  void keep(const haptics::engine::TickSample& sample);

  /// Stores the remaining samples and returns the record. Call it once, after the last step().
  TrialRecord finish(TrialEnding ending);

 private:
  /// Stores the samples of the present chunk.
  void keepChunk();

  haptics::devices::Device& device_;
  haptics::engine::CompiledScene scene_;
  haptics::engine::RenderedSlope slope_;  ///< of the scene, at the device's rate
  haptics::engine::ForceEngine engine_;
  StoreChunk storeChunk_;
  bool lacksDevice_;
  TrialStatistics statistics_;
  std::vector<storage::TraceSample> chunk_;
  int chunks_ = 0;
  std::int64_t storedSamples_ = 0;
};

/// The record of a trial of which only the stored samples are left: what can be counted in them.
/// @param rate  of the ticks [Hz]
TrialRecord recordFrom(
    const std::vector<storage::TraceSample>& samples,
    const haptics::devices::DeviceKind& device,
    double rate);

/// Runs @p trial with the device's simulated hand, as fast as this computer can, until @p cuts cuts
/// are completed and the tool is open again, or @p longest [s] of simulated time have passed.
TrialRecord runOffline(Trial& trial, int cuts, double longest);

}  // namespace study
