#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <type_traits>

#include "haptics/devices/device.h"
#include "haptics/models/cut_detector.h"

namespace haptics::engine {

/// A lock-free ring buffer from the haptic thread to the recorder: one writer, one reader, no heap.
/// If the reader is too slow, samples are lost; lost() counts them.
template <typename Sample, std::size_t kCapacity>
class SampleRing {
  static_assert((kCapacity & (kCapacity - 1)) == 0, "a power of two");
  static_assert(std::is_trivially_destructible_v<Sample>, "what crosses threads owns no memory");

 public:
  /// Writer only. If the ring is full, counts the sample as lost and returns false.
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

  /// Reader only. Returns false if the ring is empty.
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

/// The result of one tick, for recording, counting and drawing.
struct TickSample {
  /// Conditions of a tick other than the limiter's interventions, as bits.
  enum Mark : std::uint8_t {
    None = 0,
    Invalid = 1,    ///< the device gave no measurement; travel and velocity are the last ones
    Undefined = 2,  ///< the scene defines no force at this travel
    Stopped = 4,    ///< the engine is stopped: by stop(), or after a failure of the device
    NoScene = 8,    ///< there is no scene, hence no force
    TooFast = 16,   ///< the tool exceeds the limit of velocity; the force fades
    DeadManReleased = 32,  ///< the dead-man switch is not held; the force fades
    SoftStart = 64,        ///< waits for a small desired force, or the force is rising
    MissedPeriods = 128,   ///< the clock missed more than one period; the force fades
  };

  std::uint64_t tick = 0;
  double travel = 0.0;         ///< [device's travel unit]
  double velocity = 0.0;       ///< [device's travel unit / s]
  double desired = 0.0;        ///< desired by the scene [N]
  double force = 0.0;          ///< sent to the device [N]
  double desiredTorque = 0.0;  ///< desired by the scene, about the tool's axis [N·m]
  double torque = 0.0;         ///< sent to the device [N·m]; 0 if it renders none
  double energy = 0.0;         ///< absorbed during this contact [N·device's travel unit]
  /// Absorbed by the rotation about the tool's axis during this contact [J]
  double rotationEnergy = 0.0;
  float lateness = 0.0F;  ///< of this tick after its due time [µs]; 0 without a clock
  devices::DeviceStatus status = devices::DeviceStatus::NotAnswering;
  std::uint8_t interventions = 0;  ///< ForceLimiter::Intervention
  std::uint8_t marks = None;
  /// The landmark of a cut that this tick detected.
  models::CutDetector<double>::Event landmark = models::CutDetector<double>::Event::Nothing;
  std::uint32_t leaps = 0;  ///< DeviceSample::leaps
  std::uint32_t cuts = 0;   ///< number of cuts completed since the scene was set
};

}  // namespace haptics::engine
