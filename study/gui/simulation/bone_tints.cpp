#include "study/gui/simulation/bone_tints.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace study::gui::simulation {
namespace {

constexpr Tint kCortical{243, 235, 214, 40};
constexpr Tint kCancellous{226, 186, 160, 30};
constexpr Tint kUntouched{200, 200, 194, 25};
constexpr Tint kGrazed{247, 201, 72, 40};
constexpr Tint kNearlyGone{200, 44, 36, 40};

/// No two spheres are quite alike: from 0 to 1, by their number.
float chanceOf(std::size_t slot) {
  const auto mixed = static_cast<std::uint32_t>(slot) * 2654435761U;
  return static_cast<float>(mixed >> 16U) / 65535.0F;
}

float densityOf(const haptics::reaming::SphereField& field, std::size_t slot) {
  return field.group(slot).density[slot % haptics::reaming::kLanes];
}

}  // namespace

BoneTints::BoneTints(const haptics::reaming::SphereField& field, SphereColours colours)
    : field_(field), colours_(colours) {
  if (colours != SphereColours::Density) return;
  std::vector<float> densities;
  for (std::size_t slot = 0; slot < field.slotCount(); ++slot) {
    if (field.group(slot).radius[slot % haptics::reaming::kLanes] > 0.0F) {
      densities.push_back(densityOf(field, slot));
    }
  }
  std::sort(densities.begin(), densities.end());
  softest_ = densities[densities.size() / 50];
  hardest_ = densities[densities.size() - 1 - densities.size() / 50];
}

Tint BoneTints::of(std::size_t slot, bool isAtTheSurface) const {
  switch (colours_) {
    case SphereColours::Neutral:
      return lit(isAtTheSurface ? kCortical : kCancellous, 0.86F + 0.14F * chanceOf(slot));
    case SphereColours::Density: {
      const float range = hardest_ - softest_;
      return scaleTint(range > 0.0F ? (densityOf(field_, slot) - softest_) / range : 0.5F);
    }
    case SphereColours::Removal:
      return lit(kUntouched, 0.9F + 0.1F * chanceOf(slot));
  }
  return kCortical;
}

Tint tintAfter(SphereColours colours, Tint tint, float whole, float left) {
  if (colours != SphereColours::Removal) return tint;
  const float gone = whole > 0.0F ? 1.0F - left / whole : 0.5F;  // split off: part of another
  return blend(kGrazed, kNearlyGone, std::clamp(gone, 0.0F, 1.0F));
}

Tint scaleTint(float share) {
  constexpr std::array kViridis{
      Tint{68, 1, 84, 35},
      Tint{59, 82, 139, 35},
      Tint{33, 145, 140, 35},
      Tint{94, 201, 98, 35},
      Tint{253, 231, 37, 35}};
  const float at = std::clamp(share, 0.0F, 1.0F) * static_cast<float>(kViridis.size() - 1);
  const auto low = std::min(static_cast<std::size_t>(at), kViridis.size() - 2);
  return blend(kViridis[low], kViridis[low + 1], at - static_cast<float>(low));
}

}  // namespace study::gui::simulation
