#include "haptics/reaming/bone/sphere_kernel.h"

#include <cmath>
#include <cstdint>

// Compiled for several processor generations; the loader chooses when the program starts.
// Sanitizers do not support this.
#if defined(__x86_64__) && defined(__gnu_linux__) && !defined(__SANITIZE_ADDRESS__) && \
    !defined(__SANITIZE_THREAD__)
#define PALPATE_FOR_THIS_PROCESSOR __attribute__((target_clones("arch=x86-64-v3", "default")))
#else
#define PALPATE_FOR_THIS_PROCESSOR
#endif

namespace haptics::reaming {
namespace {

constexpr float kTiny = 1e-20F;  // avoids a division by zero in empty slots

/// One number per lane; GCC maps the vector to registers.
using Lanes = float __attribute__((vector_size(kLanes * sizeof(float))));
using Masks = std::int32_t __attribute__((vector_size(kLanes * sizeof(std::int32_t))));

#define PALPATE_INLINE [[gnu::always_inline]] inline

PALPATE_INLINE void load(const float* from, Lanes& to) {
  to = *reinterpret_cast<const Lanes*>(from);
}
PALPATE_INLINE bool isAny(const Masks& mask) {
  using Words = std::int64_t __attribute__((vector_size(kLanes * sizeof(std::int32_t))));
  const auto words = reinterpret_cast<const Words&>(mask);
  return (words[0] | words[1] | words[2] | words[3]) != 0;
}
PALPATE_INLINE void root(const Lanes& of, Lanes& to) {
  for (std::size_t lane = 0; lane < kLanes; ++lane) to[lane] = std::sqrt(of[lane]);
}

/// Sums in single precision per lane, over few enough spheres that rounding errors are not
/// noticeable.
struct PartialSums {
  Lanes of[KernelSums::Quantities] = {};
};

template <bool kIsCut>
PALPATE_INLINE void addGroup(
    const SphereGroup& group, const KernelReamer& reamer, PartialSums& sums) {
  const Lanes none = {};
  Lanes dx, dy, dz, r;
  load(group.x, dx);
  load(group.y, dy);
  load(group.z, dz);
  load(group.radius, r);
  dx -= reamer.x;
  dy -= reamer.y;
  dz -= reamer.z;
  // Most of the spheres are not in contact: exclude them by squared distances, before taking a
  // root.
  const Lanes square = dx * dx + dy * dy + dz * dz;
  const Lanes along = dx * reamer.ax + dy * reamer.ay + dz * reamer.az;
  const Lanes outer = reamer.radius + r;
  const Lanes inner = reamer.radius - r;
  const Masks isTouched =
      (square < outer * outer) & (square > inner * inner) & (along >= 0.0F) & (r > 0.0F);
  if (!isAny(isTouched)) return;
  Lanes d;
  root(square + kTiny, d);
  // The area of the cap that the reamer's surface cuts out of a sphere is π R (r² − (d − R)²)/d;
  // the factor π R is applied after the sum.
  const Lanes over = d - reamer.radius;
  Lanes lens = r * r - over * over;
  lens = (isTouched & (lens > 0.0F)) ? lens : none;
  if constexpr (kIsCut) {
    Lanes depth;
    load(group.depth, depth);
    // A sphere that was cut to `depth` has its full force if the tool is that deep; as the tool
    // moves back, the force fades over a fraction of the radius, without a step.
    Lanes share = (r - over - depth) / (kReleaseShare * r + kTiny) + 1.0F;
    share = share > 0.0F ? share : none;
    share = share < 1.0F ? share : none + 1.0F;
    lens *= share;
  }
  Lanes density;
  load(group.density, density);
  const Lanes inverse = 1.0F / d;
  const Lanes a = lens * inverse;
  const Lanes p = a * density;
  const Lanes inward = -a * inverse;
  const Lanes push = inward * density;
  Lanes across = square - along * along;
  across = across > 0.0F ? across : none;
  Lanes perpendicular;
  root(across, perpendicular);
  sums.of[KernelSums::Area] += a;
  sums.of[KernelSums::Pressing] += p;
  sums.of[KernelSums::NormalX] += inward * dx;
  sums.of[KernelSums::NormalY] += inward * dy;
  sums.of[KernelSums::NormalZ] += inward * dz;
  sums.of[KernelSums::ForceX] += push * dx;
  sums.of[KernelSums::ForceY] += push * dy;
  sums.of[KernelSums::ForceZ] += push * dz;
  sums.of[KernelSums::Lever] += p * perpendicular;
  sums.of[KernelSums::Touched] += a > 0.0F ? none + 1.0F : none;
}

PALPATE_INLINE void flush(PartialSums& partial, KernelSums& sums) {
  for (std::size_t q = 0; q < KernelSums::Quantities; ++q) {
    for (std::size_t lane = 0; lane < kLanes; ++lane) sums.of[q] += double{partial.of[q][lane]};
    partial.of[q] = Lanes{};
  }
}

template <bool kIsCut>
PALPATE_INLINE void add(
    const SphereGroup* groups,
    std::span<const GroupRange> ranges,
    const KernelReamer& reamer,
    KernelSums& sums) {
  // Groups per partial sum; the relative rounding error is at most 1024 · 2⁻²⁴ = 6e-5.
  constexpr std::size_t kGroupsPerSum = 1024;
  PartialSums partial;
  std::size_t looked = 0;
  for (const auto& range : ranges) {
    for (std::size_t i = range.begin; i < range.end; ++i) {
      addGroup<kIsCut>(groups[i], reamer, partial);
    }
    looked += range.end - range.begin;
    if (looked < kGroupsPerSum) continue;
    flush(partial, sums);
    looked = 0;
  }
  flush(partial, sums);
}

}  // namespace

PALPATE_FOR_THIS_PROCESSOR
void addSpheres(
    const SphereGroup* groups,
    std::span<const GroupRange> ranges,
    const KernelReamer& reamer,
    bool leavesOutCutParts,
    KernelSums& sums) noexcept {
  if (leavesOutCutParts) {
    add<true>(groups, ranges, reamer, sums);
  } else {
    add<false>(groups, ranges, reamer, sums);
  }
}

PALPATE_FOR_THIS_PROCESSOR
std::size_t findSpheresToCut(
    const SphereGroup* groups,
    std::span<const GroupRange> ranges,
    const KernelReamer& reamer,
    std::span<std::uint32_t> found) noexcept {
  std::size_t count = 0;
  for (const auto& range : ranges) {
    for (std::uint32_t i = range.begin; i < range.end; ++i) {
      const auto& group = groups[i];
      Lanes dx, dy, dz, r, depth;
      load(group.x, dx);
      load(group.y, dy);
      load(group.z, dz);
      load(group.radius, r);
      load(group.depth, depth);
      dx -= reamer.x;
      dy -= reamer.y;
      dz -= reamer.z;
      // r − (d − R) > depth, compared by squares.
      const Lanes reach = reamer.radius + r - depth;
      const Masks isDeeper = (dx * dx + dy * dy + dz * dz < reach * reach) & (reach > 0.0F) &
                             (dx * reamer.ax + dy * reamer.ay + dz * reamer.az >= 0.0F) &
                             (r > 0.0F);
      if (!isAny(isDeeper)) continue;
      if (count + kLanes > found.size()) return count;
      for (std::uint32_t lane = 0; lane < kLanes; ++lane) {
        if (isDeeper[lane] != 0) found[count++] = static_cast<std::uint32_t>(kLanes) * i + lane;
      }
    }
  }
  return count;
}

}  // namespace haptics::reaming
