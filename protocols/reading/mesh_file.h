#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace protocols {

/// A triangle mesh from a file, in the file's frame and unit.
struct NamedSurface {
  using Triple = std::array<float, 3>;
  using Colour = std::array<std::uint8_t, 3>;

  std::string name;             ///< name of the object or group; empty if the file has none
  std::vector<Triple> places;   ///< vertices; may be NaN if the file has invalid numbers
  std::vector<Triple> normals;  ///< one for each vertex
  std::vector<Colour> colours;  ///< one for each vertex, or none
  std::vector<std::array<std::uint32_t, 3>> triangles;  ///< indices of vertices
  bool hasNormals = true;  ///< whether normals are from the file; otherwise they were computed from
                           ///< the triangles
};

/// Reads all surfaces of an STL, OBJ or PLY file; the format is determined by its beginning. Other
/// files that it refers to are not opened.
/// @throws UserError  if no surface can be read, or if triangulating faces with many corners would
///     take too long.
std::vector<NamedSurface> readMesh(std::string_view text);

/// Reads all surfaces of a file on the disk, up to 512 MB.
std::vector<NamedSurface> readMeshFile(const std::string& path);

/// The surfaces in the text of an OBJ file. Material files that it refers to are not read.
std::vector<NamedSurface> readObj(std::string_view text);

}  // namespace protocols
