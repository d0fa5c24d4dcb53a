#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "haptics/reaming/bone/packing.h"
#include "haptics/reaming/bone/sphere_kernel.h"

namespace haptics::reaming {

/// Position and direction of a hemispherical reamer.
struct Reamer {
  double radius = 0.026;        ///< [m], > 0
  Vec3 centre;                  ///< centre of the hemisphere [m]
  Vec3 axis = {0.0, 0.0, 1.0};  ///< unit vector into the bone; the teeth are on that side
};

/// The contact of a reamer, as sums over the spheres that its surface cuts. a is the area of the
/// reamer's surface inside a sphere: a = πR (r² − (d − R)²)/d, with ρ the density and n the outward
/// normal.
struct ReamerContact {
  double area = 0.0;      ///< Σ a [m²]
  double pressing = 0.0;  ///< Σ a ρ [N]
  Vec3 normal;            ///< Σ a n, out of the bone [m²]
  Vec3 force;             ///< Σ a ρ n [N]
  double lever = 0.0;     ///< Σ a ρ times the distance from the reamer's axis [N·m]
  int touched = 0;        ///< number of spheres in contact

  /// Contact density Σ a ρ / Σ a of the reaming paper [N/m²]; 0 without contact.
  double density() const noexcept { return area > 0.0 ? pressing / area : 0.0; }
};

/// The spheres of a packing in a grid of cells, for contact and removal. They are stored cell after
/// cell, in groups, so that a row of cells is contiguous in memory. Every cell that holds spheres
/// has a few empty slots at its end.
class SphereField {
 public:
  /// @param densities  of each sphere: the pressure at which it yields [N/m²], finite, >= 0.
  /// @throws std::invalid_argument  if there are no spheres, or the number of densities differs
  /// from that of the spheres, or one is out of range.
  SphereField(const Packing& packing, std::span<const double> densities);

  /// The sums over all spheres that the surface cuts. With @p leavesOutCutParts, parts that have
  /// already been cut off do not count. Never allocates. All sums are 0 for a reamer whose position
  /// is NaN.
  ReamerContact touch(const Reamer& reamer, bool leavesOutCutParts) const noexcept;

  /// Finds spheres that the surface has entered deeper than they have been cut. Only every @p
  /// parts-th range, beginning with number @p part, is searched.
  /// @param found  receives their slots. @return how many.
  std::size_t findSpheresToCut(
      const Reamer& reamer,
      std::size_t part,
      std::size_t parts,
      std::span<std::uint32_t> found) const noexcept;

  /// Calls @p visit(begin, end) with ranges of groups that together contain all spheres that the
  /// surface of @p reamer may cut.
  template <typename Visit>
  void forEachRange(const Reamer& reamer, Visit visit) const;

  /// A slot is a lane of a group: slot / kLanes, slot % kLanes.
  std::size_t slotCount() const noexcept { return kLanes * groups_.size(); }
  SphereGroup& group(std::size_t slot) noexcept { return groups_[slot / kLanes]; }
  const SphereGroup& group(std::size_t slot) const noexcept { return groups_[slot / kLanes]; }
  const std::vector<SphereGroup>& groups() const noexcept { return groups_; }

  Vec3 centre(std::size_t slot) const noexcept {
    const auto& g = group(slot);
    const std::size_t lane = slot % kLanes;
    return {g.x[lane], g.y[lane], g.z[lane]};
  }

  /// An empty slot in the cell of @p place; slotCount() if there is none.
  std::size_t freeSlot(Vec3 place) const noexcept;

  /// Moves the sphere of @p slot to @p place. Its slot stays in the old cell, so searches widen by
  /// its distance from that cell.
  void move(std::size_t slot, Vec3 place) noexcept;

  /// Sets the largest distance of a moved sphere from its cell to 0. Call it when all spheres are
  /// in their cells again.
  void resetDrift() noexcept { drift_ = 0.0; }

  /// Whether the reamer's teeth have passed the centre of a sphere in groups @p from … @p end − 1:
  /// then the reamer is inside the bone.
  bool holds(const Reamer& reamer, std::size_t from, std::size_t end) const noexcept;

  std::size_t bytes() const noexcept { return sizeof(SphereGroup) * groups_.size(); }
  double largestRadius() const noexcept { return largestRadius_; }  ///< of the packing [m]

 private:
  int cellIndexAlong(double from, int count) const noexcept {
    return static_cast<int>(std::clamp(std::floor(from / cellSize_), 0.0, count - 1.0));
  }
  std::size_t cellOf(Vec3 place) const noexcept;
  template <typename Work>
  void runInParallel(const Reamer& reamer, Work work) const;
  void layOut(const Packing& packing, std::size_t cells);

