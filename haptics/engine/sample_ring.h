#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <type_traits>

#include "haptics/devices/device.h"
#include "haptics/models/cut_detector.h"

namespace haptics::engine {

/// Samples on their way from the haptic thread to the recorder: one writer, one reader, no lock, no
/// heap. A reader that is too slow loses samples; how many is counted, never hidden.
template <typename Sample, std::size_t kCapacity>
class SampleRing {
  static_assert((kCapacity & (kCapacity - 1)) == 0, "a power of two");
  static_assert(std::is_trivially_destructible_v<Sample>, "what crosses threads owns no memory");

 public:
  /// Writer only. False, and counted, where the ring is full.
  bool push(const Sample& sample) noexcept {
    const std::size_t head = head_.load(std::memory_order_relaxed);
    if (head - tail_.load(std::memory_order_acquire) == kCapacity) {
      lost_.fetch_add(1, std::memory_order_relaxed);
      return false;
    }
    samples_[head & (kCapacity - 1)] = sample;
    head_.store(head + 1, std::memory_order_release);
    return true;
  }

  /// Reader only. False where there is nothing.
  bool pop(Sample& sample) noexcept {
    const std::size_t tail = tail_.load(std::memory_order_relaxed);
    if (tail == head_.load(std::memory_order_acquire)) return false;
    sample = samples_[tail & (kCapacity - 1)];
    tail_.store(tail + 1, std::memory_order_release);
    return true;
  }

  std::uint64_t lost() const noexcept { return lost_.load(std::memory_order_relaxed); }

 private:
  alignas(64) std::atomic<std::size_t> head_{0};
  alignas(64) std::atomic<std::size_t> tail_{0};
  std::atomic<std::uint64_t> lost_{0};
  std::array<Sample, kCapacity> samples_{};
};

/// What happened in one tick: to be recorded, counted and drawn.
struct TickSample {
  /// What the engine itself noted, beside the limiter's interventions, as bits.
  enum Mark : std::uint8_t {
    None = 0,
    Invalid = 1,          ///< the device gave no measurement; travel and velocity are the last ones
    Undefined = 2,        ///< the scene has no force here
    Stopped = 4,          ///< stop was pressed
    Bare = 8,             ///< no scene: the hand feels nothing
    TooFast = 16,         ///< the tool exceeds the limit of velocity; the force fades
    Released = 32,        ///< the dead-man switch is not held; the force fades
    SoftStart = 64,       ///< the force waits for a small one, or comes on
    MissedPeriods = 128,  ///< the clock missed more than one period; the force fades
  };

  std::uint64_t tick = 0;
  double travel = 0.0;         ///< [device's travel unit]
  double velocity = 0.0;       ///< [device's travel unit / s]
  double desired = 0.0;        ///< desired by the scene [N]
  double force = 0.0;          ///< sent to the device [N]
  double desiredTorque = 0.0;  ///< desired by the scene, about the tool's axis [N·m]
  double torque = 0.0;         ///< sent to the device [N·m]; 0 if it renders none
  double energy = 0.0;         ///< that this contact has taken up [N·device's travel unit]
  double turnEnergy = 0.0;     ///< the same for the turn about the tool's axis [J]
  float lateness = 0.0F;       ///< of this tick against its due time [µs]; 0 without a clock
  devices::DeviceStatus status = devices::DeviceStatus::Gone;
  std::uint8_t interventions = 0;  ///< ForceLimiter::Intervention
  std::uint8_t marks = None;
  /// A point of a cut that has just become clear.
  models::CutDetector<double>::Event landmark = models::CutDetector<double>::Event::Nothing;
  std::uint32_t cuts = 0;  ///< completed since the scene was set
};

}  // namespace haptics::engine
