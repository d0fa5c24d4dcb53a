#pragma once

#include <string>
#include <vector>

#include "haptics/reaming/packing/packed_bone.h"
#include "haptics/reaming/packing/triangle_mesh.h"
#include "protocols/reading/packing_file.h"

namespace CLI {
class App;
}

namespace study::app {

/// The curves that a bone is fitted to.
struct MaterialChoice {
  std::string file;  ///< or "parametric"
  std::string set = "dynamic-1";
};
void addMaterialOptions(CLI::App& verb, MaterialChoice& choice);

/// @throws UserError  in words, if the file is missing or is no packing.
haptics::reaming::PackedBone readBone(const std::string& path, protocols::PackingOrigin& origin);

struct ChosenCurves {
  haptics::reaming::HardnessCurves curves;
  haptics::reaming::HardnessCurves torque;  ///< empty where none was measured
  bool isSynthetic = false;                 ///< not measured
};

/// The curves; writes their names into @p origin.
/// @throws UserError  in words, if the file is missing, is no material, or has no such test set.
ChosenCurves curvesOf(const MaterialChoice& choice, protocols::PackingOrigin& origin);

/// A body from an STL, OBJ or PLY file, ready to be packed with spheres.
struct BodyMesh {
  haptics::reaming::TriangleMesh mesh;  ///< [m]
  std::vector<std::string> said;        ///< repairs and assumptions, in words
};

/// @param unit  "m", "mm", or empty: derived from the size of the mesh.
/// @throws UserError  in words, if the file is missing or its surface encloses no volume.
BodyMesh readBody(const std::string& path, const std::string& unit);

}  // namespace study::app
