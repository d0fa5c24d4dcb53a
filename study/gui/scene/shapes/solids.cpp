#include "study/gui/scene/shapes/solids.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace study::gui::scene {
namespace {

constexpr float kTurn = 2.0F * std::numbers::pi_v<float>;

std::uint32_t asIndex(std::size_t i) {
  return static_cast<std::uint32_t>(i);
}

Mesh pointsOf(const std::vector<Ring>& rings) {
  Mesh mesh;
  for (const auto& ring : rings) {
    for (const auto& place : ring) mesh.vertices.push_back({place, {}, {}});
  }
  return mesh;
}

/// Adds the triangles between ring @p from and ring @p to.
void join(Mesh& mesh, std::size_t corners, std::size_t from, std::size_t to) {
  for (std::size_t i = 0; i < corners; ++i) {
    const std::size_t next = (i + 1) % corners;
    const auto a = asIndex(corners * from + i);
    const auto b = asIndex(corners * from + next);
    const auto c = asIndex(corners * to + next);
    const auto d = asIndex(corners * to + i);
    mesh.triangles.push_back({a, b, c});
    mesh.triangles.push_back({a, c, d});
  }
}

/// Closes ring @p at with a triangle fan around its centre.
void cap(Mesh& mesh, std::size_t corners, std::size_t at, bool isFirst) {
  QVector3D middle;
  for (std::size_t i = 0; i < corners; ++i) middle += mesh.vertices[corners * at + i].position;
  const auto centre = asIndex(mesh.vertices.size());
  mesh.vertices.push_back({middle / static_cast<float>(corners), {}, {}});
  for (std::size_t i = 0; i < corners; ++i) {
    const auto a = asIndex(corners * at + i);
    const auto b = asIndex(corners * at + (i + 1) % corners);
    mesh.triangles.push_back(isFirst ? Triangle{centre, b, a} : Triangle{centre, a, b});
  }
}

/// The place and the direction at @p at of a smooth curve through @p path, whose points lie at 0,
/// 1, 2 … (a Catmull-Rom spline).
std::pair<QVector3D, QVector3D> onCurve(const std::vector<QVector3D>& path, float at) {
  const auto last = static_cast<int>(path.size()) - 1;
  const int i = std::clamp(static_cast<int>(at), 0, last - 1);
  const auto point = [&](int k) { return path[static_cast<std::size_t>(std::clamp(k, 0, last))]; };
  const QVector3D from = point(i);
  const QVector3D to = point(i + 1);
  const QVector3D leaving = 0.5F * (to - point(i - 1));
  const QVector3D arriving = 0.5F * (point(i + 2) - from);
  const float t = at - static_cast<float>(i);
  const QVector3D c = 3.0F * (to - from) - 2.0F * leaving - arriving;
  const QVector3D d = 2.0F * (from - to) + leaving + arriving;
  return {from + t * (leaving + t * (c + t * d)), leaving + t * (2.0F * c + 3.0F * t * d)};
}

void orientOutwards(Mesh& mesh) {
  if (volumeOf(mesh) >= 0.0) return;
  for (auto& t : mesh.triangles) std::swap(t.b, t.c);
}

}  // namespace

Mesh loft(const std::vector<Ring>& rings) {
  Mesh mesh = pointsOf(rings);
  const std::size_t corners = rings.front().size();
  for (std::size_t i = 0; i + 1 < rings.size(); ++i) join(mesh, corners, i, i + 1);
  cap(mesh, corners, 0, true);
  cap(mesh, corners, rings.size() - 1, false);
  orientOutwards(mesh);
  return mesh;
}

Mesh loop(const std::vector<Ring>& rings) {
  Mesh mesh = pointsOf(rings);
  for (std::size_t i = 0; i < rings.size(); ++i) {
    join(mesh, rings.front().size(), i, (i + 1) % rings.size());
  }
  orientOutwards(mesh);
  return mesh;
}

Ring circle(QVector3D centre, QVector3D across, QVector3D up, float radius, int corners) {
  Ring ring;
  for (int i = 0; i < corners; ++i) {
    const float angle = kTurn * static_cast<float>(i) / static_cast<float>(corners);
    ring.push_back(centre + radius * (std::cos(angle) * across + std::sin(angle) * up));
  }
  return ring;
}

