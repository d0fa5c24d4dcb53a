#include "study/gui/scene/shapes/knee_anatomy.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "study/gui/scene/shapes/meniscus.h"
#include "study/gui/scene/shapes/solids.h"
#include "study/gui/scene/shapes/tool_shapes.h"

namespace study::gui::scene {

QVector3D onArc(const KneeLayout& layout, float angle, float radius) {
  constexpr float kDegree = 3.14159265F / 180.0F;
  const float a = kDegree * angle;
  return layout.arcCentre + radius * QVector3D(std::sin(a), 0.0F, -std::cos(a));
}

float plateauHeight(float x, float z) {
  const float dz = z + 4.0F;
  return 0.0022F * (x * x + dz * dz) - 0.4F;
}

QVector3D punchMouth(const KneeLayout& layout) {
  constexpr float kBiteIn = 1.9F;  // from the free edge [mm]
  constexpr float kAbove = 1.25F;  // of the lower jaw above the plateau [mm]
  QVector3D mouth = onArc(layout, layout.toolAngle, layout.innerRadius + kBiteIn);
  mouth.setY(plateauHeight(mouth.x(), mouth.z()) + kAbove);
  return mouth;
}

QMatrix4x4 punchPose(const KneeLayout& layout) {
  constexpr float kReach = 5.6F;  // from the hinge to the bite [mm]
  const QVector3D along = QVector3D(-0.42F, -0.06F, -0.90F).normalized();
  const QVector3D across = QVector3D::crossProduct(along, {0, 1, 0}).normalized();
  const QVector3D up = QVector3D::crossProduct(across, along);
  const QVector3D hinge = punchMouth(layout) - kReach * along;
  return {
      along.x(),
      up.x(),
      across.x(),
      hinge.x(),  //
      along.y(),
      up.y(),
      across.y(),
      hinge.y(),  //
      along.z(),
      up.z(),
      across.z(),
      hinge.z(),  //
      0.0F,
      0.0F,
      0.0F,
      1.0F};
}

namespace {

constexpr Tint kCartilageShade{229, 214, 194, 190};
constexpr Tint kSynoviumPale{205, 128, 112, 140};
constexpr Tint kVessel{128, 34, 36, 120};

/// A sheet over (u, v) in [0, 1]², row by row, with a colour for each point.
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

/// The visibility of blood vessels at @p angle [°] to the side and @p height [mm] above the tissue.
/// A few vessels climb, each with a branch.
float vesselAt(float angle, float height) {
  float most = 0.0F;
  for (int i = -5; i <= 5; ++i) {
    const auto number = static_cast<float>(i);
    const float stem = 13.0F * number + 5.0F * std::sin(2.3F * number) +
                       2.2F * std::sin(0.45F * height + 1.7F * number);
    const float branch =
        stem + 0.9F * std::max(0.0F, height - 4.0F - std::fmod(2.9F * number, 2.0F));
    for (const float course : {stem, branch}) {
      const float aside = (angle - course) / 0.9F;
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
  return surface(
      61,
      22,
      [&](float u, float v) {
        QVector3D place = onArc(layout, angleAt(u), radiusAt(v));
        const float x = place.x();
        const float z = place.z();
        const float ripple = 0.10F * std::sin(0.55F * x + 0.2F * z) * std::sin(0.45F * z);
        place.setY(plateauHeight(x, z) + ripple);
        return place;
      },
      [&](float u, float v) {
        const QVector3D place = onArc(layout, angleAt(u), radiusAt(v));
        const float patch =
            0.5F + 0.5F * std::sin(0.11F * place.x() + 3.0F) * std::sin(0.13F * place.z());
        const Tint ground = blend(kCartilage, kCartilageShade, 0.6F * patch);
        // The ground is darker under the tissue, which blocks the light.
        const float within = std::clamp((v - 0.45F) / 0.25F, 0.0F, 1.0F);
        const float beside = std::abs(angleAt(u));
        const float isThere = std::clamp((layout.halfAngle - beside) / 6.0F, 0.0F, 1.0F);
        return shaded(ground, 1.0F - 0.3F * isThere * within * within);
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
        // Starts beside the lowest point, so that no triangle there is degenerate.
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
  const auto angleAt = [](float u) {
    const float side = 2.0F * u - 1.0F;  // denser where the camera looks
    return std::copysign(150.0F * std::pow(std::abs(side), 1.35F), side);
  };
  const auto riseAt = [](float v) { return std::pow(v, 1.6F); };
  return surface(
      97,
      29,
      [&](float u, float v) {
        const float angle = angleAt(u);
        const float rise = riseAt(v);
        const float fold = 0.55F * std::sin(0.21F * angle + 3.0F * rise) +
                           0.30F * std::sin(0.53F * angle - 9.0F * rise) +
                           0.35F * std::sin(17.0F * rise);
        QVector3D place = onArc(layout, angle, layout.outerRadius + 1.2F + fold + 3.0F * rise);
        place.setY(-3.0F + 36.0F * rise);
        return place;
      },
      [&](float u, float v) {
        const float angle = angleAt(u);
        const float rise = riseAt(v);
        const float pale = 0.5F + 0.5F * std::sin(0.16F * angle + 4.0F * rise) *
                                      std::sin(0.07F * angle - 6.0F * rise + 1.0F);
        const Tint ground = blend(kSynovium, kSynoviumPale, 0.75F * pale);
        return blend(ground, kVessel, 0.6F * vesselAt(angle, 36.0F * rise));
      });
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
