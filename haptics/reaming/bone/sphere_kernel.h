#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace haptics::reaming {

/// Where a reamer is, in the precision of a sphere field.
struct KernelReamer {
  float x = 0.0F, y = 0.0F, z = 0.0F;     ///< centre [m]
  float ax = 0.0F, ay = 0.0F, az = 1.0F;  ///< axis
  float radius = 0.0F;                    ///< [m]
};

/// Spheres that are looked at together.
inline constexpr std::size_t kLanes = 8;

/// So many spheres, quantity by quantity. A radius of 0: an empty slot.
struct alignas(64) SphereGroup {
  float x[kLanes] = {};  ///< centre [m]
  float y[kLanes] = {};
  float z[kLanes] = {};
  float radius[kLanes] = {};   ///< [m]
  float density[kLanes] = {};  ///< [N/m²]
  float depth[kLanes] = {};    ///< that has been cut off, seen from the reamer [m], 0 to 2 radii
};

/// Groups from begin to end.
struct GroupRange {
  std::uint32_t begin = 0;
  std::uint32_t end = 0;
};

/// Sums of ReamerContact, without its factor π R.
struct KernelSums {
  enum Quantity {
    Area,
    Pressing,
    NormalX,
    NormalY,
    NormalZ,
    ForceX,
    ForceY,
    ForceZ,
    Lever,
    Touched,
    Quantities
  };
  double of[Quantities] = {};
};

/// Distance behind a cut at which its sphere has no force any more, as a share of its radius. Over
/// this distance the force fades out without a step when the reamer moves back.
inline constexpr float kReleaseShare = 0.02F;

/// Adds what is in @p stretches of @p groups; with @p isCut without what has been cut off.
void addSpheres(
    const SphereGroup* groups,
    std::span<const GroupRange> stretches,
    const KernelReamer& reamer,
    bool isCut,
    KernelSums& sums) noexcept;

/// Finds spheres of @p stretches into which the surface has gone deeper than their cut.
/// @param found  takes their slots, group by group. @return how many, at most as many as it takes.
std::size_t findDeeper(
    const SphereGroup* groups,
    std::span<const GroupRange> stretches,
    const KernelReamer& reamer,
    std::span<std::uint32_t> found) noexcept;

}  // namespace haptics::reaming
