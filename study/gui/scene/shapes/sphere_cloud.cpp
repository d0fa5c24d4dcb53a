#include "study/gui/scene/shapes/sphere_cloud.h"

#include <algorithm>
#include <cmath>

#include "study/gui/scene/shapes/bone_tints.h"

namespace study::gui::scene {
namespace {

constexpr float kMillimetres = 1000.0F;
constexpr float kCellsPerDiameter = 1.8F;
constexpr float kDarkest = 40.0F;      // depth behind the section [mm]
constexpr int kEmptyAtTheSurface = 6;  // of the 27 cells in and around a sphere's cell

/// The sphere's share of its cell's volume, up to a factor [mm³].
float cubeOf(const SphereInstance& sphere) {
  return sphere.radius * sphere.radius * sphere.radius;
}

}  // namespace

std::size_t SphereCloud::Grid::size() const noexcept {
  return static_cast<std::size_t>(nx) * static_cast<std::size_t>(ny) * static_cast<std::size_t>(nz);
}

std::size_t SphereCloud::Grid::of(const SphereInstance& sphere) const noexcept {
  const auto along = [this](float from, int count) {
    const float at = std::floor(from / cell);
    return static_cast<std::size_t>(std::clamp(at, 0.0F, static_cast<float>(count - 1)));
  };
  const std::size_t i = along(sphere.x - low.x(), nx);
  const std::size_t j = along(sphere.y - low.y(), ny);
  const std::size_t k = along(sphere.z - low.z(), nz);
  return (k * static_cast<std::size_t>(ny) + j) * static_cast<std::size_t>(nx) + i;
}

std::array<std::size_t, 3> SphereCloud::Grid::placeOf(std::size_t index) const noexcept {
  const auto wide = static_cast<std::size_t>(nx);
  const auto deep = static_cast<std::size_t>(ny);
  return {index % wide, index / wide % deep, index / wide / deep};
}

SphereCloud::SphereCloud(const haptics::reaming::SphereField& field, const Options& options)
    : options_(options) {
  readSlots(field);
  layGrid();
  paintSlots(field);
  for (const auto& slot : slots_) initial_.push_back(slot.sphere);
  begin();
}

void SphereCloud::readSlots(const haptics::reaming::SphereField& field) {
  slots_.resize(field.slotCount());
  for (std::size_t i = 0; i < slots_.size(); ++i) {
    const auto& group = field.group(i);
    const std::size_t lane = i % haptics::reaming::kLanes;
    auto& slot = slots_[i];
    slot.sphere.x = kMillimetres * group.x[lane];
    slot.sphere.y = kMillimetres * group.y[lane];
    slot.sphere.z = kMillimetres * group.z[lane];
    slot.sphere.radius = kMillimetres * group.radius[lane];
    slot.initialRadius = slot.sphere.radius;
  }
}

/// Makes a grid with cells almost twice as wide as a sphere and a margin of empty cells.
void SphereCloud::layGrid() {
  constexpr float kFar = 1e9F;
  QVector3D low(kFar, kFar, kFar);
  QVector3D high = -low;
  float sum = 0.0F;
  float count = 0.0F;
  for (const auto& [sphere, initialRadius, cell, instance, tint] : slots_) {
    if (initialRadius <= 0.0F) continue;
    low = {std::min(low.x(), sphere.x), std::min(low.y(), sphere.y), std::min(low.z(), sphere.z)};
    high = {
        std::max(high.x(), sphere.x), std::max(high.y(), sphere.y), std::max(high.z(), sphere.z)};
    sum += initialRadius;
    count += 1.0F;
  }
  const QVector3D size = high - low;
  const float coarse = std::cbrt(size.x() * size.y() * size.z() / (4.0F * count));
  grid_.cell = std::max(kCellsPerDiameter * 2.0F * sum / count, 0.5F * coarse);
  const QVector3D margin(1.5F * grid_.cell, 1.5F * grid_.cell, 1.5F * grid_.cell);
  grid_.low = low - margin;
  const QVector3D cells = (size + 2.0F * margin) / grid_.cell;
  grid_.nx = static_cast<int>(cells.x()) + 1;
  grid_.ny = static_cast<int>(cells.y()) + 1;
  grid_.nz = static_cast<int>(cells.z()) + 1;
  for (auto& slot : slots_) slot.cell = static_cast<std::uint32_t>(grid_.of(slot.sphere));
}

void SphereCloud::paintSlots(const haptics::reaming::SphereField& field) {
  counts_.assign(grid_.size(), 0);
  for (const auto& slot : slots_) counts_[slot.cell] += slot.initialRadius > 0.0F ? 1U : 0U;
  const BoneTints tints(field, options_.colours);
  for (std::size_t i = 0; i < slots_.size(); ++i) {
    int empty = 0;
    forEachNeighbour(
        slots_[i].cell, [&](std::size_t cell) { empty += counts_[cell] == 0 ? 1 : 0; });
    slots_[i].tint = tints.of(i, empty >= kEmptyAtTheSurface);
    slots_[i].sphere.tint = slots_[i].tint;
  }
}

/// Resets everything to the initial state.
void SphereCloud::begin() {
  counts_.assign(grid_.size(), 0);
  filled_.assign(grid_.size(), 0.0F);
  cells_.assign(grid_.size(), {});
  isUncovered_.assign(grid_.size(), 0);
  instances_.clear();
  free_.clear();
  changed_.clear();
  isAllNew_ = true;
  for (std::uint32_t i = 0; i < slots_.size(); ++i) {
    auto& slot = slots_[i];
    slot.sphere = initial_[i];
    slot.cell = static_cast<std::uint32_t>(grid_.of(slot.sphere));
    slot.instance = -1;
    if (!isKept(slot.sphere)) continue;
    ++counts_[slot.cell];
    filled_[slot.cell] += cubeOf(slot.sphere);
    cells_[slot.cell].push_back(i);
  }
  float sum = 0.0F;
  float count = 0.0F;
  for (const float filled : filled_) {
    sum += filled;
    count += filled > 0.0F ? 1.0F : 0.0F;
  }
  fullCell_ = std::max(sum / std::max(count, 1.0F), 1e-9F);
  for (std::size_t cell = 0; cell < counts_.size(); ++cell) {
    if (counts_[cell] != 0) continue;
    bool isBeside = false;
    forEachNeighbour(cell, [&](std::size_t other) { isBeside |= counts_[other] != 0; });
    if (!isBeside || !isVisibleFromEye(cell)) continue;
    uncover(cell);
    if (isInFrontOfSection(cell)) uncoverNeighbours(cell);
  }
}

bool SphereCloud::isKept(const SphereInstance& sphere) const noexcept {
  return sphere.radius > 0.0F && (!options_.isHalved || sphere.y >= 0.0F);
}

/// Whether the line from an empty cell to the eye crosses only empty cells.
bool SphereCloud::isVisibleFromEye(std::size_t cell) const {
  const auto [i, j, k] = grid_.placeOf(cell);
  const QVector3D index(static_cast<float>(i), static_cast<float>(j), static_cast<float>(k));
  QVector3D at = grid_.low + grid_.cell * (index + QVector3D(0.5F, 0.5F, 0.5F));
  const QVector3D step = grid_.cell * (options_.eye - at).normalized();
  const QVector3D high = grid_.low + grid_.cell * QVector3D(
                                                      static_cast<float>(grid_.nx),
                                                      static_cast<float>(grid_.ny),
                                                      static_cast<float>(grid_.nz));
  const auto isInside = [&](int axis) {
    return at[axis] > grid_.low[axis] && at[axis] < high[axis];
  };
  for (at += step; isInside(0) && isInside(1) && isInside(2); at += step) {
    if (counts_[grid_.of({at.x(), at.y(), at.z(), 0.0F, {}})] != 0) return false;
  }
  return true;
}

template <typename Visit>
void SphereCloud::forEachNeighbour(std::size_t cell, Visit visit) const {
  const auto nx = static_cast<std::size_t>(grid_.nx);
  const auto ny = static_cast<std::size_t>(grid_.ny);
  const auto nz = static_cast<std::size_t>(grid_.nz);
  const auto [i, j, k] = grid_.placeOf(cell);
  for (std::size_t c = k - (k > 0 ? 1 : 0); c <= std::min(k + 1, nz - 1); ++c) {
    for (std::size_t b = j - (j > 0 ? 1 : 0); b <= std::min(j + 1, ny - 1); ++b) {
      for (std::size_t a = i - (i > 0 ? 1 : 0); a <= std::min(i + 1, nx - 1); ++a) {
        visit((c * ny + b) * nx + a);
      }
    }
  }
}

/// Whether a cell is in front of the section plane, from where the spheres behind gaps in the cut
/// are visible.
bool SphereCloud::isInFrontOfSection(std::size_t cell) const noexcept {
  const auto row = static_cast<float>(grid_.placeOf(cell)[1]);
  return options_.isHalved && grid_.low.y() + grid_.cell * (row + 0.5F) < 0.5F * grid_.cell;
}

void SphereCloud::uncoverNeighbours(std::size_t cell) {
  forEachNeighbour(cell, [this](std::size_t other) {
    if (counts_[other] != 0) uncover(other);
  });
}

/// Draws the spheres in and around a visible cell.
void SphereCloud::uncover(std::size_t cell) {
  forEachNeighbour(cell, [this](std::size_t other) {
    if (isUncovered_[other] != 0) return;
    isUncovered_[other] = 1;
    for (const auto slot : cells_[other]) {
      if (slots_[slot].cell == other) show(slot);
    }
  });
}

void SphereCloud::show(std::uint32_t slot) {
  auto& it = slots_[slot];
  if (!isKept(it.sphere)) return;
  if (it.instance < 0) {
    if (free_.empty()) {
      it.instance = static_cast<std::int32_t>(instances_.size());
      instances_.emplace_back();
    } else {
      it.instance = static_cast<std::int32_t>(free_.back());
      free_.pop_back();
    }
  }
  const auto instance = static_cast<std::size_t>(it.instance);
  instances_[instance] = it.sphere;
  if (options_.colours == SphereColours::Neutral) {
    // Less light reaches the bottom of the cavity.
    const float depth = std::clamp(it.sphere.y / kDarkest, 0.0F, 1.0F);
    instances_[instance].tint =
        tintInGap(it.sphere.tint, (1.0F - 0.55F * depth) * opennessOf(it.cell));
  }
  markChanged(instance);
}

/// The share of a cell that is empty, as seen from a cell that is full.
float SphereCloud::emptinessOf(std::size_t cell) const noexcept {
  return std::max(0.0F, 1.0F - filled_[cell] / fullCell_);
}

/// How open a cell is to light, in [0, 1]: 1 at an even surface.
float SphereCloud::opennessOf(std::size_t cell) const {
  constexpr float kEvenSurface = 9.0F;  // of the 27 cells in and around it
  float empty = 0.0F;
  forEachNeighbour(cell, [&](std::size_t other) { empty += emptinessOf(other); });
  return std::min(1.0F, empty / kEvenSurface);
}

/// Draws the spheres around a cell again when it has become emptier by a quarter: more light
/// reaches them.
void SphereCloud::lightNeighbours(std::size_t cell, float before) {
  constexpr float kSteps = 4.0F;
  const bool isLess = std::floor(kSteps * emptinessOf(cell)) > std::floor(kSteps * before);
  if (!isLess || options_.colours != SphereColours::Neutral) return;
  forEachNeighbour(cell, [this](std::size_t other) {
    for (const auto slot : cells_[other]) {
      if (slots_[slot].cell == other && slots_[slot].instance >= 0) show(slot);
    }
  });
}

void SphereCloud::hide(std::uint32_t slot) {
  auto& it = slots_[slot];
  if (it.instance < 0) return;
  const auto instance = static_cast<std::uint32_t>(it.instance);
  instances_[instance].radius = 0.0F;
  free_.push_back(instance);
  it.instance = -1;
  markChanged(instance);
}

void SphereCloud::markChanged(std::size_t instance) {
  if (!isAllNew_) changed_.push_back(static_cast<std::uint32_t>(instance));
}

void SphereCloud::apply(const haptics::engine::SphereChange& change) {
  if (change.slot == haptics::engine::SphereChange::kWholeBoneReset) {
    begin();
    return;
  }
  if (change.slot >= slots_.size()) return;
  auto& slot = slots_[change.slot];
  const bool wasKept = isKept(slot.sphere);
  const std::size_t from = slot.cell;
  const float emptiness = emptinessOf(from);
  if (wasKept) filled_[from] -= cubeOf(slot.sphere);
  slot.sphere = {
      .x = kMillimetres * change.sphere.x,
      .y = kMillimetres * change.sphere.y,
      .z = kMillimetres * change.sphere.z,
      .radius = kMillimetres * change.sphere.radius,
      .tint = tintAfter(
          options_.colours, slot.tint, slot.initialRadius, kMillimetres * change.sphere.radius)};
  if (wasKept) {
    --counts_[from];
    uncover(from);
  }
  if (!isKept(slot.sphere)) {
    hide(change.slot);
    lightNeighbours(from, emptiness);
    return;
  }
  slot.cell = static_cast<std::uint32_t>(grid_.of(slot.sphere));
  ++counts_[slot.cell];
  filled_[slot.cell] += cubeOf(slot.sphere);
  if (slot.cell != from || !wasKept) cells_[slot.cell].push_back(change.slot);
  show(change.slot);
  lightNeighbours(from, emptiness);
}

std::vector<haptics::engine::SphereChange> SphereCloud::changesSoFar() const {
  std::vector<haptics::engine::SphereChange> changes;
  for (std::uint32_t i = 0; i < slots_.size(); ++i) {
    const auto& now = slots_[i].sphere;
    const auto& then = initial_[i];
    const bool isAsItWas =
        now.x == then.x && now.y == then.y && now.z == then.z && now.radius == then.radius;
    if (isAsItWas) continue;
    changes.push_back(
        {i,
         {now.x / kMillimetres,
          now.y / kMillimetres,
          now.z / kMillimetres,
          now.radius / kMillimetres}});
  }
  return changes;
}

std::size_t SphereCloud::uploadChanges(const Upload& upload) {
  const std::span all(instances_);
  if (isAllNew_) {
    isAllNew_ = false;
    changed_.clear();
    if (!all.empty()) upload(0, all);
    return all.size();
  }
  constexpr std::uint32_t kGap =
      8;  // sending so many unchanged instances is cheaper than another range
  std::sort(changed_.begin(), changed_.end());
  std::size_t sent = 0;
  for (std::size_t i = 0; i < changed_.size();) {
    const std::uint32_t first = changed_[i];
    std::uint32_t last = first;
    for (; i < changed_.size() && changed_[i] <= last + kGap; ++i) last = changed_[i];
    upload(first, all.subspan(first, last - first + 1));
    sent += last - first + 1;
  }
  changed_.clear();
  return sent;
}

}  // namespace study::gui::scene
