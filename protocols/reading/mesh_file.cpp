#include "protocols/reading/mesh_file.h"

#include <assimp/config.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <algorithm>
#include <assimp/IOSystem.hpp>
#include <assimp/Importer.hpp>
#include <cmath>

#include "questionnaires/json/problem.h"

namespace protocols {
namespace {

// between triangles without normals [°]; larger angles stay sharp edges
constexpr float kStaysAnEdge = 40.0F;

/// Opens no files: a text stored in a study must not refer to files on the disk.
class NoFiles final : public Assimp::IOSystem {
 public:
  bool Exists(const char* /*file*/) const override { return false; }
  char getOsSeparator() const override { return '/'; }
  Assimp::IOStream* Open(const char* /*file*/, const char* /*mode*/) override { return nullptr; }
  void Close(Assimp::IOStream* /*stream*/) override {}
};

NamedSurface::Triple tripleOf(const aiVector3D& v) {
  return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)};
}

std::uint8_t byteOf(float share) {
  const float bounded = share >= 0.0F ? std::min(share, 1.0F) : 0.0F;  // NaN becomes 0
  return static_cast<std::uint8_t>(std::lround(255.0F * bounded));
}

NamedSurface surfaceOf(const aiMesh& mesh, std::string name, bool hasNormals) {
  NamedSurface surface{.name = std::move(name), .hasNormals = hasNormals};
  for (unsigned i = 0; i < mesh.mNumVertices; ++i) {
    surface.places.push_back(tripleOf(mesh.mVertices[i]));
    surface.normals.push_back(
        mesh.HasNormals() ? tripleOf(mesh.mNormals[i]) : NamedSurface::Triple{});
    if (!mesh.HasVertexColors(0)) continue;
    const auto& colour = mesh.mColors[0][i];
    surface.colours.push_back({byteOf(colour.r), byteOf(colour.g), byteOf(colour.b)});
  }
  for (unsigned i = 0; i < mesh.mNumFaces; ++i) {
    const aiFace& face = mesh.mFaces[i];
    if (face.mNumIndices != 3) continue;  // lines and points are not surfaces
    for (unsigned corner = 0; corner < 3; ++corner) {
      if (face.mIndices[corner] < mesh.mNumVertices) continue;
      throw questionnaires::Error(
          "it has a triangle with a corner that is not there, and is damaged");
    }
    surface.triangles.push_back({face.mIndices[0], face.mIndices[1], face.mIndices[2]});
  }
  return surface;
}

/// Collects the meshes in the order of the file; each has the name of its object.
void collect(
    const aiScene& scene,
    const aiNode& node,
    const std::vector<bool>& hasNormals,
    std::vector<NamedSurface>& surfaces) {
  for (unsigned i = 0; i < node.mNumMeshes; ++i) {
    const unsigned mesh = node.mMeshes[i];
    surfaces.push_back(surfaceOf(*scene.mMeshes[mesh], node.mName.C_Str(), hasNormals[mesh]));
  }
  for (unsigned i = 0; i < node.mNumChildren; ++i) {
    collect(scene, *node.mChildren[i], hasNormals, surfaces);
  }
}

/// Whether all vertices are finite. The importer's further steps need that; the caller reports
/// others.
bool isFiniteMesh(const aiMesh& mesh) {
  const aiVector3D* first = mesh.mVertices;
  return std::all_of(first, first + mesh.mNumVertices, [](const auto& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
  });
}

std::vector<NamedSurface> surfacesOf(Assimp::Importer& importer, unsigned more) {
  const aiScene* scene = importer.GetScene();
  if (scene == nullptr || scene->mNumMeshes == 0) {
    throw questionnaires::Error(
        std::string("it holds no mesh that can be read (") + importer.GetErrorString() + ")");
  }
  std::vector<bool> hasNormals;
  bool isSound = true;
  for (unsigned i = 0; i < scene->mNumMeshes; ++i) {
    hasNormals.push_back(scene->mMeshes[i]->HasNormals());
    isSound = isSound && isFiniteMesh(*scene->mMeshes[i]);
  }
  importer.SetPropertyFloat(AI_CONFIG_PP_GSN_MAX_SMOOTHING_ANGLE, kStaysAnEdge);
  if (isSound) scene = importer.ApplyPostProcessing(more | aiProcess_JoinIdenticalVertices);
  if (scene == nullptr || scene->mNumMeshes < hasNormals.size()) {
    throw questionnaires::Error(std::string("it is damaged (") + importer.GetErrorString() + ")");
  }
  hasNormals.resize(scene->mNumMeshes, true);
  std::vector<NamedSurface> surfaces;
  collect(*scene, *scene->mRootNode, hasNormals, surfaces);
  return surfaces;
}

}  // namespace

std::vector<NamedSurface> readMeshFile(const std::string& path) {
  Assimp::Importer importer;
  importer.ReadFile(path, aiProcess_ValidateDataStructure | aiProcess_PreTransformVertices);
  return surfacesOf(importer, aiProcess_Triangulate);
}

std::vector<NamedSurface> readObj(std::string_view text) {
  Assimp::Importer importer;
  importer.SetIOHandler(new NoFiles);  // the importer owns it from here on
  importer.ReadFileFromMemory(text.data(), text.size(), aiProcess_ValidateDataStructure, "obj");
  return surfacesOf(importer, aiProcess_Triangulate | aiProcess_GenSmoothNormals);
}

}  // namespace protocols
