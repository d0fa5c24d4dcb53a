#include "study/gui/scene/shapes/bone_tints.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace study::gui::scene {
namespace {

constexpr Tint kCortical{246, 231, 209, 40};
constexpr Tint kCancellous{226, 186, 160, 30};
constexpr Tint kUntouched{138, 150, 164, 25};

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
Tint along(const std::array<Tint, N>& stops, float share) {
  const float at = std::clamp(share, 0.0F, 1.0F) * static_cast<float>(N - 1);
  const auto low = std::min(static_cast<std::size_t>(at), N - 2);
  return blend(stops[low], stops[low + 1], at - static_cast<float>(low));
}

}  // namespace

DensityRange densityRangeOf(const haptics::reaming::SphereField& field) {
  std::vector<double> densities;
  for (std::size_t slot = 0; slot < field.slotCount(); ++slot) {
    if (field.group(slot).radius[slot % haptics::reaming::kLanes] > 0.0F) {
      densities.push_back(static_cast<double>(densityOf(field, slot)));
    }
  }
  std::sort(densities.begin(), densities.end());
  const std::size_t beyond = densities.size() / 50;
  return {densities[beyond], densities[densities.size() - 1 - beyond]};
}

BoneTints::BoneTints(const haptics::reaming::SphereField& field, SphereColours colours)
    : field_(field), colours_(colours) {
  if (colours == SphereColours::Density) range_ = densityRangeOf(field);
}

Tint BoneTints::of(std::size_t slot, bool isAtTheSurface) const {
  switch (colours_) {
    case SphereColours::Neutral:
      return shaded(isAtTheSurface ? kCortical : kCancellous, 0.86F + 0.14F * variationOf(slot));
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

Tint tintAfter(SphereColours colours, Tint tint, float whole, float left) {
  if (colours != SphereColours::Removal) return tint;
  const float gone =
      whole > 0.0F ? 1.0F - left / whole : 0.5F;  // 0.5: split off from another sphere
  return removalTint(gone);
}

Tint scaleTint(float share) {
  constexpr std::array kViridis{
      Tint{68, 1, 84, 35},
      Tint{59, 82, 139, 35},
      Tint{33, 145, 140, 35},
      Tint{94, 201, 98, 35},
      Tint{253, 231, 37, 35}};
  return along(kViridis, share);
}

Tint untouchedTint() {
  return kUntouched;
}

Tint removalTint(float share) {
  constexpr std::array kInferno{
      Tint{87, 16, 110, 35}, Tint{188, 55, 84, 35}, Tint{249, 142, 9, 35}, Tint{252, 255, 164, 35}};
  return along(kInferno, share);
}

}  // namespace study::gui::scene
