#include "study/gui/simulation/knee_surfaces.h"

#include <algorithm>
#include <cmath>

#include "study/gui/simulation/solids.h"

namespace study::gui::simulation {
namespace {

constexpr Tint kCartilageShade{222, 208, 190, 185};
constexpr Tint kSynoviumPale{205, 128, 112, 140};
constexpr Tint kVessel{128, 34, 36, 120};

/// Places over a rectangle of (u, v) in [0, 1]², row by row, each painted.
template <typename Place, typename Paint>
Mesh surface(int columns, int rows, Place placeOf, Paint tintOf) {
  std::vector<QVector3D> places;
  std::vector<Tint> tints;
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      const float u = static_cast<float>(column) / static_cast<float>(columns - 1);
      const float v = static_cast<float>(row) / static_cast<float>(rows - 1);
      places.push_back(placeOf(u, v));
      tints.push_back(tintOf(u, v));
    }
  }
  Mesh mesh = sheet(places, columns);
  for (std::size_t i = 0; i < tints.size(); ++i) mesh.vertices[i].tint = tints[i];
  return mesh;
}

}  // namespace

Mesh plateauSurface() {
  return surface(
      36,
      36,
      [](float u, float v) {
        const float x = 64.0F * (u - 0.5F);
        const float z = 14.0F - 48.0F * v;
        const float ripple = 0.10F * std::sin(0.55F * x + 0.2F * z) * std::sin(0.45F * z);
        return QVector3D(x, plateauHeight(x, z) + ripple, z);
      },
      [](float u, float v) {
        const float patch = 0.5F + 0.5F * std::sin(7.0F * u + 3.0F) * std::sin(6.0F * v);
        return blend(kCartilage, kCartilageShade, 0.6F * patch);
      });
}

Mesh condyleSurface() {
  const QVector3D centre(-3.0F, 33.5F, -8.0F);
  const QVector3D radii(25.0F, 23.5F, 23.0F);
  return surface(
      50,
      26,
      [&](float u, float v) {
        constexpr float kTurn = 6.2831853F;
        const float around = kTurn * u;
        // From the lowest place; a little beside it, so that every triangle there has a side.
        const float up = 0.30F * kTurn * std::max(v, 0.0005F);
        const float bump = 1.0F + 0.02F * v * v * std::sin(5.0F * around) * std::sin(9.0F * up);
        return centre + bump * radii *
                            QVector3D(
                                std::sin(up) * std::cos(around),
                                -std::cos(up),
                                -std::sin(up) * std::sin(around)) *
                            QVector3D(-1.0F, 1.0F, 1.0F);
      },
      [](float u, float v) {
        const float patch = 0.5F + 0.5F * std::sin(12.0F * u) * std::sin(9.0F * v + 1.0F);
        return blend(kCartilage, kCartilageShade, 0.4F * patch);
      });
}

Mesh capsuleSurface(const KneeLayout& layout) {
  return surface(
      96,
      30,
      [&](float u, float v) {
        const float angle = -150.0F + 300.0F * u;
        const float fold = 0.55F * std::sin(0.21F * angle + 3.0F * v) +
                           0.30F * std::sin(0.53F * angle - 9.0F * v) + 0.35F * std::sin(17.0F * v);
        QVector3D place = onArc(layout, angle, layout.outerRadius + 1.2F + fold + 3.0F * v);
        place.setY(-3.0F + 36.0F * v);
        return place;
      },
      [](float u, float v) {
        const float vein =
            std::sin(60.0F * u + 5.0F * std::sin(7.0F * v)) * std::sin(9.0F * v + 20.0F * u);
        const float pale = 0.5F + 0.5F * std::sin(23.0F * u + 4.0F * v);
        const Tint ground = blend(kSynovium, kSynoviumPale, 0.7F * pale);
        return vein > 0.86F ? blend(ground, kVessel, 0.55F) : ground;
      });
}

}  // namespace study::gui::simulation
