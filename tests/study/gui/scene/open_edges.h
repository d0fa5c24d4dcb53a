#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

#include "study/gui/scene/shapes/mesh.h"

namespace study::gui::scene {

/// The number of edges without a neighbour in the opposite direction, where positions within a
/// micrometre count as equal. A closed surface has none.
inline std::ptrdiff_t countOpenEdges(const Mesh& mesh) {
  using Place = std::array<long, 3>;
  const auto placeOf = [&mesh](std::uint32_t vertex) {
    const QVector3D at = 1000.0F * mesh.vertices[vertex].position;
    return Place{std::lround(at.x()), std::lround(at.y()), std::lround(at.z())};
  };
  std::map<std::pair<Place, Place>, int> runs;
  for (const auto& t : mesh.triangles) {
    const std::array corners{placeOf(t.a), placeOf(t.b), placeOf(t.c)};
    for (std::size_t i = 0; i < 3; ++i) {
      const auto& from = corners[i];
      const auto& to = corners[(i + 1) % 3];
      if (from == to) continue;  // a degenerate triangle
      from < to ? ++runs[{from, to}] : --runs[{to, from}];
    }
  }
  return std::ranges::count_if(runs, [](const auto& run) { return run.second != 0; });
}

}  // namespace study::gui::scene
