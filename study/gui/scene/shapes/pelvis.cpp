#include "study/gui/scene/shapes/pelvis.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "study/gui/scene/shapes/noise.h"
#include "study/gui/scene/shapes/solids.h"

namespace study::gui::scene {
namespace {

constexpr float kHalfTurn = std::numbers::pi_v<float>;
constexpr Tint kShell{246, 236, 216, 70};   // cortical bone
constexpr Tint kSponge{240, 216, 184, 40};  // cancellous bone
constexpr Tint kPelvisMarrow{206, 150, 120, 40};
constexpr float kBeforeTheBone = 0.05F;  // so that the section hides the edge of what it surrounds
constexpr float kRimThickness = 5.0F;    // [mm]

/// A hill of height 1 and half width @p width at @p middle.
float hill(float at, float middle, float width) {
  const float away = (at - middle) / width;
  return std::exp(-away * away);
}

/// The thickness of the bone in the section at @p angle [radian] from the ischium (0) to the ilium
/// (π) [mm].
float thicknessAt(float angle) {
  const float share = angle / kHalfTurn;
  const float rough = 0.5F * roughnessAt({4.0F * angle, 0.0F, 0.0F}, 3);
  return kRimThickness + 10.0F * hill(share, 0.7F, 0.15F) + 6.0F * hill(share, 0.17F, 0.1F) + rough;
}

/// The colour of the section at @p place, @p depth [mm] inside the bone's nearer border: a dense
/// shell around a sponge of bone and marrow.
Tint sectionTint(QVector3D place, float depth) {
  const float pores = std::clamp(0.45F + 1.3F * roughnessAt(0.55F * place, 3), 0.0F, 1.0F);
  const Tint sponge = blend(kSponge, kPelvisMarrow, 0.6F * pores);
  return blend(kShell, sponge, std::clamp((depth - 0.9F) / 0.9F, 0.0F, 1.0F));
}

/// The height of the rim above z = 0 at @p share of the way from the ischium to the ilium [mm]: it
/// has a notch below.
float rimHeight(float share) {
  return 2.6F - 4.5F * hill(share, 0.26F, 0.07F) + 0.4F * noiseAt({9.0F * share, 2.0F, 0.0F});
}

/// The rounding of the rim at @p share of the way across it, in [0, 1].
float crownAt(float share) {
  return std::sqrt(std::max(0.0F, 1.0F - std::pow(2.0F * share - 1.0F, 4.0F)));
}

/// The section at y = 0.
Mesh section(float inner) {
  const auto place = [inner](float share, float outwards) {
    const float angle = kHalfTurn * share;
    const QVector3D out(std::cos(angle), 0.0F, std::sin(angle));
    const bool isAtRim = share <= 0.0F || share >= 1.0F;
    const float lip = isAtRim ? rimHeight(share) * crownAt(outwards) : 0.0F;
    return (inner + outwards * thicknessAt(angle)) * out - QVector3D(0.0F, kBeforeTheBone, lip);
  };
  Mesh mesh = surface(181, 15, place, [](float share, float outwards, QVector3D at) {
    return sectionTint(at, thicknessAt(kHalfTurn * share) * std::min(outwards, 1.0F - outwards));
  });
  for (auto& vertex : mesh.vertices) vertex.normal = {0.0F, -1.0F, 0.0F};
  return mesh;
}

/// The rim around the opening, rounded.
Mesh rim(float inner) {
  const auto place = [inner](float share, float across) {
    const float angle = kHalfTurn * share;
    const float thickness = share < 0.5F ? thicknessAt(0.0F) : thicknessAt(kHalfTurn);
    const QVector3D out(std::cos(angle), std::sin(angle), 0.0F);
    return (inner + thickness * across) * out -
           QVector3D(0.0F, 0.0F, rimHeight(share) * crownAt(across));
  };
  return surface(65, 9, place, [](float, float, QVector3D at) {
    return blend(kShell, kSponge, std::clamp(0.3F + 0.6F * roughnessAt(0.4F * at, 3), 0.0F, 1.0F));
  });
}

}  // namespace

Mesh pelvisAround(float inner) {
  Mesh mesh = section(inner);
  append(mesh, rim(inner));
  return mesh;
}

/// The rings go from one end of the edge between the two to the other, where they have no area: a
/// cap of loft() that is a crescent would cover the cup.
Mesh halfShell(float inner, float outer) {
  constexpr int kRings = 72;
  constexpr int kSteps = 32;
  std::vector<Ring> rings;
  for (int i = 0; i <= kRings; ++i) {
    const float along = kHalfTurn * static_cast<float>(i) / kRings;
    Ring ring;
    for (const float radius : {inner, outer}) {
      for (int k = 0; k <= kSteps; ++k) {
        const int step = radius == inner ? k : kSteps - k;
        const float turned = 0.5F * kHalfTurn * static_cast<float>(step) / kSteps;
        const QVector3D out(0.0F, std::sin(turned), std::cos(turned));
        ring.push_back(radius * (std::sin(along) * out + QVector3D(std::cos(along), 0.0F, 0.0F)));
      }
    }
    rings.push_back(std::move(ring));
  }
  Mesh shell = loft(rings);
  crease(shell, 30.0F);
  for (auto& vertex : shell.vertices) {
    const float pores = std::clamp(0.4F + roughnessAt(0.5F * vertex.position, 3), 0.0F, 1.0F);
    vertex.tint = blend(kShell, kSponge, pores);
  }
  return shell;
}

}  // namespace study::gui::scene
