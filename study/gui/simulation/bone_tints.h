#pragma once

#include "haptics/reaming/sphere_field.h"
#include "study/gui/simulation/sphere_cloud.h"

namespace study::gui::simulation {

/// The colours of a bone's spheres.
class BoneTints {
 public:
  BoneTints(const haptics::reaming::SphereField& field, SphereColours colours);

  /// Of the sphere in @p slot, which lies at the bone's surface or within it.
  Tint of(std::size_t slot, bool isAtTheSurface) const;

 private:
  const haptics::reaming::SphereField& field_;
  SphereColours colours_;
  float softest_ = 0.0F;  ///< [N/m²]
  float hardest_ = 1.0F;
};

/// The colour of a sphere that was painted @p tint and had a radius of @p whole, with @p left of it
/// [mm].
Tint tintAfter(SphereColours colours, Tint tint, float whole, float left);

/// From low (0) to high (1): viridis, which reads the same in grey and to the colour-blind.
Tint scaleTint(float share);

}  // namespace study::gui::simulation
