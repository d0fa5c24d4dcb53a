#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <optional>
#include <thread>

#include "haptics/engine/realtime_loop.h"
#include "haptics/engine/sample_ring.h"
#include "study/trial/trial.h"

namespace study {

/// A trial in real time with three threads: a haptic thread that ticks, a recorder thread that
/// stores the samples it takes from a ring, and the caller, who reads status().
class LiveTrial {
 public:
  /// Begins to tick. The trial must outlive this object.
  explicit LiveTrial(Trial& trial);

  /// Switches the force off and waits for both threads.
  ~LiveTrial();
  LiveTrial(const LiveTrial&) = delete;
  LiveTrial& operator=(const LiveTrial&) = delete;

  /// The present state of the trial.
  struct Status {
    int cuts = 0;
    double travel = 0.0;          ///< [device's travel unit]
    double force = 0.0;           ///< [N]
    std::int64_t sampleTime = 0;  ///< when the device was last read [ns on CLOCK_MONOTONIC]
    bool isCutThrough = false;    ///< the tissue has yielded or the jaws have met since the tool
                                  ///< was last open
    std::uint64_t ticks = 0;
    std::uint64_t lateTicks = 0;
    bool isRealtime = false;
    bool isDeviceGone = false;
    bool isTraceLost = false;
  };
  Status status() const noexcept;

  /// The next sample for a plot. Only one thread may call it; false if there is none.
  bool nextToPlot(haptics::engine::TickSample& sample) noexcept { return plotRing_->pop(sample); }

  /// Switches the force off at once.
  void stop() noexcept { trial_.stop(); }

  /// Stops the loop, stores the remaining samples and returns the record. If the device or the
  /// trace was lost, the record says so instead of @p ending. Call it once.
  TrialRecord finish(TrialEnding ending);

 private:
  /// Holds the samples of one minute at 1 kHz, or of eight seconds at 8 kHz, while a write to the
  /// disk is delayed.
  using Ring = haptics::engine::SampleRing<haptics::engine::TickSample, 65'536>;

  /// One tick, in the haptic thread.
  void tick(double dt, double lateness) noexcept;
  /// Sets isCutThrough_; called in every tick of the haptic thread, also without a landmark.
  void onCutLandmark(haptics::models::CutDetector<double>::Event landmark) noexcept;
  /// The recorder thread: stores samples from the ring until @p stop is requested.
  void record(const std::stop_token& stop);
  /// Stores all samples that are in the ring.
  void drain();

  Trial& trial_;
  std::unique_ptr<Ring> storeRing_ = std::make_unique<Ring>();
  std::unique_ptr<Ring> plotRing_ = std::make_unique<Ring>();
  std::atomic<int> cuts_{0};
  std::atomic<double> travel_{0.0};
  std::atomic<double> force_{0.0};
  std::atomic<std::int64_t> sampleTime_{0};
  std::atomic<bool> isCutThrough_{false};
  std::atomic<bool> isDeviceGone_{false};
  std::atomic<bool> isTraceLost_{false};
  bool isFinished_ = false;
  std::jthread recorder_;
  std::optional<haptics::engine::RealtimeLoop> loop_;  // last, so that it is destroyed first
};

/// Runs @p trial in real time until @p cuts cuts are completed or @p longest [s] have passed.
TrialRecord runRealtime(Trial& trial, int cuts, double longest);

}  // namespace study
