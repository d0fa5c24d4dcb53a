#include "study/app/measurements/body_mesh.h"

#include <filesystem>

#include "protocols/reading/mesh_file.h"
#include "questionnaires/json/problem.h"
#include "study/model/user_error.h"

namespace study::app {
namespace {

namespace reaming = haptics::reaming;

/// All triangles of all surfaces.
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

/// @throws UserError  with the reader's message.
std::vector<protocols::NamedSurface> surfacesIn(const std::string& path) {
  try {
    return protocols::readMeshFile(path);
  } catch (const UserError& error) {
    throw UserError(path + " cannot be filled: " + error.what() + ". Save it as STL, OBJ or PLY.");
  }
}

/// Metres per unit of the mesh.
double unitOf(const reaming::TriangleMesh& mesh, const std::string& unit, BodyMesh& body) {
  if (unit == "m") return 1.0;
  if (unit == "mm") return 0.001;
  const double likely = reaming::likelyUnit(mesh);
  if (likely == 0.0) {
    throw UserError(
        "The mesh is of no bone's size, neither in metres nor in millimetres. Say which with "
        "--unit m or --unit mm.");
  }
  body.said.emplace_back(
      likely == 1.0 ? "by its size its numbers are metres"
                    : "by its size its numbers are millimetres");
  return likely;
}

}  // namespace

BodyMesh readBody(const std::string& path, const std::string& unit) {
  if (!std::filesystem::is_regular_file(path)) {
    throw UserError("There is no file " + path + ". Check the spelling and the folder.");
  }
  BodyMesh body{.mesh = trianglesOf(surfacesIn(path)), .said = {}};
  for (const auto& repair : reaming::repair(body.mesh)) body.said.push_back(repair);
  const double unitLength = unitOf(body.mesh, unit, body);
  for (auto& vertex : body.mesh.vertices) vertex = unitLength * vertex;
  std::string wrong;
  for (const auto& problem : reaming::problemsOf(body.mesh)) wrong += "\n  " + problem + ".";
  if (!wrong.empty()) throw UserError(path + " cannot be filled:" + wrong);
  return body;
}

}  // namespace study::app
