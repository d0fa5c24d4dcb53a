#pragma once

#include <atomic>
#include <cstdint>

#include "haptics/engine/sample_ring.h"
#include "haptics/reaming/bone/packing.h"

namespace haptics::engine {

/// A sphere that has changed, for a picture of the bone. A radius of 0: it was removed.
struct SphereChange {
  /// A slot that is none: the bone is whole again, all spheres are as at the beginning.
  static constexpr std::uint32_t kAllAnew = 0xffffffffU;

  std::uint32_t slot = 0;
  reaming::Sphere sphere;
};

/// A bone as it is seen while it is reamed: what has changed in it, and where the bone holds the
/// reamer. One writer, the tick; one reader on another thread, with a picture of its own of all
/// spheres.
class BoneView {
 public:
  /// Reader only: what has changed since it was last asked, one by one. False where nothing has.
  bool next(SphereChange& change) noexcept { return changes_.pop(change); }

  /// Where the reamer is, along its plunge [m].
  double depth() const noexcept { return depth_.load(std::memory_order_relaxed); }

  /// Changes that found no room: the picture shows spheres that are not there any more.
  std::uint64_t lost() const noexcept {
    return changes_.lost() + untold_.load(std::memory_order_relaxed);
  }

  /// Writer only.
  void tell(const SphereChange& change) noexcept { changes_.push(change); }
  void tellDepth(double depth) noexcept { depth_.store(depth, std::memory_order_relaxed); }
  void tellUntold(std::uint64_t changes) noexcept {
    untold_.store(changes, std::memory_order_relaxed);
  }

 private:
  SampleRing<SphereChange, 1U << 15U> changes_;
  std::atomic<double> depth_{0.0};
  std::atomic<std::uint64_t> untold_{0};
};

}  // namespace haptics::engine
