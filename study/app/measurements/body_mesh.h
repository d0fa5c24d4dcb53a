#pragma once

#include <string>
#include <vector>

#include "haptics/reaming/packing/triangle_mesh.h"

namespace study::app {

/// A body from an STL, OBJ or PLY file, ready to be packed with spheres.
struct BodyMesh {
  haptics::reaming::TriangleMesh mesh;  ///< [m]
  std::vector<std::string> said;        ///< repairs and assumptions, in words
};

/// @param unit  "m", "mm", or empty: derived from the size of the mesh.
/// @throws UserError  in words, if the file is missing or its surface encloses no volume.
BodyMesh readBody(const std::string& path, const std::string& unit);

}  // namespace study::app
