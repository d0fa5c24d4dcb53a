#include "study/app/measurements/packing_inputs.h"

#include <filesystem>

#include <CLI/CLI.hpp>

#include "haptics/engine/built_in_models.h"
#include "protocols/reading/material_file.h"
#include "protocols/reading/mesh_file.h"
#include "questionnaires/json/document.h"
#include "study/model/user_error.h"

namespace study::app {

namespace reaming = haptics::reaming;
namespace {

/// The triangles of all surfaces in one mesh.
reaming::TriangleMesh trianglesOf(const std::vector<protocols::NamedSurface>& surfaces) {
  reaming::TriangleMesh mesh;
  for (const auto& surface : surfaces) {
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    for (const auto& v : surface.places) mesh.vertices.push_back({v[0], v[1], v[2]});
    for (const auto& [a, b, c] : surface.triangles) {
      mesh.triangles.push_back({first + a, first + b, first + c});
    }
  }
  return mesh;
}

/// @throws UserError  with the message of the file's reader.
std::vector<protocols::NamedSurface> surfacesIn(const std::string& path) {
  try {
    return protocols::readMeshFile(path);
  } catch (const UserError& error) {
    throw UserError(path + " cannot be filled: " + error.what() + ". Save it as STL, OBJ or PLY.");
  }
}

/// Metres per unit of the mesh. If the unit is derived from the size, a sentence is added to
/// @p body.
double metresPerUnit(const reaming::TriangleMesh& mesh, const std::string& unit, BodyMesh& body) {
  if (unit == "m") return 1.0;
  if (unit == "mm") return 0.001;
  const double likely = reaming::likelyUnit(mesh);
  if (likely == 0.0) {
    throw UserError(
        "The mesh is of no bone's size, neither in metres nor in millimetres. Say which with "
        "--unit m or --unit mm.");
  }
  body.remarks.emplace_back(
      likely == 1.0 ? "by its size its numbers are metres"
                    : "by its size its numbers are millimetres");
  return likely;
}

}  // namespace

void addMaterialOptions(CLI::App& verb, MaterialChoice& choice) {
  verb.add_option("--material", choice.file, "Material file, or parametric (the built-in material)")
      ->type_name("FILE")
      ->required();
  verb.add_option(
          "--test-set",
          choice.set,
          "Test set of the material file whose curves are used (not with parametric)")
      ->check(CLI::IsMember({"static", "dynamic-1", "dynamic-2"}))
      ->capture_default_str();
}

reaming::PackedBone readBone(const std::string& path, protocols::PackingOrigin& origin) {
  if (!path.ends_with(protocols::kPackingExtension)) {
    throw UserError(
        "'" + path +
        "' does not end in '.packing': spheres are wanted here, as 'palpate packing build' writes "
        "them. A material goes after --material.");
  }
  questionnaires::Problems problems;
  auto bone = protocols::readPacking(
      questionnaires::readTextFile(path, protocols::kMaxPackingBytes), problems, &origin);
  if (!bone) throw UserError(path + ":\n" + questionnaires::describe(problems.all()));
  return std::move(*bone);
}

ChosenCurves curvesOf(const MaterialChoice& choice, protocols::PackingOrigin& origin) {
  if (choice.file == "parametric") {
    origin.material = "parametric";
    return {haptics::engine::parametricCurves(), haptics::engine::parametricTorque(), true};
  }
  if (choice.file.ends_with(protocols::kPackingExtension)) {
    throw UserError(
        "'" + choice.file +
        "' holds spheres; --material wants a material, as 'palpate material fit' writes it "
        "(MATERIAL.json).");
  }
  questionnaires::Problems problems;
  const auto material =
      protocols::readMaterial(questionnaires::readTextFile(choice.file), problems);
  if (!material) {
    throw UserError(choice.file + ":\n" + questionnaires::describe(problems.all()));
  }
  for (const auto& set : material->sets) {
    if (nameOf(set.set) != choice.set) continue;
    origin.material = material->name + ", " + choice.set;
    return {set.force, set.torque, material->isSynthetic};
  }
  throw UserError("'" + choice.file + "' has no test set '" + choice.set + "'.");
}

BodyMesh readBody(const std::string& path, const std::string& unit) {
  if (!std::filesystem::is_regular_file(path)) {
    throw UserError("There is no file " + path + ". Check the spelling and the folder.");
  }
  BodyMesh body{.mesh = trianglesOf(surfacesIn(path)), .remarks = {}};
  for (const auto& repair : reaming::repair(body.mesh)) body.remarks.push_back(repair);
  const double unitLength = metresPerUnit(body.mesh, unit, body);
  for (auto& vertex : body.mesh.vertices) vertex = unitLength * vertex;
  std::string wrong;
  for (const auto& problem : reaming::problemsOf(body.mesh)) wrong += "\n  " + problem + ".";
  if (!wrong.empty()) throw UserError(path + " cannot be filled:" + wrong);
  return body;
}

}  // namespace study::app
