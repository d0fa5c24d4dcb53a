#include "haptics/reaming/triangle_mesh.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>
#include <unordered_map>

#include "haptics/reaming/box_tree.h"

namespace haptics::reaming {
namespace {

using Edge = std::pair<std::uint32_t, std::uint32_t>;

std::string counted(std::size_t count, const char* one, const char* many) {
  return std::to_string(count) + " " + (count == 1 ? one : many);
}

/// Vertices at the same place become one.
std::size_t weld(TriangleMesh& mesh) {
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
    std::sort(sorted.begin(), sorted.end());
    return !seen.insert(sorted).second;
  });
  return before - mesh.triangles.size();
}

/// Whether the segment p–q passes through the triangle, properly.
bool pierces(Vec3 p, Vec3 q, Vec3 a, Vec3 b, Vec3 c) noexcept {
  const auto side = [](Vec3 u, Vec3 v, Vec3 w, Vec3 x) { return dot(cross(v - u, w - u), x - u); };
  const double above = side(a, b, c, p);
  const double below = side(a, b, c, q);
  if (!(above * below < 0.0)) return false;
  const double first = side(p, q, a, b);
  const double second = side(p, q, b, c);
  const double third = side(p, q, c, a);
  return (first > 0.0 && second > 0.0 && third > 0.0) ||
         (first < 0.0 && second < 0.0 && third < 0.0);
}

bool cut(
    const TriangleMesh& mesh, const TriangleMesh::Triangle& s, const TriangleMesh::Triangle& t) {
  for (const auto corner : s) {
    if (std::find(t.begin(), t.end(), corner) != t.end()) return false;  // neighbours
  }
  const auto& v = mesh.vertices;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t next = (i + 1) % 3;
    if (pierces(v[s[i]], v[s[next]], v[t[0]], v[t[1]], v[t[2]])) return true;
    if (pierces(v[t[i]], v[t[next]], v[s[0]], v[s[1]], v[s[2]])) return true;
  }
  return false;
}

std::size_t pairsThatCut(const TriangleMesh& mesh) {
  const BoxTree tree(boxesOf(mesh));
  std::size_t pairs = 0;
  for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
    tree.eachMeeting(boxOf(mesh, mesh.triangles[i]), [&](std::uint32_t j) {
      if (j > i && cut(mesh, mesh.triangles[i], mesh.triangles[j])) ++pairs;
    });
  }
  return pairs;
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
  if (const auto welded = weld(mesh); welded > 0) {
    repairs.push_back(counted(welded, "corner was", "corners were") + " joined with others there");
  }
  if (const auto dropped = dropDegenerate(mesh); dropped > 0) {
    repairs.push_back(
        counted(dropped, "triangle", "triangles") + " without area or twice there left out");
  }
  if (mesh.volume() < 0.0) {
    for (auto& triangle : mesh.triangles) std::swap(triangle[1], triangle[2]);
    repairs.emplace_back("the mesh was inside out and has been turned");
  }
  return repairs;
}

std::vector<std::string> problemsOf(const TriangleMesh& mesh) {
  if (mesh.triangles.size() < 4) return {"the mesh has fewer than four triangles"};
  for (const Vec3& v : mesh.vertices) {
    if (!std::isfinite(v.x + v.y + v.z)) return {"the mesh has a corner that is no number"};
  }
  std::map<Edge, std::pair<int, int>> edges;  // there, and back
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
        "the mesh is open: " + counted(open, "edge has", "edges have") +
        " a triangle on one side only. Close its holes");
  }
  if (crowded > 0) {
    problems.push_back(
        counted(crowded, "edge has", "edges have") +
        " more than two triangles, so there is no telling what is inside. Remove inner walls");
  }
  if (turned > 0) {
    problems.push_back(
        counted(turned, "pair", "pairs") +
        " of neighbouring triangles face opposite ways. Make the normals consistent");
  }
  const double thickness = area > 0.0 ? mesh.volume() / area : 0.0;
  if (problems.empty() && !(thickness > 1e-9)) {
    problems.emplace_back("the mesh encloses nothing");
  }
  if (!problems.empty()) return problems;
  if (const auto pairs = pairsThatCut(mesh); pairs > 0) {
    problems.push_back(
        "the mesh cuts itself: " + counted(pairs, "pair", "pairs") +
        " of triangles. Join its parts, or remesh it");
  }
  return problems;
}

double likelyUnit(const TriangleMesh& mesh) noexcept {
  Vec3 low = mesh.vertices.empty() ? Vec3{} : mesh.vertices.front();
  Vec3 high = low;
  for (const Vec3& v : mesh.vertices) {
    low = {std::min(low.x, v.x), std::min(low.y, v.y), std::min(low.z, v.z)};
    high = {std::max(high.x, v.x), std::max(high.y, v.y), std::max(high.z, v.z)};
  }
  const double size = length(high - low);
  if (size >= 10.0 && size <= 1000.0) return 0.001;
  if (size >= 0.01 && size <= 1.0) return 1.0;
  return 0.0;
}

}  // namespace haptics::reaming
