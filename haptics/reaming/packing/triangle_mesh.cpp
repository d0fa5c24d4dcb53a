#include "haptics/reaming/packing/triangle_mesh.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>

#include "haptics/reaming/packing/box_tree.h"

namespace haptics::reaming {
namespace {

using Edge = std::pair<std::uint32_t, std::uint32_t>;

std::string countText(std::size_t count, const char* one, const char* many) {
  return std::to_string(count) + " " + (count == 1 ? one : many);
}

bool isFinite(const TriangleMesh& mesh) noexcept {
  return std::ranges::all_of(mesh.vertices, [](const Vec3& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
  });
}

/// Merges coinciding vertices; returns how many were removed.
std::size_t mergeVertices(TriangleMesh& mesh) {
  std::map<std::array<double, 3>, std::uint32_t> known;
  std::vector<std::uint32_t> renamed;
  std::vector<Vec3> kept;
  for (const Vec3& v : mesh.vertices) {
    const auto [entry, isNew] =
        known.try_emplace({v.x, v.y, v.z}, static_cast<std::uint32_t>(kept.size()));
    if (isNew) kept.push_back(v);
    renamed.push_back(entry->second);
  }
  const std::size_t welded = mesh.vertices.size() - kept.size();
  mesh.vertices = std::move(kept);
  for (auto& triangle : mesh.triangles) {
    for (auto& corner : triangle) corner = renamed[corner];
  }
  return welded;
}

double areaOf(const TriangleMesh& mesh, const TriangleMesh::Triangle& t) {
  const Vec3 a = mesh.vertices[t[0]];
  return 0.5 * length(cross(mesh.vertices[t[1]] - a, mesh.vertices[t[2]] - a));
}

std::size_t dropDegenerate(TriangleMesh& mesh) {
  std::set<TriangleMesh::Triangle> seen;
  const std::size_t before = mesh.triangles.size();
  std::erase_if(mesh.triangles, [&](const TriangleMesh::Triangle& t) {
    if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0]) return true;
    auto sorted = t;
    std::ranges::sort(sorted);
    return !seen.insert(sorted).second;
  });
  return before - mesh.triangles.size();
}

/// Whether the segment p–q intersects the triangle abc without being in its plane.
bool pierces(Vec3 p, Vec3 q, Vec3 a, Vec3 b, Vec3 c) noexcept {
  const auto side = [](Vec3 u, Vec3 v, Vec3 w, Vec3 x) { return dot(cross(v - u, w - u), x - u); };
  const double above = side(a, b, c, p);
  const double below = side(a, b, c, q);
  if (above * below > 0.0 || (above == 0.0 && below == 0.0)) return false;
  const double first = side(p, q, a, b);
  const double second = side(p, q, b, c);
  const double third = side(p, q, c, a);
  return (first >= 0.0 && second >= 0.0 && third >= 0.0) ||
         (first <= 0.0 && second <= 0.0 && third <= 0.0);
}

bool doIntersect(
    const TriangleMesh& mesh, const TriangleMesh::Triangle& s, const TriangleMesh::Triangle& t) {
  for (const auto corner : s) {
    if (std::ranges::find(t, corner) != t.end()) return false;  // neighbours share a corner
  }
  const auto& v = mesh.vertices;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t next = (i + 1) % 3;
    if (pierces(v[s[i]], v[s[next]], v[t[0]], v[t[1]], v[t[2]])) return true;
    if (pierces(v[t[i]], v[t[next]], v[s[0]], v[s[1]], v[s[2]])) return true;
  }
  return false;
}

std::size_t countIntersectingPairs(const TriangleMesh& mesh) {
  const BoxTree tree(boxesOf(mesh));
  std::size_t pairs = 0;
  for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
    tree.forEachOverlapping(boxOf(mesh, mesh.triangles[i]), [&](std::uint32_t j) {
      if (j > i && doIntersect(mesh, mesh.triangles[i], mesh.triangles[j])) ++pairs;
    });
  }
  return pairs;
}

/// Index of the connected part of each triangle, and the number of parts.
std::pair<std::vector<std::size_t>, std::size_t> partsOf(const TriangleMesh& mesh) {
  std::vector<std::size_t> root(mesh.vertices.size());
  std::iota(root.begin(), root.end(), std::size_t{0});
  const auto rootOf = [&](std::size_t i) {
    while (root[i] != i) i = root[i] = root[root[i]];
    return i;
  };
  for (const auto& t : mesh.triangles) {
    root[rootOf(t[1])] = rootOf(t[0]);
    root[rootOf(t[2])] = rootOf(t[0]);
  }
  std::map<std::size_t, std::size_t> numbers;
  std::vector<std::size_t> parts;
  for (const auto& t : mesh.triangles) {
    parts.push_back(numbers.try_emplace(rootOf(t[0]), numbers.size()).first->second);
  }
  return {std::move(parts), numbers.size()};
}

/// Solid angle of a triangle seen from @p from (Van Oosterom & Strackee 1983). Summed over a closed
/// part it is ±4π inside and 0 outside.
double angleOf(const TriangleMesh& mesh, const TriangleMesh::Triangle& t, Vec3 from) {
  const Vec3 a = mesh.vertices[t[0]] - from;
  const Vec3 b = mesh.vertices[t[1]] - from;
  const Vec3 c = mesh.vertices[t[2]] - from;
  const double la = length(a);
  const double lb = length(b);
  const double lc = length(c);
  return 2.0 *
         std::atan2(
             dot(a, cross(b, c)), la * lb * lc + dot(a, b) * lc + dot(b, c) * la + dot(c, a) * lb);
}

