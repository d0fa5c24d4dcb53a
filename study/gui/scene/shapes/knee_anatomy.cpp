#include "study/gui/scene/shapes/knee_anatomy.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include <QVector2D>

#include "study/gui/scene/shapes/meniscus.h"
#include "study/gui/scene/shapes/noise.h"
#include "study/gui/scene/shapes/solids.h"
#include "study/gui/scene/shapes/tool_shapes.h"

namespace study::gui::scene {

QVector3D pointOnArc(const KneeLayout& layout, float angle, float radius) {
  constexpr float kDegree = 3.14159265F / 180.0F;
  const float a = kDegree * angle;
  return layout.arcCentre + radius * QVector3D(std::sin(a), 0.0F, -std::cos(a));
}

float plateauHeight(float x, float z) {
  const float dz = z + 4.0F;
  return 0.0012F * (x * x + dz * dz) - 0.4F;
}

QVector3D punchMouth(const KneeLayout& layout) {
  constexpr float kBiteIn = 1.9F;        // from the free edge [mm]
  constexpr float kHeightAbove = 1.25F;  // of the lower jaw above the plateau [mm]
  QVector3D mouth = pointOnArc(layout, layout.toolAngle, layout.innerRadius + kBiteIn);
  mouth.setY(plateauHeight(mouth.x(), mouth.z()) + kHeightAbove);
  return mouth;
}

QMatrix4x4 punchPose(const KneeLayout& layout) {
  constexpr float kReach = 5.6F;  // from the hinge to the bite [mm]
  const QVector3D along = QVector3D(-0.42F, -0.06F, -0.90F).normalized();
  const QVector3D across = QVector3D::crossProduct(along, {0, 1, 0}).normalized();
  const QVector3D up = QVector3D::crossProduct(across, along);
  const QVector3D hinge = punchMouth(layout) - kReach * along;
  QMatrix4x4 pose;
  pose.setColumn(0, {along, 0.0F});
  pose.setColumn(1, {up, 0.0F});
  pose.setColumn(2, {across, 0.0F});
  pose.setColumn(3, {hinge, 1.0F});
  return pose;
}

namespace {

constexpr Tint kCartilageShade{206, 196, 180, 190};
constexpr Tint kSynoviumPale{226, 164, 146, 165};
constexpr Tint kVessel{150, 52, 50, 150};

/// Orients the triangles of @p mesh so that most of its area shows its front to @p place.
void faceTo(Mesh& mesh, QVector3D place) {
  float facing = 0.0F;
  for (const auto& vertex : mesh.vertices)
    facing += QVector3D::dotProduct(vertex.normal, (place - vertex.position).normalized());
  if (facing >= 0.0F) return;
  for (auto& vertex : mesh.vertices) vertex.normal = -vertex.normal;
  for (auto& t : mesh.triangles) std::swap(t.b, t.c);
}

/// Turns the normals by @p strength, as bumps of @p width [mm] would: a wet surface glints in
/// spots.
void roughen(Mesh& mesh, float width, float strength) {
  for (auto& vertex : mesh.vertices) {
    const QVector3D at = vertex.position / width;
    const QVector3D turn(
        roughnessAt(at, 2),
        roughnessAt(at + QVector3D(31, 0, 0), 2),
        roughnessAt(at + QVector3D(0, 57, 0), 2));
    vertex.normal = (vertex.normal + 2.0F * strength * turn).normalized();
  }
}

/// Cartilage at @p place: bluish white, with faint patches.
Tint cartilageAt(QVector3D place) {
  const float patch = 0.5F + roughnessAt(0.16F * place, 3);
  return blend(kCartilage, kCartilageShade, std::clamp(patch, 0.0F, 1.0F));
}

/// The visibility of blood vessels at @p angle [°] to the side and @p height [mm] above the tissue.
/// A few thin vessels wind upwards.
float vesselAt(float angle, float height) {
  constexpr float kAngleBetween = 23.0F;  // [°]
  float most = 0.0F;
  for (int i = -3; i <= 3; ++i) {
    const auto number = static_cast<float>(i);
    const float wind = 5.0F * noiseAt({0.35F * height, number, 0.0F}) +
                       1.6F * noiseAt({1.1F * height, number, 9.0F});
    const float stem = kAngleBetween * number + 7.0F * noiseAt({number, 3.0F, 0.5F}) + wind;
    const float branch = stem + 1.4F * std::max(0.0F, height - 5.0F);
    for (const float course : {stem, branch}) {
      const float aside = (angle - course) / 0.8F;
      most = std::max(most, 1.0F / (1.0F + aside * aside * aside * aside));
    }
  }
  return most;
}

}  // namespace

Mesh plateauSurface(const KneeLayout& layout) {
  const auto angleAt = [](float u) { return 360.0F * u - 180.0F; };
  // Rings around the crescent's centre, closest together at its free edge.
  const auto radiusAt = [edge = layout.innerRadius](float v) {
    constexpr float kEdge = 0.7F;
    if (v >= kEdge) return edge + 27.0F * std::pow((v - kEdge) / (1.0F - kEdge), 1.4F);
    return std::max(edge * (1.0F - std::pow(1.0F - v / kEdge, 1.7F)), 0.0005F);
  };
  Mesh mesh = surface(
      109,
      40,
      [&](float u, float v) {
        QVector3D place = pointOnArc(layout, angleAt(u), radiusAt(v));
        place.setY(
            plateauHeight(place.x(), place.z()) +
            0.12F * noiseAt({0.2F * place.x(), 0.0F, 0.2F * place.z()}));
        return place;
      },
      [&](float u, float v, QVector3D place) {
        // The ground is darker beside and under the tissue, which blocks the light.
        const float within =
            std::clamp((radiusAt(v) - layout.innerRadius + 1.6F) / 2.2F, 0.0F, 1.0F);
        const float beside = std::abs(angleAt(u));
        const float isThere = std::clamp((layout.halfAngle - beside) / 6.0F, 0.0F, 1.0F);
        return shaded(cartilageAt(place), 1.0F - 0.38F * isThere * within * within);
      });
  faceTo(mesh, {0.0F, 40.0F, 0.0F});
  roughen(mesh, 2.2F, 0.07F);
  return mesh;
}

Mesh condyleSurface() {
  const QVector3D centre(-3.0F, 31.0F, -8.0F);
  const QVector3D radii(25.0F, 23.5F, 23.0F);
  Mesh mesh = surface(
      96,
      44,
      [&](float u, float v) {
        constexpr float kTurn = 6.2831853F;
        const float around = kTurn * u;
        // Starts beside the lowest point, so that no triangle there is degenerate.
        const float up = 0.26F * kTurn * std::max(v, 0.0005F);
        const QVector3D out =
            QVector3D(
                std::sin(up) * std::cos(around), -std::cos(up), -std::sin(up) * std::sin(around)) *
            QVector3D(-1.0F, 1.0F, 1.0F);
        return centre + (1.0F + 0.006F * noiseAt(4.0F * out)) * radii * out;
      },
      [](float /*u*/, float /*v*/, QVector3D place) { return cartilageAt(place); });
  faceTo(mesh, {0.0F, -40.0F, 0.0F});
  roughen(mesh, 2.4F, 0.09F);
  return mesh;
}

Mesh capsuleSurface(const KneeLayout& layout) {
  const auto angleAt = [](float u) {
    const float side = 2.0F * u - 1.0F;  // denser where the camera looks
    return std::copysign(150.0F * std::pow(std::abs(side), 1.35F), side);
  };
  const auto riseAt = [](float v) { return std::pow(v, 1.6F); };
  Mesh mesh = surface(
      129,
      40,
      [&](float u, float v) {
        const float angle = angleAt(u);
        const float rise = riseAt(v);
        const float fold = 1.5F * noiseAt({0.06F * angle, 7.0F * rise, 0.0F}) +
                           0.5F * roughnessAt({0.16F * angle, 18.0F * rise, 5.0F}, 2);
        QVector3D place = pointOnArc(layout, angle, layout.outerRadius + 0.9F + fold + 3.0F * rise);
        place.setY(-3.0F + 36.0F * rise);
        return place;
      },
      [&](float u, float v, QVector3D place) {
        const float pale = std::clamp(0.5F + roughnessAt(0.28F * place, 3), 0.0F, 1.0F);
        const float vessel = vesselAt(angleAt(u), 36.0F * riseAt(v));
        return blend(blend(kSynovium, kSynoviumPale, pale), kVessel, 0.5F * vessel);
      });
  faceTo(mesh, layout.arcCentre);
  roughen(mesh, 1.3F, 0.16F);
  return mesh;
}

namespace {

using protocols::NamedSurface;

QVector3D vectorOf(const NamedSurface::Triple& triple) {
  return {triple[0], triple[1], triple[2]};
}

/// Converts from the file's frame, which has its origin at the punch's mouth, to the knee's.
Mesh asMesh(const NamedSurface& surface, QVector3D mouth, Tint tint) {
  Mesh mesh;
  mesh.vertices.reserve(surface.places.size());
  for (std::size_t i = 0; i < surface.places.size(); ++i) {
    Tint own = tint;
    if (!surface.colours.empty()) {
      const auto& [red, green, blue] = surface.colours[i];
      own = {red, green, blue, tint.gloss};
    }
    mesh.vertices.push_back(
        {mouth + vectorOf(surface.places[i]), vectorOf(surface.normals[i]).normalized(), own});
  }
  for (const auto& [a, b, c] : surface.triangles) mesh.triangles.push_back({a, b, c});
  return mesh;
}

/// Appends an object to an OBJ file that has @p written vertices so far.
void addObject(
    std::string& text, const char* name, const Mesh& mesh, QVector3D mouth, std::size_t& written) {
  text += fmt::format("o {}\n", name);
  for (const auto& vertex : mesh.vertices) {
    const QVector3D place = vertex.position - mouth;
    text += fmt::format(
        "v {:.4f} {:.4f} {:.4f} {:.4f} {:.4f} {:.4f}\n",
        place.x(),
        place.y(),
        place.z(),
        vertex.tint.red / 255.0,
        vertex.tint.green / 255.0,
        vertex.tint.blue / 255.0);
  }
  for (const auto& vertex : mesh.vertices) {
    const QVector3D& normal = vertex.normal;
    text += fmt::format("vn {:.4f} {:.4f} {:.4f}\n", normal.x(), normal.y(), normal.z());
  }
  for (const auto& t : mesh.triangles) {
    const auto a = written + t.a + 1;
    const auto b = written + t.b + 1;
    const auto c = written + t.c + 1;
    text += fmt::format("f {0}//{0} {1}//{1} {2}//{2}\n", a, b, c);
  }
  written += mesh.vertices.size();
}

}  // namespace

KneeSurfaces kneeSurfaces(const KneeLayout& layout, const protocols::Anatomy* own) {
  const QVector3D mouth = punchMouth(layout);
  const auto choose = [&](std::string_view name, Tint tint, auto ours) {
    const auto* surface = own != nullptr ? own->find(name) : nullptr;
    return surface != nullptr ? asMesh(*surface, mouth, tint) : ours();
  };
  return {
      .tibia = choose(protocols::kTibia, kCartilage, [&] { return plateauSurface(layout); }),
      .femur = choose(protocols::kFemur, kCartilage, [] { return condyleSurface(); }),
      .capsule = choose(protocols::kCapsule, kSynovium, [&] { return capsuleSurface(layout); })};
}

std::string kneeAsObj(const KneeLayout& layout) {
  const QVector3D mouth = punchMouth(layout);
  const KneeSurfaces ours = kneeSurfaces(layout, nullptr);
  PunchShape shape = punchShape();
  place(shape.jaw, jawPose(1.0F));
  append(shape.body, shape.jaw);
  place(shape.body, punchPose(layout));
  std::string text =
      "# Palpate's own knee, in millimetres. The origin lies on the lower jaw where the punch\n"
      "# bites; x runs to the right as the arthroscope shows it, y up from the shin to the thigh,\n"
      "# z towards the surgeon. tibia, femur and capsule may be replaced, each by an object of "
      "its\n"
      "# name; meniscus and punch are here for orientation and are left out when this is read.\n";
  std::size_t written = 0;
  addObject(text, "tibia", ours.tibia, mouth, written);
  addObject(text, "femur", ours.femur, mouth, written);
  addObject(text, "capsule", ours.capsule, mouth, written);
  addObject(text, "meniscus", Meniscus(layout).body(), mouth, written);
  addObject(text, "punch", shape.body, mouth, written);
  return text;
}

}  // namespace study::gui::scene
