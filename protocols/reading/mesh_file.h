#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace protocols {

/// A triangle mesh of a file, in the frame and unit of the file.
struct NamedSurface {
  using Triple = std::array<float, 3>;
  using Colour = std::array<std::uint8_t, 3>;

  std::string name;             ///< name of the object or group; empty if the file has none
  std::vector<Triple> places;   ///< vertices; may be NaN if the file has invalid numbers
  std::vector<Triple> normals;  ///< as many as places
  std::vector<Colour> colours;  ///< as many as places, or none
  std::vector<std::array<std::uint32_t, 3>> triangles;  ///< indices into places
  bool hasNormals = true;  ///< true: from the file; false: computed from the triangles
};

/// Reads all surfaces of an STL, OBJ or PLY file; the first bytes determine the format. Files that
/// it refers to are not opened.
/// @throws UserError  if no surface can be read, or if faces have so many corners that cutting them
///     into triangles would take long.
std::vector<NamedSurface> readMesh(std::string_view text);

/// Reads all surfaces of a file on the disk, up to 512 MB.
std::vector<NamedSurface> readMeshFile(const std::string& path);

/// The surfaces of an OBJ file's text. Material files that it names are not read.
std::vector<NamedSurface> readObj(std::string_view text);

}  // namespace protocols
