#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace protocols {

/// A surface of triangles as a file has it, in the file's own frame and unit.
struct NamedSurface {
  using Triple = std::array<float, 3>;
  using Colour = std::array<std::uint8_t, 3>;

  std::string name;             ///< of the object or group; empty if the file gives none
  std::vector<Triple> places;   ///< may be NaN if the file has invalid numbers
  std::vector<Triple> normals;  ///< as many as places
  std::vector<Colour> colours;  ///< as many as places, or none
  std::vector<std::array<std::uint32_t, 3>> triangles;  ///< indices into places
  bool hasNormals = true;  ///< true: from the file; false: computed from the triangles
};

/// All surfaces of a mesh: STL, OBJ or PLY, which is told by how it begins. No other format is
/// tried, and no file is opened that is named in it.
/// @throws UserError  in words, if it has none that can be read, or faces with so many
///     corners that cutting them into triangles would take long.
std::vector<NamedSurface> readMesh(std::string_view text);

/// The same of a file on the disk, up to 512 MB.
std::vector<NamedSurface> readMeshFile(const std::string& path);

/// The surfaces of an OBJ file's text. Material files that it names are not read.
std::vector<NamedSurface> readObj(std::string_view text);

}  // namespace protocols
