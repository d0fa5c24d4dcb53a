#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "haptics/reaming/bone/packing.h"

namespace haptics::reaming {

/// A surface of triangles, whose corners are counter-clockwise seen from outside.
struct TriangleMesh {
  using Triangle = std::array<std::uint32_t, 3>;
  std::vector<Vec3> vertices;  ///< [m]
  std::vector<Triangle> triangles;

  double volume() const noexcept;  ///< enclosed volume [m³]; negative if the mesh is inside out
};

/// Messages about what was repaired.
using Repairs = std::vector<std::string>;

/// Merges coinciding vertices, removes degenerate and duplicate triangles, and orients the faces
/// outwards. Returns what it did.
Repairs repair(TriangleMesh& mesh);

/// All reasons why a mesh has no interior: holes, edges of more than two triangles, triangles that
/// are oriented against their neighbours, triangles that intersect. Empty if the mesh is valid.
std::vector<std::string> problemsOf(const TriangleMesh& mesh);

/// Guesses the unit of the vertices from the size of the mesh: a bone is between 1 cm and 1 m.
/// @return 1 (metres), 0.001 (millimetres), or 0 if neither gives the size of a bone.
double likelyUnit(const TriangleMesh& mesh) noexcept;

}  // namespace haptics::reaming
