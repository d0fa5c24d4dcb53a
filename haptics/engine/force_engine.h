#pragma once

#include <atomic>
#include <cstdint>

#include "haptics/devices/device.h"
#include "haptics/engine/compiled_scene.h"
#include "haptics/engine/force_limiter.h"
#include "haptics/engine/passivity.h"
#include "haptics/engine/sample_ring.h"
#include "haptics/models/cut_detector.h"

namespace haptics::engine {

using CutDetector = models::CutDetector<double>;

/// Computes one step of haptic rendering: reads the device, gets a force from the scene, limits it,
/// commands it, and counts cuts.
///
/// The engine owns neither thread nor clock. The caller of tick() provides the time: the real-time
/// loop during a session, a for-loop for simulated participants and in tests. One engine serves one
/// device; two devices have two clocks, hence two engines.
class ForceEngine {
 public:
  /// The device must outlive the engine.
  /// @throws std::invalid_argument  if a limit is out of its range.
  ForceEngine(devices::Device& device, const SafetyLimits& limits);

  /// Renders @p scene from the next tick on; nullptr for no scene. Any thread may call it. The
  /// scene must outlive the last tick that uses it: before deleting it, set another and wait for a
  /// tick, or stop the loop.
  void setScene(CompiledScene* scene) noexcept;

  /// Sets the force to zero immediately, until arm() is called; the force then starts softly. Any
  /// thread. A device that is gone, faulty or silent for too long also stops the engine, which
  /// stays stopped when the device comes back.
  void stop() noexcept { isStopped_.store(true, std::memory_order_release); }
  void arm() noexcept { isStopped_.store(false, std::memory_order_release); }
  bool isStopped() const noexcept { return isStopped_.load(std::memory_order_acquire); }

  /// Switches the reamer on or off from the next tick on, as a pedal does; it is on initially. The
  /// reamer turns while both this and the device's own switch are on. Any thread.
  void switchReamer(bool isOn) noexcept { isReamerOn_.store(isOn, std::memory_order_relaxed); }

  /// Computes one step of @p dt [s], after @p missedPeriods periods without a tick. Never
  /// allocates, waits or throws.
  ///
  /// Read device → check sample → scene → passivity → gate → saturate → slew → check for finiteness
  /// → command, for force and torque alike. A device that renders no torque gets none. After a
  /// stop, a device failure or with an undefined scene there is no force; a missing sample is
  /// bridged for one tick, and then the force fades.
  TickSample tick(double dt, int missedPeriods = 0) noexcept;

 private:
  bool read(TickSample& sample, double dt) noexcept;
  void adoptScene() noexcept;
  void render(TickSample& sample, const ForceGate::Input& input, double dt) noexcept;
  void renderTorque(TickSample& sample, double gain, double dt) noexcept;
  double desiredForce(TickSample& sample) noexcept;
  void detectLandmarks(TickSample& sample) noexcept;

  devices::Device& device_;
  ForceLimiter limiter_;
  ForceLimiter torqueLimiter_;
  ForceGate gate_;
  EnergyObserver energy_;
  EnergyObserver rotationEnergy_;
  CutDetector cuts_;
  std::atomic<CompiledScene*> scene_{nullptr};
  CompiledScene* lastScene_ = nullptr;  ///< the scene of the last tick
  std::atomic<bool> isStopped_{false};
  std::atomic<bool> isReamerOn_{true};
  std::uint64_t ticks_ = 0;
  ToolState tool_;
  bool hasMeasuredTool_ = false;  ///< tool_ is measured: false before the first valid sample
  bool isDeadManHeld_ = true;
  double travelChange_ = 0.0;     ///< change of travel in the last tick [device's travel unit]
  double desired_ = 0.0;          ///< force of the scene's last response [N]
  double commanded_ = 0.0;        ///< [N]
  double turn_ = 0.0;             ///< about the tool's axis [rad]
  double turnChange_ = 0.0;       ///< change of turn in the last tick [rad]
  double desiredTorque_ = 0.0;    ///< torque of the scene's last response [N·m]
  double commandedTorque_ = 0.0;  ///< [N·m]
};

}  // namespace haptics::engine
