#pragma once

#include <string>
#include <vector>

#include "haptics/reaming/packing/triangle_mesh.h"

namespace study::app {

/// A body from an STL, OBJ or PLY file, ready to be filled.
struct BodyMesh {
  haptics::reaming::TriangleMesh mesh;  ///< [m]
  std::vector<std::string> said;        ///< what was mended and taken for granted
};

/// @param unit  "m", "mm", or empty: from the size of the mesh.
/// @throws UserError  in words, where there is no such file, or it has no inside.
BodyMesh readBody(const std::string& path, const std::string& unit);

}  // namespace study::app