  Vec3 lowerCorner_;
  double cellSize_ = 1.0;  ///< [m]
  int nx_ = 1, ny_ = 1, nz_ = 1;
  std::vector<std::uint32_t> firstGroups_;  ///< first group of each cell, and the end of the last
  std::vector<SphereGroup> groups_;
  double largestRadius_ = 0.0;  ///< radius [m]
  double drift_ = 0.0;          ///< largest distance of a moved sphere from its cell [m]
};

template <typename Visit>
void SphereField::forEachRange(const Reamer& reamer, Visit visit) const {
  // The surface cuts spheres whose centres are in a spherical shell: its outer and inner radius.
  const double pad = largestRadius_ + drift_;
  const double outer = reamer.radius + pad;
  const double inner = std::max(0.0, reamer.radius - pad);
  const Vec3 from = reamer.centre - lowerCorner_;
  if (!std::isfinite(from.x + from.y + from.z)) return;
  const auto nearest = [](double low, double high) {
    return low > 0.0 ? low : high < 0.0 ? -high : 0.0;
  };
  const auto farthest = [](double low, double high) { return std::max(std::abs(low), high); };
  const int firstK = cellIndexAlong(from.z - outer, nz_);
  const int lastK = cellIndexAlong(from.z + outer, nz_);
  for (int k = firstK; k <= lastK; ++k) {
    const double z0 = k * cellSize_ - from.z;
    const double z1 = z0 + cellSize_;
    const double nearZ = nearest(z0, z1);
    const double farZ = farthest(z0, z1);
    const double acrossY = outer * outer - nearZ * nearZ;
    if (acrossY < 0.0) continue;
    const double reachY = std::sqrt(acrossY);
    const int firstJ = cellIndexAlong(from.y - reachY, ny_);
    const int lastJ = cellIndexAlong(from.y + reachY, ny_);
    for (int j = firstJ; j <= lastJ; ++j) {
      const double y0 = j * cellSize_ - from.y;
      const double y1 = y0 + cellSize_;
      const double nearY = nearest(y0, y1);
      const double acrossX = acrossY - nearY * nearY;
      if (acrossX < 0.0) continue;
      const double reachX = std::sqrt(acrossX);
      // Skip cells behind the reamer: the teeth are on one side only.
      const double most = std::max(reamer.axis.x * reachX, -reamer.axis.x * reachX) +
                          std::max(reamer.axis.y * y0, reamer.axis.y * y1) +
                          std::max(reamer.axis.z * z0, reamer.axis.z * z1);
      if (most < -2.0 * drift_) continue;
      const double farY = farthest(y0, y1);
      const double hollow = inner * inner - farY * farY - farZ * farZ;
      const std::size_t row = (static_cast<std::size_t>(k) * static_cast<std::size_t>(ny_) +
                               static_cast<std::size_t>(j)) *
                              static_cast<std::size_t>(nx_);
      const int first = cellIndexAlong(from.x - reachX, nx_);
      const int last = cellIndexAlong(from.x + reachX, nx_);
      const auto stretch = [&](int a, int b) {
        const auto begin = firstGroups_[row + static_cast<std::size_t>(a)];
        const auto end = firstGroups_[row + static_cast<std::size_t>(b) + 1];
        if (begin < end) visit(begin, end);
      };
      // Skip cells that are entirely inside the shell's inner radius.
      const double gap = hollow > 0.0 ? std::sqrt(hollow) : 0.0;
      const int leftEnd = static_cast<int>(std::floor((from.x - gap) / cellSize_));
      const int rightBegin = static_cast<int>(std::floor((from.x + gap) / cellSize_));
      if (gap > cellSize_ && rightBegin > leftEnd + 1) {
        if (leftEnd >= first) stretch(first, std::min(leftEnd, last));
        if (rightBegin <= last) stretch(std::max(rightBegin, first), last);
      } else {
        stretch(first, last);
      }
    }
  }
}

/// The path of the reamer in the experiment: along +z through the origin of the bone's frame, from
/// just before the first contact (reaming paper, "Experimental setup").
struct PlungePath {
  double radius = 0.026;  ///< of the reamer [m]
  double start = 0.0;     ///< z of the reamer's centre at depth 0 [m]

  Reamer at(double depth) const noexcept { return {radius, {0.0, 0.0, start + depth}}; }
};

/// The path that begins 10 µm before the reamer first touches a sphere of @p field.
/// @throws std::invalid_argument  if the reamer touches no sphere.
PlungePath plungePathInto(const SphereField& field, double radius);

}  // namespace haptics::reaming
