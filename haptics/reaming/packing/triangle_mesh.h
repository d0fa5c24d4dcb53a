#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "haptics/reaming/bone/packing.h"

namespace haptics::reaming {

/// A surface of triangles, seen from outside counter-clockwise.
struct TriangleMesh {
  using Triangle = std::array<std::uint32_t, 3>;
  std::vector<Vec3> vertices;  ///< [m]
  std::vector<Triangle> triangles;

  double volume() const noexcept;  ///< that it encloses [m³]; below 0 where it is inside out
};

/// What was repaired, in words.
using Repairs = std::vector<std::string>;

/// Merges coinciding vertices, removes triangles without area and duplicates, and turns the faces
/// of a mesh outwards. Returns what it did.
Repairs repair(TriangleMesh& mesh);

/// All reasons why a mesh has no interior: holes, edges of more than two triangles, triangles that
/// turn against their neighbours, triangles that cut each other. Empty where it has one.
std::vector<std::string> problemsOf(const TriangleMesh& mesh);

/// How large a mesh is if its numbers are millimetres or metres: a bone is between 1 cm and 1 m.
/// @return 1 (metres), 0.001 (millimetres), or 0 where neither makes a bone.
double likelyUnit(const TriangleMesh& mesh) noexcept;

}  // namespace haptics::reaming
