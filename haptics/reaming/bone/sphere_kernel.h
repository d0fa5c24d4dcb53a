#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace haptics::reaming {

/// A reamer in single precision, like the spheres.
struct KernelReamer {
  float x = 0.0F, y = 0.0F, z = 0.0F;     ///< centre [m]
  float ax = 0.0F, ay = 0.0F, az = 1.0F;  ///< axis
  float radius = 0.0F;                    ///< [m]
};

/// Number of spheres that are processed together (SIMD).
inline constexpr std::size_t kLanes = 8;

/// kLanes spheres as a structure of arrays. A radius of 0 marks an empty slot.
struct alignas(64) SphereGroup {
  float x[kLanes] = {};  ///< centre [m]
  float y[kLanes] = {};
  float z[kLanes] = {};
  float radius[kLanes] = {};   ///< [m]
  float density[kLanes] = {};  ///< [N/m²]
  float depth[kLanes] = {};  ///< thickness cut off so far, from the reamer's side [m], 0 to 2 radii
};

/// Groups begin … end − 1.
struct GroupRange {
  std::uint32_t begin = 0;
  std::uint32_t end = 0;
};

/// The sums of ReamerContact, without the factor π R.
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

/// When the reamer moves back from a cut, the sphere's force fades to 0 over this fraction of its
/// radius, so that it has no step.
inline constexpr float kReleaseShare = 0.02F;

/// Adds the spheres of the ranges @p ranges of @p groups to @p sums; with @p leavesOutCutParts,
/// without the parts that have been cut off.
void addSpheres(
    const SphereGroup* groups,
    std::span<const GroupRange> ranges,
    const KernelReamer& reamer,
    bool leavesOutCutParts,
    KernelSums& sums) noexcept;

/// Finds spheres of @p ranges that the surface has entered deeper than they have been cut.
/// @param found  receives their slots, group by group. @return how many, at most found.size().
std::size_t findSpheresToCut(
    const SphereGroup* groups,
    std::span<const GroupRange> ranges,
    const KernelReamer& reamer,
    std::span<std::uint32_t> found) noexcept;

}  // namespace haptics::reaming