Ring slab(float x, float low, float high, float half, float rounding) {
  constexpr int kPerCorner = 4;
  const float r = std::min({rounding, half, (high - low) / 2.0F});
  Ring ring;
  for (int corner = 0; corner < 4; ++corner) {
    const float y = corner < 2 ? high - r : low + r;
    const float z = corner == 0 || corner == 3 ? half - r : r - half;
    for (int i = 0; i <= kPerCorner; ++i) {
      const float angle =
          kTurn / 4.0F * (static_cast<float>(corner) + static_cast<float>(i) / kPerCorner);
      ring.push_back({x, y + r * std::sin(angle), z + r * std::cos(angle)});
    }
  }
  return ring;
}

Mesh rod(float from, float to, float radius, int corners) {
  constexpr float kLongest = 5.0F;  // short enough for light to vary along the rod
  const int steps = 1 + static_cast<int>(std::abs(to - from) / kLongest);
  std::vector<Ring> rings;
  for (int i = 0; i <= steps; ++i) {
    const float x = from + (to - from) * static_cast<float>(i) / static_cast<float>(steps);
    rings.push_back(circle({x, 0, 0}, {0, 1, 0}, {0, 0, 1}, radius, corners));
  }
  return loft(rings);
}

Mesh bentTube(const std::vector<QVector3D>& path, const std::vector<float>& radii) {
  constexpr int kPerPoint = 6;
  const auto last = static_cast<int>(path.size()) - 1;
  const QVector3D out(0, 0, 1);
  std::vector<Ring> rings;
  for (int step = 0; step <= kPerPoint * last; ++step) {
    const float at = static_cast<float>(step) / kPerPoint;
    const auto [middle, along] = onCurve(path, at);
    const auto i = static_cast<std::size_t>(std::min(step / kPerPoint, last - 1));
    const float radius = radii[i] + (at - static_cast<float>(i)) * (radii[i + 1] - radii[i]);
    rings.push_back(
        circle(middle, QVector3D::crossProduct(along, out).normalized(), out, radius, 20));
  }
  return loft(rings);
}

Mesh fingerRing(QVector3D centre, float radius, float thickness) {
  constexpr int kRings = 40;
  std::vector<Ring> rings;
  for (int i = 0; i < kRings; ++i) {
    const float angle = kTurn * static_cast<float>(i) / kRings;
    const QVector3D out(std::cos(angle), std::sin(angle), 0.0F);
    rings.push_back(circle(centre + radius * out, out, {0, 0, 1}, thickness, 16));
  }
  return loop(rings);
}

Mesh plate(const std::vector<QVector2D>& outline, float from, float to, float bevel) {
  QVector2D middle;
  for (const auto& corner : outline) middle += corner / static_cast<float>(outline.size());
  const auto ringAt = [&](float z, float inset) {
    Ring ring;
    for (const auto& corner : outline) {
      const QVector2D away = corner - middle;
      const QVector2D place = middle + away * (1.0F - inset / std::max(away.length(), inset));
      ring.emplace_back(place.x(), place.y(), z);
    }
    return ring;
  };
  return loft(
      {ringAt(from, bevel),
       ringAt(from + bevel, 0.0F),
       ringAt(to - bevel, 0.0F),
       ringAt(to, bevel)});
}

Mesh turned(const std::vector<QVector2D>& profile, int corners) {
  std::vector<Ring> rings;
  for (const auto& place : profile) {
    rings.push_back(circle({0, 0, place.y()}, {1, 0, 0}, {0, 1, 0}, place.x(), corners));
  }
  return loft(rings);
}

Mesh sheet(const std::vector<QVector3D>& places, int columns) {
  Mesh mesh;
  for (const auto& place : places) mesh.vertices.push_back({place, {}, {}});
  const auto wide = static_cast<std::size_t>(columns);
  const std::size_t rows = places.size() / wide;
  for (std::size_t row = 0; row + 1 < rows; ++row) {
    for (std::size_t column = 0; column + 1 < wide; ++column) {
      const auto a = asIndex(row * wide + column);
      const auto d = asIndex((row + 1) * wide + column);
      mesh.triangles.push_back({a, a + 1, d + 1});
      mesh.triangles.push_back({a, d + 1, d});
    }
  }
  smoothen(mesh);
  return mesh;
}

}  // namespace study::gui::scene
