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

/// The changes of a bone while it is reamed, and the depth of the reamer, for drawing. One writer,
/// the tick; one reader in another thread, which keeps its own copy of all spheres.
class BoneView {
 public:
  /// For the reader: the next change; false if there is none.
  bool next(SphereChange& change) noexcept { return changes_.pop(change); }

  /// Depth of the reamer along its path [m].
  double depth() const noexcept { return depth_.load(std::memory_order_relaxed); }

  /// Changes that were lost because the ring was full: the picture has spheres that are gone.
  std::uint64_t lost() const noexcept {
    return changes_.lost() + unreported_.load(std::memory_order_relaxed);
  }

  /// For the writer.
  void tell(const SphereChange& change) noexcept { changes_.push(change); }
  void setDepth(double depth) noexcept { depth_.store(depth, std::memory_order_relaxed); }
  void setUnreported(std::uint64_t changes) noexcept {
    unreported_.store(changes, std::memory_order_relaxed);
  }

 private:
  SampleRing<SphereChange, 1U << 15U> changes_;
  std::atomic<double> depth_{0.0};
  std::atomic<std::uint64_t> unreported_{0};
};

}  // namespace haptics::engine
