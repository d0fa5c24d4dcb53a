#include "haptics/reaming/bone/sphere_field.h"

#include <array>
#include <limits>
#include <numbers>
#include <stdexcept>

namespace haptics::reaming {
namespace {

void check(const Packing& packing, std::span<const double> densities) {
  if (packing.spheres.empty()) throw std::invalid_argument("the packing has no spheres");
  if (densities.size() != packing.spheres.size()) {
    throw std::invalid_argument("every sphere needs a density");
  }
  for (const double density : densities) {
    if (!(std::isfinite(density) && density >= 0.0)) {
      throw std::invalid_argument("a density is no number, or below 0");
    }
  }
  for (const auto& s : packing.spheres) {
    if (!(s.radius > 0.0F) || !std::isfinite(s.x + s.y + s.z + s.radius)) {
      throw std::invalid_argument("a sphere is nowhere, or has no radius");
    }
  }
}

}  // namespace

SphereField::SphereField(const Packing& packing, std::span<const double> densities) {
  check(packing, densities);
  Vec3 high = packing.spheres.front().centre();
  lowerCorner_ = high;
  double sum = 0.0;
  for (const auto& s : packing.spheres) {
    const Vec3 c = s.centre();
    lowerCorner_ = {
        std::min(lowerCorner_.x, c.x),
        std::min(lowerCorner_.y, c.y),
        std::min(lowerCorner_.z, c.z)};
    high = {std::max(high.x, c.x), std::max(high.y, c.y), std::max(high.z, c.z)};
    largestRadius_ = std::max(largestRadius_, double{s.radius});
    sum += s.radius;
  }
  // Cells of four mean diameters are fastest, with a flat optimum. Lower bounds: at most one cell
  // per sphere, at most 1000 cells along the diagonal, and above 0 if all spheres are at one place.
  const auto count = static_cast<double>(packing.spheres.size());
  const Vec3 size = high - lowerCorner_;
  const double coarse = std::cbrt(size.x * size.y * size.z / count);
  cellSize_ = std::max({4.0 * 2.0 * sum / count, coarse, 1e-3 * length(size), 1e-9});
  nx_ = static_cast<int>(size.x / cellSize_) + 1;
  ny_ = static_cast<int>(size.y / cellSize_) + 1;
  nz_ = static_cast<int>(size.z / cellSize_) + 1;
  const auto cells =
      static_cast<std::size_t>(nx_) * static_cast<std::size_t>(ny_) * static_cast<std::size_t>(nz_);
  layOut(packing, cells);
  std::vector<std::size_t> next(cells);
  for (std::size_t i = 0; i < cells; ++i) next[i] = kLanes * firstGroups_[i];
  for (std::size_t i = 0; i < packing.spheres.size(); ++i) {
    const auto& s = packing.spheres[i];
    const std::size_t slot = next[cellOf(s.centre())]++;
    auto& group = groups_[slot / kLanes];
    const std::size_t lane = slot % kLanes;
    group.x[lane] = s.x;
    group.y[lane] = s.y;
    group.z[lane] = s.z;
    group.radius[lane] = s.radius;
    group.density[lane] = static_cast<float>(densities[i]);
  }
}

/// Allocates groups for the spheres of every cell, with some spare slots.
void SphereField::layOut(const Packing& packing, std::size_t cells) {
  constexpr std::uint32_t kSpareSlots = 2;  // slots for spheres that are split off
  std::vector<std::uint32_t> held(cells, 0);
  for (const auto& s : packing.spheres) ++held[cellOf(s.centre())];
  firstGroups_.assign(cells + 1, 0);
  for (std::size_t i = 0; i < cells; ++i) {
    const std::uint32_t wanted = held[i] > 0 ? held[i] + kSpareSlots : 0;
    firstGroups_[i + 1] =
        firstGroups_[i] + static_cast<std::uint32_t>((wanted + kLanes - 1) / kLanes);
  }
  groups_.resize(firstGroups_.back());
}

std::size_t SphereField::cellOf(Vec3 place) const noexcept {
  const Vec3 from = place - lowerCorner_;
  const auto i = static_cast<std::size_t>(cellIndexAlong(from.x, nx_));
  const auto j = static_cast<std::size_t>(cellIndexAlong(from.y, ny_));
  const auto k = static_cast<std::size_t>(cellIndexAlong(from.z, nz_));
  return (k * static_cast<std::size_t>(ny_) + j) * static_cast<std::size_t>(nx_) + i;
}

std::size_t SphereField::freeSlot(Vec3 place) const noexcept {
  const std::size_t cell = cellOf(place);
  for (std::size_t slot = kLanes * firstGroups_[cell + 1]; slot > kLanes * firstGroups_[cell];
       --slot) {
    if (group(slot - 1).radius[(slot - 1) % kLanes] == 0.0F) return slot - 1;
  }
  return slotCount();
}

void SphereField::move(std::size_t slot, Vec3 place) noexcept {
  auto& g = group(slot);
  const std::size_t lane = slot % kLanes;
  const auto owner = std::upper_bound(firstGroups_.begin(), firstGroups_.end(), slot / kLanes) - 1;
  const auto cell = static_cast<std::size_t>(owner - firstGroups_.begin());
  const auto width = static_cast<std::size_t>(nx_);
  const auto height = static_cast<std::size_t>(ny_);
  const std::size_t at[] = {cell % width, cell / width % height, cell / (width * height)};
  const Vec3 from = place - lowerCorner_;
  const double off[] = {from.x, from.y, from.z};
  for (int axis = 0; axis < 3; ++axis) {
    const double low = cellSize_ * static_cast<double>(at[axis]);
    drift_ = std::max({drift_, low - off[axis], off[axis] - (low + cellSize_)});
  }
  g.x[lane] = static_cast<float>(place.x);
  g.y[lane] = static_cast<float>(place.y);
  g.z[lane] = static_cast<float>(place.z);
}

namespace {

KernelReamer inSinglePrecision(const Reamer& reamer) noexcept {
  return {
      static_cast<float>(reamer.centre.x),
      static_cast<float>(reamer.centre.y),
      static_cast<float>(reamer.centre.z),
      static_cast<float>(reamer.axis.x),
      static_cast<float>(reamer.axis.y),
      static_cast<float>(reamer.axis.z),
      static_cast<float>(reamer.radius)};
}

}  // namespace

/// Calls @p work with batches of ranges.
template <typename Work>
void SphereField::runInParallel(const Reamer& reamer, Work work) const {
  constexpr std::size_t kRangesPerBatch = 512;
  std::array<GroupRange, kRangesPerBatch> ranges;
  std::size_t count = 0;
  forEachRange(reamer, [&](std::uint32_t begin, std::uint32_t end) {
    ranges[count++] = {begin, end};
    if (count < kRangesPerBatch) return;
    work(std::span<const GroupRange>(ranges).first(count));
    count = 0;
  });
  work(std::span<const GroupRange>(ranges).first(count));
}

ReamerContact SphereField::touch(const Reamer& reamer, bool leavesOutCutParts) const noexcept {
  const auto tool = inSinglePrecision(reamer);
  KernelSums sums;
  runInParallel(reamer, [&](std::span<const GroupRange> ranges) {
    addSpheres(groups_.data(), ranges, tool, leavesOutCutParts, sums);
  });
  using Sums = KernelSums;
  const auto& total = sums.of;
  const double factor = std::numbers::pi * reamer.radius;
  ReamerContact contact;
  contact.area = factor * total[Sums::Area];
  contact.pressing = factor * total[Sums::Pressing];
  contact.normal = factor * Vec3{total[Sums::NormalX], total[Sums::NormalY], total[Sums::NormalZ]};
  contact.force = factor * Vec3{total[Sums::ForceX], total[Sums::ForceY], total[Sums::ForceZ]};
  contact.lever = factor * total[Sums::Lever];
  contact.touched = static_cast<int>(total[Sums::Touched]);
  return contact;
}

bool SphereField::holds(const Reamer& reamer, std::size_t from, std::size_t end) const noexcept {
  for (std::size_t slot = kLanes * from; slot < kLanes * end; ++slot) {
    if (group(slot).radius[slot % kLanes] == 0.0F) continue;
    const Vec3 away = centre(slot) - reamer.centre;
    const bool isBeforeTeeth = dot(away, reamer.axis) >= 0.0;
    if (isBeforeTeeth && dot(away, away) < reamer.radius * reamer.radius) return true;
  }
  return false;
}

std::size_t SphereField::findSpheresToCut(
    const Reamer& reamer,
    std::size_t part,
    std::size_t parts,
    std::span<std::uint32_t> found) const noexcept {
  const auto tool = inSinglePrecision(reamer);
  std::size_t count = 0;
  std::size_t seen = 0;
  runInParallel(reamer, [&](std::span<const GroupRange> ranges) {
    for (const auto& range : ranges) {
      if (seen++ % parts != part) continue;
      count += reaming::findSpheresToCut(
          groups_.data(), std::span(&range, 1), tool, found.subspan(count));
    }
  });
  return count;
}

PlungePath plungePathInto(const SphereField& field, double radius) {
  // The teeth first touch a sphere when the reamer's centre is √((R+r)² − ρ²) before it, with ρ the
  // sphere's distance from the axis.
  double start = std::numeric_limits<double>::infinity();
  for (std::size_t slot = 0; slot < field.slotCount(); ++slot) {
    const double r = field.group(slot).radius[slot % kLanes];
    if (!(r > 0.0)) continue;
    const Vec3 c = field.centre(slot);
    const double square = (radius + r) * (radius + r) - c.x * c.x - c.y * c.y;
    if (square >= 0.0) start = std::min(start, c.z - std::sqrt(square));
  }
  if (!std::isfinite(start)) {
    throw std::invalid_argument(
        "the reamer passes beside the bone: turn and move the mesh so that +z through its origin "
        "goes into the cup");
  }
  constexpr double kStartDistance = 1e-5;  // [m]
  return {radius, start - kStartDistance};
}

}  // namespace haptics::reaming
