#include "study/gui/scene/shapes/tool_shapes.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "study/gui/scene/shapes/solids.h"

namespace study::gui::scene {

namespace {

constexpr Tint kSteel{186, 190, 196, 242};
constexpr Tint kJawSteel{214, 212, 212, 246};
constexpr Tint kDarkSteel{128, 133, 140, 230};

constexpr float kJawOpen = 38.0F;    // [°]
constexpr float kLeverOpen = 17.0F;  // [°]
constexpr float kRodStroke = 3.2F;   // [mm]
constexpr float kPivotHeight = 0.35F;
const QVector3D kLeverPivot(-112.0F, -3.0F, 0.0F);

Mesh creasedAndTinted(Mesh mesh, Tint tint, float angle = 35.0F) {
  paint(mesh, tint);
  crease(mesh, angle);
  return mesh;
}

/// A cross-section of the basket at @p x, from its bottom at @p low to its rim at @p rim, @p half
/// as wide: a trough with walls and a floor.
Ring trough(float x, float low, float rim, float half) {
  const float wall = std::min(0.42F, 0.6F * half);
  const float floor = std::min(low + 0.45F, rim - 0.02F);
  const float bevel = std::min(0.4F, 0.5F * half);
  const std::vector<QVector2D> right{
      {half - bevel, low},
      {half, low + bevel},
      {half, rim - 0.1F},
      {half - 0.1F, rim},
      {half - wall, rim},
      {half - wall - 0.05F, floor}};
  Ring ring;
  for (const auto& corner : right) ring.emplace_back(x, corner.y(), corner.x());
  const std::vector left(right.rbegin(), right.rend());
  for (const auto& corner : left) ring.emplace_back(x, corner.y(), -corner.x());
  return ring;
}

/// A basket that is open at the top; the upper jaw closes into it.
Mesh lowerJaw() {
  return creasedAndTinted(
      loft(
          {trough(-3.4F, -1.9F, -0.95F, 1.36F),
           trough(0.9F, -1.75F, -0.6F, 1.36F),
           trough(1.9F, -1.6F, -0.02F, 1.92F),
           trough(4.5F, -1.45F, 0.0F, 1.96F),
           trough(6.6F, -1.3F, 0.0F, 1.84F),
           trough(7.8F, -1.12F, 0.0F, 1.5F),
           trough(8.6F, -0.9F, 0.0F, 1.06F),
           trough(9.1F, -0.66F, -0.02F, 0.62F),
           trough(9.35F, -0.42F, -0.06F, 0.25F)}),
      kJawSteel);
}

/// A disc with its middle at the hinge, from @p from to @p to along z.
Mesh atTheHinge(float radius, float from, float to) {
  constexpr int kCorners = 32;
  std::vector<QVector2D> outline;
  for (const auto& corner :
       circle({0.0F, kPivotHeight, 0.0F}, {1, 0, 0}, {0, 1, 0}, radius, kCorners))
    outline.emplace_back(corner.x(), corner.y());
  return plate(outline, from, to, 0.14F);
}

Mesh upperJaw() {
  Mesh jaw = creasedAndTinted(
      loft(
          {slab(-0.9F, -0.55F, 1.15F, 1.2F, 0.5F),
           slab(0.6F, -0.42F, 1.5F, 1.3F, 0.55F),
           slab(2.4F, -0.3F, 1.6F, kJawHalfWidth, 0.6F),
           slab(4.4F, -0.3F, 1.5F, kJawHalfWidth, 0.6F),
           slab(6.2F, -0.3F, 1.24F, 1.34F, 0.55F),
           slab(7.5F, -0.29F, 0.96F, 1.1F, 0.46F),
           slab(8.3F, -0.27F, 0.7F, 0.8F, 0.36F),
           slab(8.75F, -0.22F, 0.44F, 0.42F, 0.26F)}),
      kJawSteel);
  append(jaw, creasedAndTinted(atTheHinge(1.25F, -1.3F, 1.3F), kJawSteel));
  return jaw;
}

/// One side of the fork that holds the hinge.
Mesh prong(float from, float to) {
  std::vector<QVector2D> outline{{-6.4F, 0.0F}, {-6.4F, -0.9F}, {-3.6F, -1.6F}};
  constexpr int kSteps = 12;
  constexpr float kRadius = 1.6F;
  for (int i = 0; i <= kSteps; ++i) {
    const float angle = 3.14159265F * (static_cast<float>(i) / kSteps - 0.5F);
    outline.emplace_back(
        0.4F + kRadius * std::cos(angle), kPivotHeight - 0.25F + kRadius * std::sin(angle));
  }
  outline.emplace_back(-3.6F, 1.5F);
  return plate(outline, from, to, 0.14F);
}

/// The tube, and the fork at its end with the pin of the hinge.
Mesh shaft() {
  Mesh mesh = creasedAndTinted(rod(-122.0F, -8.4F, 2.1F), kSteel);
  QMatrix4x4 below;
  below.translate(0.0F, -0.4F, 0.0F);
  place(mesh, below);
  append(
      mesh,
      creasedAndTinted(
          loft(
              {slab(-8.6F, -2.44F, 1.64F, 2.06F, 2.04F),
               slab(-7.4F, -2.4F, 1.6F, 2.08F, 1.7F),
               slab(-5.6F, -2.15F, 1.5F, 2.08F, 0.9F),
               slab(-4.9F, -1.95F, 1.3F, 2.02F, 0.8F)}),
          kSteel));
  append(mesh, creasedAndTinted(prong(1.42F, 2.0F), kSteel));
  append(mesh, creasedAndTinted(prong(-2.0F, -1.42F), kSteel));
  append(mesh, creasedAndTinted(atTheHinge(0.72F, -2.16F, 2.16F), kDarkSteel));
  return mesh;
}

/// The rod lies half in the tube, and ends in the link that turns the jaw.
Mesh pushRod() {
  Mesh mesh = rod(-118.0F, -5.6F, 0.78F, 20);
  QMatrix4x4 onTop;
  onTop.translate(0.0F, 1.3F, 0.0F);
  place(mesh, onTop);
  append(
      mesh,
      loft(
          {slab(-6.0F, 0.8F, 1.9F, 0.55F, 0.3F),
           slab(-3.0F, 0.9F, 1.9F, 0.5F, 0.3F),
           slab(-0.4F, 0.7F, 1.5F, 0.45F, 0.3F)}));
  return creasedAndTinted(std::move(mesh), kDarkSteel);
}

Mesh fixedHandle() {
  Mesh handle = creasedAndTinted(
      loft(
          {slab(-130.0F, -5.4F, 1.8F, 1.6F, 1.5F),
           slab(-129.4F, -7.0F, 3.2F, 2.8F, 2.4F),
           slab(-128.0F, -8.2F, 4.2F, 3.6F, 2.9F),
           slab(-124.0F, -9.0F, 4.9F, 4.2F, 3.3F),
           slab(-116.0F, -8.6F, 4.6F, 4.1F, 3.2F),
           slab(-109.0F, -6.6F, 3.7F, 3.6F, 2.8F),
           slab(-104.5F, -4.2F, 2.7F, 2.9F, 2.4F),
           slab(-101.0F, -2.7F, 1.9F, 2.3F, 2.2F)}),
      kDarkSteel,
      60.0F);
  append(
      handle,
      creasedAndTinted(
          bentTube(
              {{-122, -4, 0},
               {-127, -18, 0},
               {-131, -34, 0},
               {-133, -48, 0},
               {-134, -56, 0},
               {-134.4F, -59, 0}},
              {3.4F, 3.0F, 2.6F, 2.3F, 2.7F, 1.2F}),
          kSteel));
  append(handle, creasedAndTinted(fingerRing({-136, -71, 0}, 12.0F, 2.4F), kSteel));
  return handle;
}

Mesh movingHandle() {
  Mesh lever = creasedAndTinted(
      bentTube(
          {{-112, 1, 0},
           {-112, -8, 0},
           {-109, -22, 0},
           {-107, -36, 0},
           {-107, -48, 0},
           {-107.6F, -56, 0},
           {-107.9F, -59, 0}},
          {2.4F, 3.2F, 2.9F, 2.6F, 2.3F, 2.7F, 1.2F}),
      kSteel);
  append(lever, creasedAndTinted(fingerRing({-109, -71, 0}, 12.0F, 2.4F), kSteel));
  Mesh pin = rod(-4.6F, 4.6F, 2.4F, 24);
  QMatrix4x4 across;
  across.translate(kLeverPivot);
  across.rotate(90.0F, 0.0F, 1.0F, 0.0F);
  place(pin, across);
  append(lever, creasedAndTinted(std::move(pin), kDarkSteel));
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
      .rod = pushRod(),
      .lever = movingHandle()};
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
