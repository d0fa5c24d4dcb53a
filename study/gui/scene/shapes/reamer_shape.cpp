#include "study/gui/scene/shapes/reamer_shape.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "study/gui/scene/shapes/solids.h"

namespace study::gui::scene {
namespace {

constexpr float kPi = std::numbers::pi_v<float>;
constexpr Tint kCapSteel{192, 196, 202, 240};
constexpr Tint kToothSteel{214, 218, 223, 245};
constexpr Tint kHole{34, 34, 38, 20};
constexpr Tint kShaftSteel{182, 186, 192, 242};
constexpr Tint kOutline{232, 236, 240, 120};
constexpr float kSlotHalf = 0.62F;  // width of a slot by its length

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

/// The lip of a tooth, which rises to a cutting edge over the back of its slot: a crescent.
Mesh lip(float size) {
  constexpr int kSteps = 6;
  std::vector<Ring> rings;
  for (int i = 0; i <= kSteps; ++i) {
    const float at = 2.0F * static_cast<float>(i) / kSteps - 1.0F;
    const float angle = kPi + 1.45F * at;
    const QVector3D out(kSlotHalf * std::cos(angle), std::sin(angle), 0.0F);
    const float rise = 0.46F * (1.0F - at * at);
    const auto point = [&](float away, float height) {
      return size * (away * out + QVector3D(0.0F, 0.0F, height));
    };
    rings.push_back({point(1.45F, -0.15F), point(0.97F, -0.15F), point(0.9F, rise)});
  }
  Mesh mesh = loft(rings);
  paint(mesh, kToothSteel);
  crease(mesh, 50.0F);
  return mesh;
}

/// The slot in front of a lip, for chips.
Mesh slot(float size) {
  const QVector3D x(kSlotHalf, 0, 0);
  const QVector3D y(0, 1, 0);
  constexpr int kCorners = 10;
  Mesh disc = loft(
      {circle({0, 0, -0.3F}, x, y, size, kCorners), circle({0, 0, 0.06F}, x, y, size, kCorners)});
  paint(disc, kHole);
  crease(disc, 30.0F);
  return disc;
}

/// Adds teeth in spirals from the top to the rim.
void addTeeth(Mesh& cap, float radius) {
  constexpr int kSpirals = 12;
  constexpr int kPerSpiral = 10;
  constexpr float kTwist = 2.2F;  // from the top to the rim [radian]
  const float size = 0.05F * radius;
  for (int spiral = 0; spiral < kSpirals; ++spiral) {
    for (int i = 0; i < kPerSpiral; ++i) {
      if (i == 0 && spiral % 4 != 0) continue;  // the top has no room for all
      if (i == 1 && spiral % 2 != 0) continue;
      const float share = (static_cast<float>(i) + 0.85F) / kPerSpiral;
      const float azimuth = 2.0F * kPi * static_cast<float>(spiral) / kSpirals + kTwist * share;
      const QMatrix4x4 pose = onTheCap(radius, 0.475F * kPi * share, azimuth);
      for (Mesh part : {lip(size), slot(size)}) {
        place(part, pose);
        append(cap, part);
      }
    }
  }
}

/// The hollow dome: outside from its top to the rim, and inside back to its axis.
Mesh dome(float radius) {
  constexpr int kSteps = 26;
  constexpr float kInnerRadius = 0.93F;  // its radius, by that of the outside
  constexpr float kFloor = 0.62F;        // the height to which it is hollow, by the same
  std::vector<QVector2D> profile;
  for (int i = 0; i <= kSteps; ++i) {
    const float polar = 0.5F * kPi * static_cast<float>(i) / kSteps;
    profile.emplace_back(std::max(radius * std::sin(polar), 0.01F), radius * std::cos(polar));
  }
  profile.emplace_back(radius, -0.05F * radius);
  profile.emplace_back(0.985F * radius, -0.065F * radius);
  profile.emplace_back(0.945F * radius, -0.065F * radius);
  profile.emplace_back(kInnerRadius * radius, -0.05F * radius);
  for (int i = 0; i <= 6; ++i) {
    // The wall is thicker inside: uncut bone reaches a little into it.
    const float share = static_cast<float>(i) / 6.0F;
    const float height = kFloor * share;
    const float inside = kInnerRadius - 0.11F * share;
    profile.emplace_back(radius * std::sqrt(inside * inside - height * height), radius * height);
  }
  profile.emplace_back(0.4F * radius, kFloor * radius);
  profile.emplace_back(0.0004F, kFloor * radius);
  Mesh mesh = turned(profile, 64);
  crease(mesh, 32.0F);
  for (auto& vertex : mesh.vertices) {
    const bool isInside = vertex.position.length() < 0.95F * radius;
    const float depth = std::clamp(vertex.position.z() / (kFloor * radius), 0.0F, 1.0F);
    vertex.tint = isInside ? shaded(kCapSteel, 0.8F - 0.35F * depth) : kCapSteel;
  }
  return mesh;
}

/// The cross that carries the dome on its shaft.
Mesh cross(float radius) {
  Mesh mesh;
  const float half = 0.11F * radius;
  for (const float turn : {45.0F, 135.0F}) {
    Mesh bar = loft(
        {slab(-0.94F * radius, -0.05F * radius, 0.09F * radius, half, 0.5F),
         slab(0.94F * radius, -0.05F * radius, 0.09F * radius, half, 0.5F)});
    QMatrix4x4 flat;  // its height along z
    flat.rotate(turn, 0.0F, 0.0F, 1.0F);
    flat.rotate(90.0F, 1.0F, 0.0F, 0.0F);
    place(bar, flat);
    append(mesh, bar);
  }
  paint(mesh, kShaftSteel);
  crease(mesh, 30.0F);
  return mesh;
}

}  // namespace

ReamerShape reamerShape(float radius) {
  ReamerShape shape{.cap = dome(radius), .shaft = {}};
  append(shape.cap, cross(radius));
  addTeeth(shape.cap, radius);
  // A sleeve with grooves, and the rod.
  shape.shaft = turned(
      {{0.01F, 2.6F},
       {7.6F, 2.6F},
       {8.4F, 1.6F},
       {8.4F, -4.0F},
       {7.7F, -4.6F},
       {7.7F, -5.6F},
       {8.4F, -6.2F},
       {8.4F, -11.0F},
       {7.2F, -13.5F},
       {5.4F, -15.5F},
       {5.4F, -40.0F},
       {5.4F, -75.0F},
       {5.4F, -110.0F},
       {5.4F, -150.0F},
       {0.01F, -150.0F}},
      40);
  paint(shape.shaft, kShaftSteel);
  crease(shape.shaft, 30.0F);
  return shape;
}

Mesh reamerOutline(float radius) {
  constexpr float kWire = 0.42F;  // [mm]
  constexpr float kShaft = 5.4F;
  constexpr float kEnd = -150.0F;
  Mesh outline = fingerRing({}, radius, kWire);
  std::vector<QVector3D> arc;
  for (int i = 0; i <= 16; ++i) {
    const float angle = kPi * static_cast<float>(i) / 16.0F;
    arc.emplace_back(radius * std::cos(angle), radius * std::sin(angle), 0.0F);
  }
  const Mesh meridian = bentTube(arc, std::vector<float>(arc.size(), kWire));
  for (const float azimuth : {0.0F, 60.0F, 120.0F}) {
    Mesh upright = meridian;
    QMatrix4x4 pose;  // its top from y to z
    pose.rotate(azimuth, 0.0F, 0.0F, 1.0F);
    pose.rotate(90.0F, 1.0F, 0.0F, 0.0F);
    place(upright, pose);
    append(outline, upright);
  }
  for (const float azimuth : {30.0F, 150.0F, 270.0F}) {
    Mesh edge = rod(kEnd, 0.0F, kWire, 10);
    QMatrix4x4 pose;  // along z, at the surface of the shaft
    pose.rotate(azimuth, 0.0F, 0.0F, 1.0F);
    pose.translate(kShaft, 0.0F, 0.0F);
    pose.rotate(-90.0F, 0.0F, 1.0F, 0.0F);
    place(edge, pose);
    append(outline, edge);
  }
  paint(outline, kOutline);
  smoothen(outline);
  return outline;
}

}  // namespace study::gui::scene
