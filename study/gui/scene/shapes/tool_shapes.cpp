#include "study/gui/scene/shapes/tool_shapes.h"

#include <cmath>
#include <numbers>

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

/// A plate between two rails; the upper jaw closes between them.
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
    // The plates at both sides that hold the hinge.
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
  append(handle, finished(fingerRing({-136, -71, 0}, 12.0F, 2.4F), kSteel));
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
  append(lever, finished(fingerRing({-109, -71, 0}, 12.0F, 2.4F), kSteel));
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

namespace {

constexpr float kPi = std::numbers::pi_v<float>;
constexpr Tint kCapSteel{192, 196, 202, 240};
constexpr Tint kToothSteel{214, 218, 223, 245};
constexpr Tint kHole{38, 38, 42, 20};
constexpr Tint kShaftSteel{176, 181, 188, 242};

/// A frame on the cap at the angle @p polar from its top: x in the direction of rotation, z
/// outwards.
QMatrix4x4 onTheCap(float radius, float polar, float azimuth) {
  QMatrix4x4 pose;
  pose.rotate(azimuth * 180.0F / kPi, 0.0F, 0.0F, 1.0F);
  pose.rotate(polar * 180.0F / kPi, 0.0F, 1.0F, 0.0F);
  pose.translate(0.0F, 0.0F, radius);
  pose.rotate(90.0F, 0.0F, 0.0F, 1.0F);
  return pose;
}

/// A tooth of the reamer: a lip that rises to a cutting edge in front of a hole for chips.
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

/// Adds teeth in spirals from the top to the rim.
void addTeeth(Mesh& cap, float radius) {
  constexpr int kSpirals = 9;
  constexpr int kPerSpiral = 10;
  const float size = 0.055F * radius;
  for (int spiral = 0; spiral < kSpirals; ++spiral) {
    for (int i = 0; i < kPerSpiral; ++i) {
      const float share = (static_cast<float>(i) + 0.9F) / kPerSpiral;
      const float polar = 0.47F * kPi * share;
      if (i < 2 && spiral % 3 != 0) continue;  // the top has no room for all
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
  // The profile goes over the rim and inwards to the hub on the shaft.
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
  // A flat on one side makes the rotation visible.
  Mesh key = loft({slab(-150.0F, 4.6F, 5.9F, 1.3F, 0.2F), slab(-22.0F, 4.6F, 5.9F, 1.3F, 0.2F)});
  paint(key, shaded(kShaftSteel, 0.72F));
  crease(key, 30.0F);
  QMatrix4x4 upright;
  upright.rotate(-90.0F, 0.0F, 1.0F, 0.0F);  // turns x to z
  place(key, upright);
  append(shape.shaft, key);
  return shape;
}

}  // namespace study::gui::scene