/// Whether the parts form one body: a part that is not inside another part faces outwards, and a
/// part inside another part (a hollow) faces inwards. Otherwise the interior is not defined.
bool isOneBody(const TriangleMesh& mesh) {
  const auto [parts, count] = partsOf(mesh);
  if (count == 1) return true;
  if (count > 100) return false;
  std::vector<double> volumes(count, 0.0);
  std::vector<Vec3> corners(count);
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const auto& t = mesh.triangles[i];
    volumes[parts[i]] +=
        dot(mesh.vertices[t[0]], cross(mesh.vertices[t[1]], mesh.vertices[t[2]])) / 6.0;
    corners[parts[i]] = mesh.vertices[t[0]];
  }
  for (std::size_t part = 0; part < count; ++part) {
    std::vector<double> angles(count, 0.0);
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
      if (parts[i] != part) angles[parts[i]] += angleOf(mesh, mesh.triangles[i], corners[part]);
    }
    int around = 0;
    for (const double angle : angles) around += std::abs(angle) > 6.0 ? 1 : 0;
    if ((volumes[part] > 0.0) != (around % 2 == 0)) return false;
  }
  return true;
}

}  // namespace

double TriangleMesh::volume() const noexcept {
  double sum = 0.0;
  for (const auto& t : triangles) {
    sum += dot(vertices[t[0]], cross(vertices[t[1]], vertices[t[2]])) / 6.0;
  }
  return sum;
}

Repairs repair(TriangleMesh& mesh) {
  Repairs repairs;
  if (!isFinite(mesh)) return repairs;  // problemsOf() reports it
  if (const auto welded = mergeVertices(mesh); welded > 0) {
    repairs.push_back(
        countText(welded, "corner was", "corners were") + " joined with others there");
  }
  if (const auto dropped = dropDegenerate(mesh); dropped > 0) {
    repairs.push_back(
        countText(dropped, "triangle", "triangles") + " without area or twice there left out");
  }
  if (mesh.volume() < 0.0) {
    for (auto& triangle : mesh.triangles) std::swap(triangle[1], triangle[2]);
    repairs.emplace_back("the mesh was inside out and has been turned");
  }
  return repairs;
}

std::vector<std::string> problemsOf(const TriangleMesh& mesh) {
  if (mesh.triangles.size() < 4) return {"the mesh has fewer than four triangles"};
  if (!isFinite(mesh)) return {"the mesh has a corner that is no number"};
  std::map<Edge, std::pair<int, int>> edges;  // number of uses in either direction
  double area = 0.0;
  for (const auto& t : mesh.triangles) {
    area += areaOf(mesh, t);
    for (std::size_t i = 0; i < 3; ++i) {
      const auto from = t[i];
      const auto to = t[(i + 1) % 3];
      auto& uses = edges[{std::min(from, to), std::max(from, to)}];
      (from < to ? uses.first : uses.second)++;
    }
  }
  std::size_t open = 0;
  std::size_t crowded = 0;
  std::size_t turned = 0;
  for (const auto& [edge, uses] : edges) {
    const int count = uses.first + uses.second;
    if (count == 1) ++open;
    if (count > 2) ++crowded;
    if (count == 2 && uses.first != 1) ++turned;
  }
  std::vector<std::string> problems;
  if (open > 0) {
    problems.push_back(
        "the mesh is open: " + countText(open, "edge has", "edges have") +
        " a triangle on one side only. Close its holes");
  }
  if (crowded > 0) {
    problems.push_back(
        countText(crowded, "edge has", "edges have") +
        " more than two triangles, so there is no telling what is inside. Remove inner walls");
  }
  if (turned > 0) {
    problems.push_back(
        countText(turned, "pair", "pairs") +
        " of neighbouring triangles face opposite ways. Make the normals consistent");
  }
  const double thickness = area > 0.0 ? mesh.volume() / area : 0.0;
  // The volume of a surface that is folded flat consists of rounding errors.
  if (problems.empty() && !(thickness > 1e-9)) {
    problems.emplace_back("the mesh encloses nothing");
  }
  if (!problems.empty()) return problems;
  if (const auto pairs = countIntersectingPairs(mesh); pairs > 0) {
    problems.push_back(
        "the mesh cuts itself: " + countText(pairs, "pair", "pairs") +
        " of triangles. Join its parts, or remesh it");
  }
  if (problems.empty() && !isOneBody(mesh)) {
    problems.emplace_back(
        "the mesh has parts that face the wrong way for where they lie: outer surfaces face "
        "outward, hollows inward. Keep the outer surface alone, or turn the others");
  }
  return problems;
}

double likelyUnit(const TriangleMesh& mesh) noexcept {
  if (mesh.vertices.empty()) return 0.0;
  const Box box = boxOf(mesh.vertices);
  const double size = length(box.high - box.low);
  if (size >= 10.0 && size <= 1000.0) return 0.001;
  if (size >= 0.01 && size <= 1.0) return 1.0;
  return 0.0;
}

}  // namespace haptics::reaming
