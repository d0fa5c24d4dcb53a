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

/// The curves to which a bone is fitted.
struct MaterialChoice {
  std::string file;  ///< a material file, or "parametric" for the built-in curves
  std::string set = "dynamic-1";
};
void addMaterialOptions(CLI::App& verb, MaterialChoice& choice);

/// @throws UserError  if the file is missing or is no packing.
haptics::reaming::PackedBone readBone(const std::string& path, protocols::PackingOrigin& origin);

/// The curves for a fit, read from a material.
struct ChosenCurves {
  haptics::reaming::HardnessCurves curves;
  haptics::reaming::HardnessCurves torque;  ///< empty if no torque was measured
  bool isSynthetic = false;                 ///< whether the curves are synthetic
};

/// Reads the curves of @p choice, and writes their names into @p origin.
/// @throws UserError  if the file is missing, is no material, or has no such test set.
ChosenCurves curvesOf(const MaterialChoice& choice, protocols::PackingOrigin& origin);

/// A body from an STL, OBJ or PLY file, to be packed with spheres.
struct BodyMesh {
  haptics::reaming::TriangleMesh mesh;  ///< [m]
  std::vector<std::string> remarks;     ///< sentences on repairs and assumptions, for the user
};

/// @param unit  "m", "mm", or empty: it is derived from the size of the mesh.
/// @throws UserError  if the file is missing or its surface encloses no volume.
BodyMesh readBody(const std::string& path, const std::string& unit);

}  // namespace study::app
