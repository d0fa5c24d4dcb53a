#include "protocols/reading/mesh_file.h"

#include <assimp/BaseImporter.h>
#include <assimp/config.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <algorithm>
#include <assimp/IOSystem.hpp>
#include <assimp/Importer.hpp>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <memory>
#include <set>
#include <sstream>

#include "base/file.h"
#include "questionnaires/json/problem.h"

namespace protocols {
namespace {

// [°]; between triangles without normals, larger angles stay sharp edges
constexpr float kSharpEdgeAngle = 40.0F;

constexpr std::uintmax_t kLargestMesh = 512 * 1024 * 1024;  // [bytes]
constexpr double kMostSteps = 1e8;  // steps to cut faces into triangles; they take about 2 s

/// A file system without files: a text that a study stores must not refer to files on the disk.
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
      throw base::UserError("it has a triangle with a corner that is not there, and is damaged");
    }
    surface.triangles.push_back({face.mIndices[0], face.mIndices[1], face.mIndices[2]});
  }
  return surface;
}

/// Collects the meshes in the order of the file, each with the name of its object.
void collectSurfaces(
    const aiScene& scene,
    const aiNode& node,
    const std::vector<bool>& hasNormals,
    std::vector<NamedSurface>& surfaces) {
  for (unsigned i = 0; i < node.mNumMeshes; ++i) {
    const unsigned mesh = node.mMeshes[i];
    surfaces.push_back(surfaceOf(*scene.mMeshes[mesh], node.mName.C_Str(), hasNormals[mesh]));
  }
  for (unsigned i = 0; i < node.mNumChildren; ++i) {
    collectSurfaces(scene, *node.mChildren[i], hasNormals, surfaces);
  }
}

/// Whether all vertices are finite, which later steps of the importer require.
bool isFiniteMesh(const aiMesh& mesh) {
  const aiVector3D* first = mesh.mVertices;
  return std::all_of(first, first + mesh.mNumVertices, [](const auto& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
  });
}

/// The format of the text, judged by its beginning: "stl", "obj" or "ply".
/// @throws UserError  if the format is another.
std::string formatOf(std::string_view text) {
  if (text.starts_with("ply\n") || text.starts_with("ply\r")) return "ply";
  // A binary STL file has a header of 80 bytes, the number of triangles, and 50 bytes per triangle.
  constexpr std::size_t kStlHeaderBytes = 80;
  constexpr std::size_t kTriangle = 50;
  if (text.size() >= kStlHeaderBytes + sizeof(std::uint32_t)) {
    std::uint32_t triangles = 0;
    std::memcpy(&triangles, text.data() + kStlHeaderBytes, sizeof triangles);
    if (text.size() == kStlHeaderBytes + sizeof triangles + kTriangle * std::size_t{triangles})
      return "stl";
  }
  const auto start = text.substr(0, std::min<std::size_t>(text.size(), 64 * 1024));
  if (start.starts_with("solid") && start.find("facet") != std::string_view::npos) return "stl";
  const bool isText = start.find('\0') == std::string_view::npos;
  const bool hasVertex = start.starts_with("v ") || start.find("\nv ") != std::string_view::npos;
  if (isText && hasVertex) return "obj";
  throw base::UserError("it is no STL, OBJ or PLY file");
}

/// A number of elements in the header of a PLY file. @throws base::UserError if it is not a number.
double countIn(const std::string& word) {
  constexpr std::size_t kMostDigits = 15;
  const bool isCount = !word.empty() && word.size() <= kMostDigits &&
                       word.find_first_not_of("0123456789") == std::string::npos;
  if (isCount) return std::stod(word);
  throw base::UserError("its head says '" + word + "' where a number of elements should be");
}

/// Checks the header of a PLY file, because the library does not: it allocates memory for as many
/// vertices and faces as the header announces, and never returns if the header has no end.
/// Ambiguous headers are refused.
void requirePlausibleHeader(std::string_view text) {
  static const std::set<std::string> kStatements{
      "ply", "format", "comment", "obj_info", "element", "property"};
  static const std::set<std::string> kShortCounts{
      "char", "uchar", "int8", "uint8", "short", "ushort", "int16", "uint16"};
  double entries = 0.0;
  for (;;) {
    if (text.empty()) throw base::UserError("its head does not end");
    const auto size = std::min(text.find_first_of("\r\n"), text.size());
    const std::string line(text.substr(0, size));
    text.remove_prefix(std::min(size + 1, text.size()));
    std::istringstream words(line);
    std::string statement;
    if (!(words >> statement)) continue;  // an empty line between \r and \n
    if (statement == "end_header") break;
    const bool isText = std::ranges::all_of(
        line, [](unsigned char c) { return c == '\t' || (c >= ' ' && c != 0x7F); });
    if (!isText || kStatements.count(statement) == 0) {
      throw base::UserError("its head is damaged");
    }
    std::string name;
    std::string count;
    words >> name >> count;
    if (statement == "element") entries += countIn(count);
    if (statement != "property" || name != "list" || kShortCounts.count(count) > 0) continue;
    throw base::UserError(
        "its faces may have thousands of millions of corners ('list " + count +
        "'): save it with 'list uchar'");
  }
  // The rest of the text is data: each element takes at least one byte.
  if (entries <= static_cast<double>(text.size())) return;
  throw base::UserError("it says that it has more corners and faces than fit into it");
}

