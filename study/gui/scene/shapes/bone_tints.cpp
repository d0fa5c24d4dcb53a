#include "study/gui/scene/shapes/bone_tints.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace study::gui::scene {
namespace {

constexpr Tint kCortical{246, 238, 222, 40};
constexpr Tint kCancellous{247, 224, 197, 30};
constexpr Tint kMarrow{176, 102, 78, 30};
constexpr Tint kUntouched{218, 210, 194, 25};

/// A pseudo-random number in [0, 1] from the slot's index, which makes each sphere look slightly
/// different.
float variationOf(std::size_t slot) {
  const auto mixed = static_cast<std::uint32_t>(slot) * 2654435761U;
  return static_cast<float>(mixed >> 16U) / 65535.0F;
}

float densityOf(const haptics::reaming::SphereField& field, std::size_t slot) {
  return field.group(slot).density[slot % haptics::reaming::kLanes];
}

/// The interpolated colour at @p share of the way through @p stops.
template <std::size_t N>
Tint interpolateAlong(const std::array<Tint, N>& stops, float share) {
  const float at = std::clamp(share, 0.0F, 1.0F) * static_cast<float>(N - 1);
  const auto low = std::min(static_cast<std::size_t>(at), N - 2);
  return blend(stops[low], stops[low + 1], at - static_cast<float>(low));
}

}  // namespace

DensityRange roundedRange(double softest, double hardest) {
  constexpr double kMost = 5.0;    // steps
  constexpr double kLeast = 0.01;  // width of the scale, by its hardest end
  const double width = std::max({hardest - softest, kLeast * std::abs(hardest), 1e-9});
  const double decade = std::pow(10.0, std::floor(std::log10(width / kMost)));
  DensityRange range;
  for (const double digit : {1.0, 2.0, 2.5, 5.0, 10.0, 20.0}) {
    const double step = digit * decade;
    range = {step * std::floor(softest / step), step * std::ceil(hardest / step), step};
    if (range.hardest <= range.softest) range.hardest = range.softest + step;
    if (std::lround((range.hardest - range.softest) / step) <= std::lround(kMost)) break;
  }
  return range;
}

DensityRange densityRangeOf(const haptics::reaming::SphereField& field) {
  std::vector<double> densities;
  for (std::size_t slot = 0; slot < field.slotCount(); ++slot) {
    if (field.group(slot).radius[slot % haptics::reaming::kLanes] > 0.0F) {
      densities.push_back(static_cast<double>(densityOf(field, slot)));
    }
  }
  std::sort(densities.begin(), densities.end());
  const std::size_t beyond = densities.size() / 50;
  return roundedRange(densities[beyond], densities[densities.size() - 1 - beyond]);
}

BoneTints::BoneTints(const haptics::reaming::SphereField& field, SphereColours colours)
    : field_(field), colours_(colours) {
  if (colours == SphereColours::Density) range_ = densityRangeOf(field);
}

Tint BoneTints::of(std::size_t slot, bool isAtTheSurface) const {
  switch (colours_) {
    case SphereColours::Neutral:
      return shaded(isAtTheSurface ? kCortical : kCancellous, 0.94F + 0.06F * variationOf(slot));
    case SphereColours::Density: {
      const double range = range_.hardest - range_.softest;
      const double above = static_cast<double>(densityOf(field_, slot)) - range_.softest;
      return scaleTint(range > 0.0 ? static_cast<float>(above / range) : 0.5F);
    }
    case SphereColours::Removal:
      return shaded(untouchedTint(), 0.95F + 0.05F * variationOf(slot));
  }
  return kCortical;
}

Tint tintAfter(SphereColours colours, Tint tint, float initialRadius, float left) {
  if (colours != SphereColours::Removal) return tint;
  const float gone = initialRadius > 0.0F ? 1.0F - left / initialRadius
                                          : 0.5F;  // 0.5: split off from another sphere
  return removalTint(gone);
}

Tint tintInGap(Tint tint, float openness) {
  const float shut = 1.0F - openness;
  return shaded(blend(tint, kMarrow, 0.35F * shut), 1.0F - 0.3F * shut);
}

Tint scaleTint(float share) {
  constexpr std::array kViridis{
      Tint{104, 85, 173, 35},
      Tint{72, 120, 182, 35},
      Tint{33, 155, 150, 35},
      Tint{94, 201, 98, 35},
      Tint{253, 231, 37, 35}};
  return interpolateAlong(kViridis, share);
}

Tint untouchedTint() {
  return kUntouched;
}

Tint removalTint(float share) {
  constexpr std::array kYellowToRed{
      Tint{255, 226, 92, 35}, Tint{246, 150, 48, 35}, Tint{206, 66, 40, 35}, Tint{96, 8, 30, 35}};
  return interpolateAlong(kYellowToRed, share);
}

}  // namespace study::gui::scene
