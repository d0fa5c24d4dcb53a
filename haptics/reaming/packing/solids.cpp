#include "haptics/reaming/packing/solids.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <stdexcept>
#include <utility>

namespace haptics::reaming {

Acetabulum::Acetabulum(double inner, double outer) : inner_(inner), outer_(outer) {
  if (!(inner >= 0.0 && inner < outer && outer <= 1.0)) {
    throw std::invalid_argument("the radii of an acetabulum: 0 ≤ inner < outer ≤ 1 m");
  }
}

SurfacePoint Acetabulum::nearest(Vec3 place) const noexcept {
  const double radius = length(place);
  const Vec3 outward = radius > 0.0 ? (1.0 / radius) * place : Vec3{0.0, 0.0, 1.0};
  // The nearest of three surfaces: the rim's plane z = 0, the outer and the inner sphere. Exact
  // inside the body.
  SurfacePoint found{place.z, {0.0, 0.0, 1.0}};
  if (outer_ - radius < found.distance) found = {outer_ - radius, -1.0 * outward};
  if (inner_ > 0.0 && radius - inner_ < found.distance) found = {radius - inner_, outward};
  return found;
}

double Acetabulum::volume() const noexcept {
  return 2.0 / 3.0 * std::numbers::pi * (outer_ * outer_ * outer_ - inner_ * inner_ * inner_);
}

namespace {

/// The point of a triangle nearest to another, and the part on which it is.
struct NearestPart {
  Vec3 place;
  enum class Part { Face, Edge, Corner } part = Part::Face;
  std::size_t which = 0;  ///< index of the edge or corner
};

/// The point of triangle abc nearest to @p p, by Voronoi regions (Ericson 2004, 5.1.5).
NearestPart nearestOn(Vec3 p, Vec3 a, Vec3 b, Vec3 c) noexcept {
  using Part = NearestPart::Part;
  const Vec3 ab = b - a;
  const Vec3 ac = c - a;
  const Vec3 ap = p - a;
  const double d1 = dot(ab, ap);
  const double d2 = dot(ac, ap);
  if (d1 <= 0.0 && d2 <= 0.0) return {a, Part::Corner, 0};
  const Vec3 bp = p - b;
  const double d3 = dot(ab, bp);
  const double d4 = dot(ac, bp);
  if (d3 >= 0.0 && d4 <= d3) return {b, Part::Corner, 1};
  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0.0 && d1 >= 0.0 && d3 <= 0.0) return {a + (d1 / (d1 - d3)) * ab, Part::Edge, 0};
  const Vec3 cp = p - c;
  const double d5 = dot(ab, cp);
  const double d6 = dot(ac, cp);
  if (d6 >= 0.0 && d5 <= d6) return {c, Part::Corner, 2};
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0.0 && d2 >= 0.0 && d6 <= 0.0) return {a + (d2 / (d2 - d6)) * ac, Part::Edge, 2};
  const double va = d3 * d6 - d5 * d4;
  if (va <= 0.0 && d4 >= d3 && d5 >= d6) {
    return {b + ((d4 - d3) / ((d4 - d3) + (d5 - d6))) * (c - b), Part::Edge, 1};
  }
  const double sum = va + vb + vc;
  return {a + (vb / sum) * ab + (vc / sum) * ac, Part::Face, 0};
}

Vec3 unit(Vec3 v) noexcept {
  const double size = length(v);
  return size > 0.0 ? (1.0 / size) * v : v;
}

double angleAt(Vec3 corner, Vec3 one, Vec3 other) noexcept {
  const Vec3 a = one - corner;
  const Vec3 b = other - corner;
  return std::atan2(length(cross(a, b)), dot(a, b));  // accurate for small angles, unlike acos
}

}  // namespace

MeshSolid::MeshSolid(TriangleMesh mesh)
    : mesh_(std::move(mesh)),
      tree_(boxesOf(mesh_)),
      box_(boxOf(mesh_.vertices)),
      volume_(mesh_.volume()) {
  // The normal of the nearest part decides whether a point is inside. At an edge it is the mean of
  // both faces, at a corner the mean weighted by angles: with these pseudonormals the sign is right
  // everywhere (Baerentzen & Aanaes 2005), whereas the normal of a single face would be wrong near
  // a sharp corner.
  std::vector<Vec3> cornerNormals(mesh_.vertices.size());
  std::map<std::pair<std::uint32_t, std::uint32_t>, Vec3> atEdge;
  const auto& v = mesh_.vertices;
  for (const auto& t : mesh_.triangles) {
    const Vec3 face = unit(cross(v[t[1]] - v[t[0]], v[t[2]] - v[t[0]]));
    normals_.push_back({.face = face, .edge = {}, .corner = {}});
    for (std::size_t i = 0; i < 3; ++i) {
      const auto here = t[i];
      const auto next = t[(i + 1) % 3];
      const auto last = t[(i + 2) % 3];
      cornerNormals[here] = cornerNormals[here] + angleAt(v[here], v[next], v[last]) * face;
      auto& edge = atEdge[{std::min(here, next), std::max(here, next)}];
      edge = edge + face;
    }
  }
  for (std::size_t k = 0; k < normals_.size(); ++k) {
    const auto& t = mesh_.triangles[k];
    for (std::size_t i = 0; i < 3; ++i) {
      const auto next = t[(i + 1) % 3];
      normals_[k].corner[i] = unit(cornerNormals[t[i]]);
      normals_[k].edge[i] = unit(atEdge[{std::min(t[i], next), std::max(t[i], next)}]);
    }
  }
}

SurfacePoint MeshSolid::nearest(Vec3 place) const noexcept {
  double square = std::numeric_limits<double>::infinity();
  NearestPart best;
  std::uint32_t triangle = 0;
  tree_.forEachNearer(place, square, [&](std::uint32_t i) {
    const auto& t = mesh_.triangles[i];
    const auto found =
        nearestOn(place, mesh_.vertices[t[0]], mesh_.vertices[t[1]], mesh_.vertices[t[2]]);
    const Vec3 off = place - found.place;
    if (dot(off, off) < square) {
      square = dot(off, off);
      best = found;
      triangle = i;
    }
    return square;
  });
  const auto& normals = normals_[triangle];
  const Vec3 outward = best.part == NearestPart::Part::Face   ? normals.face
                       : best.part == NearestPart::Part::Edge ? normals.edge[best.which]
                                                              : normals.corner[best.which];
  const Vec3 off = place - best.place;
  const double gap = std::sqrt(square);
  const double sign = dot(off, outward) > 0.0 ? -1.0 : 1.0;
  const Vec3 inward = gap > 0.0 ? (sign / gap) * off : -1.0 * outward;
  return {sign * gap, inward};
}

}  // namespace haptics::reaming