/// Unregisters all readers except that of @p format; otherwise the library selects one of its many
/// readers by the content.
void keepOnlyReaderOf(Assimp::Importer& importer, const std::string& format) {
  for (std::size_t i = importer.GetImporterCount(); i-- > 0;) {
    auto* reader = importer.GetImporter(i);
    std::set<std::string> endings;
    reader->GetExtensionList(endings);
    if (endings.count(format) != 0) continue;
    importer.UnregisterLoader(reader);
    const std::unique_ptr<Assimp::BaseImporter> freed(reader);  // unregistering makes the caller
                                                                // the owner
  }
}

/// Refuses faces with so many corners that cutting them into triangles takes long (up to n² steps
/// for n corners), and faces without corners, for which the library aborts the program.
void requireFewCorners(const aiScene& scene) {
  double steps = 0.0;
  unsigned most = 0;
  for (unsigned m = 0; m < scene.mNumMeshes; ++m) {
    for (unsigned i = 0; i < scene.mMeshes[m]->mNumFaces; ++i) {
      const unsigned corners = scene.mMeshes[m]->mFaces[i].mNumIndices;
      if (corners == 0) {
        throw base::UserError("it has a face without corners, and is damaged");
      }
      if (corners > 4) steps += static_cast<double>(corners) * corners;
      most = std::max(most, corners);
    }
  }
  if (steps <= kMostSteps) return;
  throw base::UserError(
      "its faces have too many corners to be cut into triangles (one has " + std::to_string(most) +
      "): save it with triangles");
}

void read(
    Assimp::Importer& importer,
    std::string_view text,
    const std::string& format,
    unsigned additionalSteps) {
  if (format == "ply") requirePlausibleHeader(text);
  importer.SetIOHandler(new NoFiles);  // the importer becomes the owner
  keepOnlyReaderOf(importer, format);
  importer.ReadFileFromMemory(
      text.data(), text.size(), aiProcess_ValidateDataStructure | additionalSteps, format.c_str());
  if (const auto* scene = importer.GetScene()) requireFewCorners(*scene);
}

std::vector<NamedSurface> surfacesOf(Assimp::Importer& importer, unsigned additionalSteps) {
  const aiScene* scene = importer.GetScene();
  if (scene == nullptr || scene->mNumMeshes == 0) {
    throw base::UserError(
        std::string("it holds no mesh that can be read (") + importer.GetErrorString() + ")");
  }
  std::vector<bool> hasNormals;
  bool isSound = true;
  for (unsigned i = 0; i < scene->mNumMeshes; ++i) {
    hasNormals.push_back(scene->mMeshes[i]->HasNormals());
    isSound = isSound && isFiniteMesh(*scene->mMeshes[i]);
  }
  importer.SetPropertyFloat(AI_CONFIG_PP_GSN_MAX_SMOOTHING_ANGLE, kSharpEdgeAngle);
  if (isSound)
    scene = importer.ApplyPostProcessing(additionalSteps | aiProcess_JoinIdenticalVertices);
  if (scene == nullptr || scene->mNumMeshes < hasNormals.size()) {
    throw base::UserError(std::string("it is damaged (") + importer.GetErrorString() + ")");
  }
  hasNormals.resize(scene->mNumMeshes, true);
  std::vector<NamedSurface> surfaces;
  collectSurfaces(*scene, *scene->mRootNode, hasNormals, surfaces);
  return surfaces;
}

}  // namespace

std::vector<NamedSurface> readMesh(std::string_view text) {
  Assimp::Importer importer;
  read(importer, text, formatOf(text), aiProcess_PreTransformVertices);
  return surfacesOf(importer, aiProcess_Triangulate);
}

std::vector<NamedSurface> readMeshFile(const std::string& path) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error)) {
    throw base::UserError("it is no file, or cannot be read");
  }
  if (std::filesystem::file_size(path, error) > kLargestMesh) {
    throw base::UserError("it is larger than 512 MB");
  }
  const auto text = base::readFile(path);
  if (!text) throw base::UserError("it cannot be read");
  return readMesh(*text);
}

std::vector<NamedSurface> readObj(std::string_view text) {
  Assimp::Importer importer;
  read(importer, text, "obj", 0);
  return surfacesOf(importer, aiProcess_Triangulate | aiProcess_GenSmoothNormals);
}

}  // namespace protocols
