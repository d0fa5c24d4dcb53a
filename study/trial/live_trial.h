#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <thread>

#include "haptics/engine/realtime_loop.h"
#include "haptics/engine/sample_ring.h"
#include "study/trial/trial.h"

namespace study {

/// A trial at the pace of a clock: a haptic thread that ticks, a recorder's thread that keeps what
/// it is handed through a ring, and the caller who looks on.
class LiveTrial {
 public:
  /// Begins to tick. The trial outlives it.
  explicit LiveTrial(Trial& trial);

  /// Lets go, and waits for both threads.
  ~LiveTrial();
  LiveTrial(const LiveTrial&) = delete;
  LiveTrial& operator=(const LiveTrial&) = delete;

  /// How things are, for whoever looks on.
  struct Status {
    int cuts = 0;
    double travel = 0.0;          ///< [device's travel unit]
    double force = 0.0;           ///< [N]
    std::int64_t sampleTime = 0;  ///< when the device was last read [ns on CLOCK_MONOTONIC]
    bool isCutThrough = false;    ///< the tissue has yielded, or the jaws have met, in this closure
    std::uint64_t ticks = 0;
    std::uint64_t lateTicks = 0;
    bool isRealtime = false;
    bool isDeviceGone = false;
    bool isTraceLost = false;
  };
  Status status() const noexcept;

  /// The next sample that nobody has looked at, for a plot. One caller only; false where there is
  /// none.
  bool nextToPlot(haptics::engine::TickSample& sample) noexcept { return toPlot_->pop(sample); }

  /// No force at once.
  void stop() noexcept { trial_.stop(); }

  /// Stops ticking, keeps what is left, says what happened; what went wrong in between wins over
  /// @p ending. Once.
  TrialRecord finish(TrialEnding ending);

 private:
  /// A minute at 1 kHz, eight seconds at 8 kHz: longer than a disk holds its breath.
  using Ring = haptics::engine::SampleRing<haptics::engine::TickSample, 65'536>;

  void tick(double dt, double lateness) noexcept;
  void followTheCut(haptics::models::CutDetector<double>::Event landmark) noexcept;
  void record(const std::stop_token& stop);
  void drain();

  Trial& trial_;
  std::unique_ptr<Ring> toKeep_ = std::make_unique<Ring>();
  std::unique_ptr<Ring> toPlot_ = std::make_unique<Ring>();
  std::atomic<int> cuts_{0};
  std::atomic<double> travel_{0.0};
  std::atomic<double> force_{0.0};
  std::atomic<std::int64_t> sampleTime_{0};
  std::atomic<bool> isCutThrough_{false};
  std::atomic<bool> isDeviceGone_{false};
  std::atomic<bool> isTraceLost_{false};
  bool isFinished_ = false;
  std::jthread recorder_;
  std::optional<haptics::engine::RealtimeLoop> loop_;  // last: the first to go
};

/// Lets whoever holds the device feel @p trial, until it has cut @p cuts times or @p longest [s]
/// have passed.
TrialRecord runRealtime(Trial& trial, int cuts, double longest);

}  // namespace study
