#include "study/gui/scene/shapes/punch_shape.h"

#include <cmath>

#include "study/gui/scene/shapes/solids.h"

namespace study::gui::scene {
namespace {

constexpr Tint kSteel{186, 190, 196, 242};
constexpr Tint kJawSteel{206, 210, 215, 246};
constexpr Tint kDarkSteel{128, 133, 140, 230};

constexpr float kJawOpen = 38.0F;    // [°]
constexpr float kLeverOpen = 17.0F;  // [°]
constexpr float kRodStroke = 3.2F;   // [mm]
constexpr float kPivotHeight = 0.35F;
const QVector3D kLeverPivot(-112.0F, -3.0F, 0.0F);

Mesh finished(Mesh mesh, Tint tint, float angle = 35.0F) {
  paint(mesh, tint);
  crease(mesh, angle);
  return mesh;
}

/// A plate with a rail on either side, between which the upper jaw bites.
Mesh lowerJaw() {
  Mesh jaw = finished(
      loft(
          {slab(-4.0F, -1.8F, 0.4F, 1.7F, 0.9F),
           slab(-0.5F, -1.7F, 0.0F, 1.9F, 0.5F),
           slab(3.0F, -1.45F, 0.0F, 2.0F, 0.4F),
           slab(7.0F, -1.25F, 0.0F, 1.85F, 0.4F),
           slab(8.6F, -1.0F, 0.0F, 1.3F, 0.4F),
           slab(9.2F, -0.7F, -0.05F, 0.6F, 0.3F)}),
      kJawSteel);
  for (const float side : {-1.0F, 1.0F}) {
    Mesh rail = finished(
        loft(
            {slab(-1.0F, -0.6F, 0.5F, 0.22F, 0.15F),
             slab(5.0F, -0.6F, 0.45F, 0.22F, 0.15F),
             slab(7.9F, -0.6F, 0.3F, 0.18F, 0.12F)}),
        kJawSteel);
    QMatrix4x4 aside;
    aside.translate(0.0F, 0.0F, side * 1.72F);
    place(rail, aside);
    append(jaw, rail);
  }
  return jaw;
}

Mesh upperJaw() {
  Mesh jaw = finished(
      loft(
          {slab(-2.6F, -0.5F, 1.1F, 1.0F, 0.5F),
           slab(-0.6F, -0.45F, 1.6F, 1.25F, 0.6F),
           slab(2.0F, -0.3F, 1.55F, kJawHalfWidth, 0.6F),
           slab(5.5F, -0.3F, 1.3F, kJawHalfWidth, 0.5F),
           slab(7.6F, -0.28F, 0.95F, 1.1F, 0.45F),
           slab(8.7F, -0.2F, 0.45F, 0.5F, 0.25F)}),
      kJawSteel);
  Mesh pin = rod(-1.9F, 1.9F, 0.62F, 20);
  QMatrix4x4 across;
  across.rotate(90.0F, 0.0F, 1.0F, 0.0F);
  place(pin, across);
  append(jaw, finished(std::move(pin), kDarkSteel));
  return jaw;
}

Mesh shaft() {
  Mesh mesh = finished(rod(-122.0F, -3.0F, 1.9F), kSteel);
  QMatrix4x4 below;
  below.translate(0.0F, -0.4F, 0.0F);
  place(mesh, below);
  for (const float side : {-1.0F, 1.0F}) {
    // The cheeks that hold the hinge.
    Mesh cheek = finished(
        loft({slab(-5.0F, -1.2F, 1.0F, 0.28F, 0.2F), slab(1.1F, -1.2F, 0.95F, 0.28F, 0.2F)}),
        kSteel);
    QMatrix4x4 aside;
    aside.translate(0.0F, 0.0F, side * 1.6F);
    place(cheek, aside);
    append(mesh, cheek);
  }
  return mesh;
}

Mesh fixedHandle() {
  Mesh handle = finished(
      loft(
          {slab(-128.0F, -8.0F, 4.0F, 3.4F, 2.5F),
           slab(-124.0F, -9.0F, 5.0F, 4.2F, 3.0F),
           slab(-108.0F, -6.5F, 3.6F, 3.6F, 2.5F),
           slab(-102.0F, -2.8F, 2.2F, 2.4F, 1.8F)}),
      kDarkSteel);
  append(
      handle,
      finished(
          bent(
              {{-122, -4, 0}, {-127, -18, 0}, {-131, -34, 0}, {-133, -48, 0}, {-134, -58, 0}},
              {3.4F, 3.0F, 2.7F, 2.5F, 2.4F}),
          kSteel));
  append(handle, finished(eyelet({-136, -71, 0}, 12.0F, 2.4F), kSteel));
  return handle;
}

Mesh movingHandle() {
  Mesh lever = finished(
      bent(
          {{-112, 1, 0},
           {-112, -8, 0},
           {-109, -22, 0},
           {-107, -36, 0},
           {-107, -50, 0},
           {-108, -58, 0}},
          {2.4F, 3.2F, 2.9F, 2.6F, 2.5F, 2.4F}),
      kSteel);
  append(lever, finished(eyelet({-109, -71, 0}, 12.0F, 2.4F), kSteel));
  Mesh pin = rod(-4.6F, 4.6F, 2.4F, 24);
  QMatrix4x4 across;
  across.translate(kLeverPivot);
  across.rotate(90.0F, 0.0F, 1.0F, 0.0F);
  place(pin, across);
  append(lever, finished(std::move(pin), kDarkSteel));
  return lever;
}

QMatrix4x4 turnedAround(QVector3D pivot, float angle) {
  QMatrix4x4 pose;
  pose.translate(pivot);
  pose.rotate(angle, 0.0F, 0.0F, 1.0F);
  pose.translate(-pivot);
  return pose;
}

}  // namespace

PunchShape punchShape() {
  PunchShape shape{
      .body = shaft(),
      .grip = fixedHandle(),
      .jaw = upperJaw(),
      .rod = finished(rod(-118.0F, -3.4F, 0.75F, 16), kDarkSteel),
      .lever = movingHandle()};
  QMatrix4x4 onTop;
  onTop.translate(0.0F, 1.75F, 0.0F);
  place(shape.rod, onTop);
  append(shape.body, lowerJaw());
  return shape;
}

QMatrix4x4 jawPose(float openness) {
  return turnedAround({0.0F, kPivotHeight, 0.0F}, kJawOpen * openness);
}

QMatrix4x4 rodPose(float openness) {
  QMatrix4x4 pose;
  pose.translate(-kRodStroke * openness, 0.0F, 0.0F);
  return pose;
}

QMatrix4x4 leverPose(float openness) {
  return turnedAround(kLeverPivot, kLeverOpen * openness);
}

float jawHeight(float openness, float x) {
  constexpr float kDegree = 3.14159265F / 180.0F;
  constexpr float kBelowThePivot = 0.3F;
  const float angle = kDegree * kJawOpen * openness;
  return kPivotHeight + x * std::tan(angle) - kBelowThePivot / std::cos(angle);
}

}  // namespace study::gui::scene
