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

  std::string name;             ///< of the object or group; empty where the file gives none
  std::vector<Triple> places;   ///< may be no numbers where the file has none
  std::vector<Triple> normals;  ///< as many as places
  std::vector<Colour> colours;  ///< as many as places, or none
  std::vector<std::array<std::uint32_t, 3>> triangles;  ///< of places that there are
  bool hasNormals = true;  ///< in the file; otherwise they were taken from the triangles
};

/// All surfaces of a file on the disk: STL, OBJ, PLY.
/// @throws questionnaires::Error  in words, if it holds none that can be read.
std::vector<NamedSurface> readMeshFile(const std::string& path);

/// The same of an OBJ file's text. Files that it names, of materials, are not looked for.
std::vector<NamedSurface> readObj(std::string_view text);

}  // namespace protocols
