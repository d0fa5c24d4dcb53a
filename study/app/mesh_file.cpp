#include "study/app/mesh_file.h"

#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <assimp/Importer.hpp>
#include <filesystem>

#include "study/session.h"

namespace study::app {
namespace {

namespace reaming = haptics::reaming;

/// All triangles of all parts of the file.
reaming::TriangleMesh trianglesOf(const aiScene& scene) {
  reaming::TriangleMesh mesh;
  for (unsigned part = 0; part < scene.mNumMeshes; ++part) {
    const aiMesh& from = *scene.mMeshes[part];
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    for (unsigned i = 0; i < from.mNumVertices; ++i) {
      const auto& v = from.mVertices[i];
      mesh.vertices.push_back({v.x, v.y, v.z});
    }
    for (unsigned i = 0; i < from.mNumFaces; ++i) {
      const aiFace& face = from.mFaces[i];
      if (face.mNumIndices != 3) continue;
      for (unsigned corner = 0; corner < 3; ++corner) {
        if (face.mIndices[corner] < from.mNumVertices) continue;
        throw NotNow("The mesh has a triangle with a corner that is not there: it is damaged.");
      }
      mesh.triangles.push_back(
          {first + face.mIndices[0], first + face.mIndices[1], first + face.mIndices[2]});
    }
  }
  return mesh;
}

/// How many metres one unit of the mesh is.
double unitOf(const reaming::TriangleMesh& mesh, const std::string& unit, BodyMesh& body) {
  if (unit == "m") return 1.0;
  if (unit == "mm") return 0.001;
  const double likely = reaming::likelyUnit(mesh);
  if (likely == 0.0) {
    throw NotNow(
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
    throw NotNow("There is no file " + path + ". Check the spelling and the folder.");
  }
  Assimp::Importer importer;
  const aiScene* scene = importer.ReadFile(
      path,
      aiProcess_ValidateDataStructure | aiProcess_Triangulate | aiProcess_PreTransformVertices |
          aiProcess_JoinIdenticalVertices);
  if (scene == nullptr || scene->mNumMeshes == 0) {
    throw NotNow(
        path + " holds no mesh that can be read (" + importer.GetErrorString() +
        "). Save it as STL, OBJ or PLY.");
  }
  BodyMesh body{.mesh = trianglesOf(*scene), .said = {}};
  for (const auto& repair : reaming::repair(body.mesh)) body.said.push_back(repair);
  const double unitLength = unitOf(body.mesh, unit, body);
  for (auto& vertex : body.mesh.vertices) vertex = unitLength * vertex;
  std::string wrong;
  for (const auto& problem : reaming::problemsOf(body.mesh)) wrong += "\n  " + problem + ".";
  if (!wrong.empty()) throw NotNow(path + " cannot be filled:" + wrong);
  return body;
}

}  // namespace study::app
