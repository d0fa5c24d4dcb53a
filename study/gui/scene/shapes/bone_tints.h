#pragma once

#include "haptics/reaming/bone/sphere_field.h"
#include "study/gui/scene/shapes/sphere_cloud.h"

namespace study::gui::scene {

/// The densities at both ends of the colour scale, and from mark to mark: round numbers.
struct DensityRange {
  double softest = 0.0;  ///< this or softer [N/m²]
  double hardest = 1.0;  ///< this or harder [N/m²]
  double step = 0.25;    ///< [N/m²]
};

/// The smallest range with at most six round marks that contains both densities.
DensityRange roundedRange(double softest, double hardest);

/// The rounded range that holds at least 96 % of a bone's spheres: at most one in fifty lies beyond
/// each end.
DensityRange densityRangeOf(const haptics::reaming::SphereField& field);

/// Computes the colours of a bone's spheres.
class BoneTints {
 public:
  BoneTints(const haptics::reaming::SphereField& field, SphereColours colours);

  /// The colour of the sphere in @p slot at the bone's surface, or inside the bone.
  Tint of(std::size_t slot, bool isAtTheSurface) const;

 private:
  const haptics::reaming::SphereField& field_;
  SphereColours colours_;
  DensityRange range_;
};

/// The colour of a sphere with the initial colour @p tint and radius @p initialRadius [mm] when its
/// radius has become @p left [mm].
Tint tintAfter(SphereColours colours, Tint tint, float initialRadius, float left);

/// The colour @p tint of neutral bone where less light reaches it between neighbours, from 0 (all
/// around) to 1 (@p openness at the surface).
Tint tintInGap(Tint tint, float openness);

/// The colour of a density from soft (0) to hard (1). The scale is viridis: its lightness rises
/// evenly, so it can be read in grey and with colour blindness.
Tint scaleTint(float share);

/// The colour of a sphere that the reamer has not touched.
Tint untouchedTint();

/// The colour of a sphere of which the reamer has removed a share, from 0 (just touched) to 1
/// (almost all). It falls from bright to dark and differs from that of an untouched sphere
/// everywhere.
Tint removalTint(float share);

}  // namespace study::gui::scene
