#pragma once

#include "haptics/reaming/bone/sphere_field.h"
#include "study/gui/scene/shapes/sphere_cloud.h"

namespace study::gui::scene {

/// What the ends of the colours of a density mean.
struct DensityRange {
  double softest = 0.0;  ///< and what is softer [N/m²]
  double hardest = 1.0;  ///< and what is harder [N/m²]
};

/// Of nearly all spheres of a bone: one in fifty lies beyond each end.
DensityRange densityRangeOf(const haptics::reaming::SphereField& field);

/// The colours of a bone's spheres.
class BoneTints {
 public:
  BoneTints(const haptics::reaming::SphereField& field, SphereColours colours);

  /// Of the sphere in @p slot, which lies at the bone's surface or within it.
  Tint of(std::size_t slot, bool isAtTheSurface) const;

 private:
  const haptics::reaming::SphereField& field_;
  SphereColours colours_;
  DensityRange range_;
};

/// The colour of a sphere that was painted @p tint and had a radius of @p whole, with @p left of it
/// [mm].
Tint tintAfter(SphereColours colours, Tint tint, float whole, float left);

/// A density from soft (0) to hard (1): viridis, which reads the same in grey and to the
/// colour-blind.
Tint scaleTint(float share);

/// A sphere that the reamer has not touched.
Tint untouchedTint();

/// How much of a sphere the reamer has taken, from just touched (0) to nearly all (1): from dark to
/// bright as well, and nowhere like an untouched one.
Tint removalTint(float share);

}  // namespace study::gui::scene
