#pragma once

#include <atomic>
#include <cstdint>
#include <optional>
#include <string>

#include "haptics/devices/device.h"
#include "haptics/engine/compiled_scene.h"
#include "haptics/engine/force_engine.h"
#include "haptics/engine/realtime_loop.h"

namespace haptics::bench {

/// The scene that is rendered while a connection is measured: for meniscus five finite elements;
/// for bone the hardest parametric material, at 15 % of its force.
engine::SceneSpec sceneForLink(devices::Tissue tissue);

/// Results of a run with a device, from arming it to the end.
struct LinkRun {
  devices::LinkReport link;
  engine::RealtimeLoop::Report loop;  ///< includes ticks after a fault
  bool isRealtime = false;            ///< real-time priority was granted
  std::uint64_t ticks = 0;            ///< until the device failed or the run ended
  std::uint64_t missedPeriods = 0;    ///< until the device failed or the run ended
  double seconds = 0.0;               ///< until the device failed or the run ended
  double processor = 0.0;             ///< processor time of this process, all threads [s]
  std::string fault;                  ///< the fault that ended the run early; empty: none
};

/// A real-time loop at the pace of a device, with a force engine and a scene.
class LinkLoop {
 public:
  /// Arms @p device, which must be open and outlive this object, and starts the loop.
  /// @throws devices::DeviceError  if the device cannot be armed.
  explicit LinkLoop(devices::Device& device);
  ~LinkLoop();
  LinkLoop(const LinkLoop&) = delete;
  LinkLoop& operator=(const LinkLoop&) = delete;

  /// Whether the device has failed or is gone. Any thread.
  bool isOver() const noexcept { return isOver_.load(std::memory_order_acquire); }

  /// Orders a stall: one tick takes @p duration [ns] longer. It is the first tick in which a force
  /// above 5 % of the maximum begins to fall; after three seconds without such a tick, any tick.
  /// Any thread.
  void orderStall(std::int64_t duration) noexcept;
  /// When the last ordered stall began [ns on CLOCK_MONOTONIC]; 0: not yet. Any thread.
  std::int64_t stalledAt() const noexcept { return stalledAt_.load(std::memory_order_acquire); }

  /// Stops the loop, disarms the device and returns the results. To be called once.
  LinkRun finish();

 private:
  /// One period of the loop, of @p dt [s], that begins @p lateness [µs] after it was due.
  void tick(double dt, double lateness) noexcept;
  bool isStallDue(double force) noexcept;

  devices::Device& device_;
  double leastStallForce_;  ///< least force at which a stall begins [N]
  double lastForce_ = 0.0;  ///< [N]
  engine::CompiledScene scene_;
  engine::ForceEngine engine_;
  std::atomic<bool> isOver_{false};
  std::atomic<std::int64_t> orderedAt_{0};      ///< time at which the stall was ordered [ns]
  std::atomic<std::int64_t> stallDuration_{0};  ///< duration of the ordered stall [ns]
  std::atomic<std::int64_t> stalledAt_{0};      ///< [ns]
  LinkRun run_;
  std::int64_t begin_ = 0;  ///< time of arming [ns]
  double processorBefore_ = 0.0;
  std::optional<engine::RealtimeLoop> loop_;  ///< last, so that it is destroyed first
};

}  // namespace haptics::bench
