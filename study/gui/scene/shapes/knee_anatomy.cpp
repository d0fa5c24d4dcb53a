#include "study/gui/scene/shapes/knee_anatomy.h"

#include <fmt/format.h>

#include "study/gui/scene/shapes/knee_surfaces.h"
#include "study/gui/scene/shapes/meniscus.h"
#include "study/gui/scene/shapes/punch_shape.h"

namespace study::gui::scene {
namespace {

using protocols::NamedSurface;

QVector3D vectorOf(const NamedSurface::Triple& triple) {
  return {triple[0], triple[1], triple[2]};
}

/// From the file's frame, the punch's mouth, into the knee's.
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

/// Adds an object to an OBJ file, whose corners count on from @p written.
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
