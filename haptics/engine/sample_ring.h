#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <type_traits>

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
  static constexpr std::size_t capacity() noexcept { return kCapacity; }

 private:
  alignas(64) std::atomic<std::size_t> head_{0};
  alignas(64) std::atomic<std::size_t> tail_{0};
  std::atomic<std::uint64_t> lost_{0};
  std::array<Sample, kCapacity> samples_{};
};

}  // namespace haptics::engine
