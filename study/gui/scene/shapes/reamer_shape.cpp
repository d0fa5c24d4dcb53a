#include "study/gui/scene/shapes/reamer_shape.h"

#include <cmath>
#include <numbers>

#include "study/gui/scene/shapes/solids.h"

namespace study::gui::scene {
namespace {

constexpr float kPi = std::numbers::pi_v<float>;
constexpr Tint kCapSteel{192, 196, 202, 240};
constexpr Tint kToothSteel{214, 218, 223, 245};
constexpr Tint kHole{38, 38, 42, 20};
constexpr Tint kShaftSteel{176, 181, 188, 242};

/// A frame on the cap, @p polar away from its top: x along the way that it turns, z outwards.
QMatrix4x4 onTheCap(float radius, float polar, float azimuth) {
  QMatrix4x4 pose;
  pose.rotate(azimuth * 180.0F / kPi, 0.0F, 0.0F, 1.0F);
  pose.rotate(polar * 180.0F / kPi, 0.0F, 1.0F, 0.0F);
  pose.translate(0.0F, 0.0F, radius);
  pose.rotate(90.0F, 0.0F, 0.0F, 1.0F);
  return pose;
}

/// A lip that rises to its edge, before the hole through which chips go.
Mesh tooth(float size) {
  const float w = 0.75F * size;
  const float h = 0.42F * size;
  Mesh lip = loft(
      {{{-size, -w, -0.2F}, {0.25F * size, -w, -0.2F}, {0.2F * size, -w, h}},
       {{-size, w, -0.2F}, {0.25F * size, w, -0.2F}, {0.2F * size, w, h}}});
  paint(lip, kToothSteel);
  crease(lip, 20.0F);
  return lip;
}

Mesh hole(float size) {
  const QVector3D x(1, 0, 0);
  const QVector3D y(0, 1, 0);
  const QVector3D middle(0.95F * size, 0.0F, 0.0F);
  Mesh disc = loft(
      {circle(middle - QVector3D(0, 0, 0.3F), x, y, 0.72F * size, 9),
       circle(middle + QVector3D(0, 0, 0.05F), x, y, 0.72F * size, 9)});
  paint(disc, kHole);
  crease(disc, 30.0F);
  return disc;
}

/// Teeth in spirals from the top to the rim.
void addTeeth(Mesh& cap, float radius) {
  constexpr int kSpirals = 9;
  constexpr int kPerSpiral = 10;
  const float size = 0.055F * radius;
  for (int spiral = 0; spiral < kSpirals; ++spiral) {
    for (int i = 0; i < kPerSpiral; ++i) {
      const float share = (static_cast<float>(i) + 0.9F) / kPerSpiral;
      const float polar = 0.47F * kPi * share;
      if (i < 2 && spiral % 3 != 0) continue;  // there is no room for all at the top
      const float azimuth = 2.0F * kPi * static_cast<float>(spiral) / kSpirals + 1.5F * share;
      const QMatrix4x4 pose = onTheCap(radius, polar, azimuth);
      for (Mesh part : {tooth(size), hole(size)}) {
        place(part, pose);
        append(cap, part);
      }
    }
  }
}

}  // namespace

ReamerShape reamerShape(float radius) {
  std::vector<QVector2D> profile;
  constexpr int kSteps = 18;
  for (int i = 0; i <= kSteps; ++i) {
    const float polar = 0.5F * kPi * static_cast<float>(i) / kSteps;
    profile.emplace_back(std::max(radius * std::sin(polar), 0.01F), radius * std::cos(polar));
  }
  // Over the rim, and in to the hub on which the shaft sits.
  for (const auto& [r, z] :
       {std::pair{1.0F, -0.06F},
        {0.93F, -0.07F},
        {0.90F, 0.05F},
        {0.40F, 0.05F},
        {0.36F, -0.02F},
        {0.0004F, -0.02F}}) {
    profile.emplace_back(radius * r, radius * z);
  }
  ReamerShape shape{.cap = turned(profile, 56), .shaft = {}};
  paint(shape.cap, kCapSteel);
  crease(shape.cap, 28.0F);
  addTeeth(shape.cap, radius);
  shape.shaft = turned(
      {{0.01F, 2.0F},
       {9.0F, 2.0F},
       {9.4F, 0.0F},
       {9.4F, -7.0F},
       {6.2F, -10.0F},
       {5.4F, -22.0F},
       {5.4F, -150.0F},
       {0.01F, -150.0F}},
      40);
  paint(shape.shaft, kShaftSteel);
  crease(shape.shaft, 30.0F);
  // A flat on one side, so that the turning can be seen.
  Mesh key = loft({slab(-150.0F, 4.6F, 5.9F, 1.3F, 0.2F), slab(-22.0F, 4.6F, 5.9F, 1.3F, 0.2F)});
  paint(key, lit(kShaftSteel, 0.72F));
  crease(key, 30.0F);
  QMatrix4x4 upright;
  upright.rotate(-90.0F, 0.0F, 1.0F, 0.0F);  // x to z
  place(key, upright);
  append(shape.shaft, key);
  return shape;
}

}  // namespace study::gui::scene
