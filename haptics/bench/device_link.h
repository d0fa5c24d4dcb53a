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

/// What a hand feels while a link is measured: five springs in a row; of bone a
/// parametric material, as hard as can be, at 15 % of its force.
engine::SceneSpec sceneForLink(devices::Tissue tissue);

/// What came of ticking at a device, from arming it to its end.
struct LinkRun {
  devices::LinkReport link;
  engine::RealtimeLoop::Report loop;  ///< also of ticks after a fault, until the end
  bool isRealtime = false;            ///< what was asked for was granted
  std::uint64_t ticks = 0;            ///< while it was there
  std::uint64_t missedPeriods = 0;    ///< while it was there
  double seconds = 0.0;               ///< while it was there
  double begunAfter = 0.0;            ///< from arming to the first tick [s]
  double processor = 0.0;             ///< time that this process, all of it, had meanwhile [s]
  std::string fault;                  ///< what ended it before its time; empty: nothing did
};

/// A loop at the pace of a device, with a force engine and something to feel.
class LinkLoop {
 public:
  /// Arms @p device, which is open, and outlives this.
  /// @throws devices::DeviceError  if it takes no forces.
  explicit LinkLoop(devices::Device& device);
  ~LinkLoop();
  LinkLoop(const LinkLoop&) = delete;
  LinkLoop& operator=(const LinkLoop&) = delete;

  /// Any thread: the device has failed, or is gone.
  bool isOver() const noexcept { return isOver_.load(std::memory_order_acquire); }

  /// Any thread: a tick is to take @p duration [ns] longer, as soon as a force of 5 % of the
  /// largest begins to fall; after three seconds without one, any tick.
  void stallTick(std::int64_t duration) noexcept;
  /// Any thread: when it began to stand still as it was told last [ns on CLOCK_MONOTONIC]; 0: it
  /// has not yet.
  std::int64_t stalledAt() const noexcept { return stoodAt_.load(std::memory_order_acquire); }

  /// Stops, and disarms the device. Once.
  LinkRun finish();

 private:
  void tick(double dt, double lateness) noexcept;
  bool mustPause(double force) noexcept;

  devices::Device& device_;
  double forceThatMatters_;  ///< [N]
  double lastForce_ = 0.0;   ///< [N]
  engine::CompiledScene scene_;
  engine::ForceEngine engine_;
  std::atomic<bool> isOver_{false};
  std::atomic<std::int64_t> orderedAt_{0};  ///< [ns]
  std::atomic<std::int64_t> ordered_{0};    ///< requested standstill [ns]
  std::atomic<std::int64_t> stoodAt_{0};    ///< [ns]
  LinkRun run_;
  std::int64_t begin_ = 0;  ///< armed [ns]
  double processorBefore_ = 0.0;
  std::optional<engine::RealtimeLoop> loop_;  ///< last, so that it is destroyed first
};

}  // namespace haptics::bench
