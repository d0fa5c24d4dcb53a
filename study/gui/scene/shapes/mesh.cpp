#include "study/gui/scene/shapes/mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

namespace study::gui::scene {
namespace {

using PlaceKey = std::array<std::int64_t, 3>;

PlaceKey keyOf(const QVector3D& v) {
  constexpr double kPerMillimetre = 1000.0;
  return {
      std::llround(kPerMillimetre * static_cast<double>(v.x())),
      std::llround(kPerMillimetre * static_cast<double>(v.y())),
      std::llround(kPerMillimetre * static_cast<double>(v.z()))};
}

/// An index for each vertex, the same for vertices at the same position.
std::vector<std::uint32_t> weldedIndices(const Mesh& mesh) {
  std::map<PlaceKey, std::uint32_t> places;
  std::vector<std::uint32_t> place;
  place.reserve(mesh.vertices.size());
  for (const auto& vertex : mesh.vertices) {
    const auto next = static_cast<std::uint32_t>(places.size());
    place.push_back(places.emplace(keyOf(vertex.position), next).first->second);
  }
  return place;
}

/// The triangle's normal, with its length proportional to the area.
QVector3D normalOf(const Mesh& mesh, const Triangle& t) {
  const QVector3D& a = mesh.vertices[t.a].position;
  return QVector3D::crossProduct(mesh.vertices[t.b].position - a, mesh.vertices[t.c].position - a);
}

std::uint8_t asByte(float value) {
  return static_cast<std::uint8_t>(std::clamp(std::lround(value), 0L, 255L));
}

}  // namespace

Tint blend(Tint a, Tint b, float share) {
  const auto mix = [share](std::uint8_t from, std::uint8_t to) {
    return asByte(static_cast<float>(from) * (1.0F - share) + static_cast<float>(to) * share);
  };
  return {mix(a.red, b.red), mix(a.green, b.green), mix(a.blue, b.blue), mix(a.gloss, b.gloss)};
}

Tint shaded(Tint tint, float brightness) {
  const auto scale = [brightness](std::uint8_t c) {
    return asByte(static_cast<float>(c) * brightness);
  };
  return {scale(tint.red), scale(tint.green), scale(tint.blue), tint.gloss};
}

void append(Mesh& mesh, const Mesh& more) {
  const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
  mesh.vertices.insert(mesh.vertices.end(), more.vertices.begin(), more.vertices.end());
  for (const auto& t : more.triangles) {
    mesh.triangles.push_back({first + t.a, first + t.b, first + t.c});
  }
}

void place(Mesh& mesh, const QMatrix4x4& pose) {
  for (auto& vertex : mesh.vertices) {
    vertex.position = pose.map(vertex.position);
    vertex.normal = pose.mapVector(vertex.normal).normalized();
  }
}

void paint(Mesh& mesh, Tint tint) {
  for (auto& vertex : mesh.vertices) vertex.tint = tint;
}

void smoothen(Mesh& mesh) {
  for (auto& vertex : mesh.vertices) vertex.normal = {};
  for (const auto& t : mesh.triangles) {
    const QVector3D normal = normalOf(mesh, t);
    for (const auto corner : {t.a, t.b, t.c}) mesh.vertices[corner].normal += normal;
  }
  for (auto& vertex : mesh.vertices) vertex.normal.normalize();
}

void crease(Mesh& mesh, float angle) {
  const auto place = weldedIndices(mesh);
  std::vector<QVector3D> normals;
  std::map<std::uint32_t, std::vector<std::size_t>> around;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const auto& t = mesh.triangles[i];
    normals.push_back(normalOf(mesh, t));
    for (const auto corner : {t.a, t.b, t.c}) around[place[corner]].push_back(i);
  }
  constexpr float kDegree = 3.14159265F / 180.0F;
  const float least = std::cos(kDegree * angle);
  Mesh creased;
  // Corners of one vertex with the same normal stay one vertex.
  std::map<std::pair<std::uint32_t, PlaceKey>, std::uint32_t> kept;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const QVector3D own = normals[i].normalized();
    const auto& t = mesh.triangles[i];
    const auto creasedCorner = [&](std::uint32_t corner) {
      QVector3D sum;
      for (const auto j : around[place[corner]]) {
        if (QVector3D::dotProduct(own, normals[j].normalized()) >= least) sum += normals[j];
      }
      const QVector3D normal = sum.isNull() ? own : sum.normalized();
      const auto next = static_cast<std::uint32_t>(creased.vertices.size());
      const auto [at, isNew] = kept.emplace(std::pair(corner, keyOf(normal)), next);
      if (isNew) {
        creased.vertices.push_back(mesh.vertices[corner]);
        creased.vertices.back().normal = normal;
      }
      return at->second;
    };
    const auto a = creasedCorner(t.a);
    const auto b = creasedCorner(t.b);
    creased.triangles.push_back({a, b, creasedCorner(t.c)});
  }
  mesh = std::move(creased);
}

Mesh visiblePart(const Mesh& mesh, const QMatrix4x4& view, float field) {
  // A triangle is outside if all of its corners are beyond one of the planes around the cone.
  constexpr std::uint32_t kPlanes = 12;
  constexpr float kTurn = 6.2831853F;
  const float widest = std::tan(kTurn * field / 360.0F);
  std::vector<std::uint32_t> beyond;
  for (const auto& vertex : mesh.vertices) {
    const QVector3D at = view.map(vertex.position);
    beyond.push_back(0);
    for (std::uint32_t i = 0; i < kPlanes; ++i) {
      const float angle = kTurn * static_cast<float>(i) / kPlanes;
      const bool isBeyond =
          std::cos(angle) * at.x() + std::sin(angle) * at.y() + widest * at.z() > 0.0F;
      if (isBeyond) beyond.back() |= 1U << i;
    }
  }
  Mesh seen;
  constexpr std::uint32_t kNone = ~0U;
  std::vector<std::uint32_t> moved(mesh.vertices.size(), kNone);
  const auto keep = [&](std::uint32_t corner) {
    if (moved[corner] == kNone) {
      moved[corner] = static_cast<std::uint32_t>(seen.vertices.size());
      seen.vertices.push_back(mesh.vertices[corner]);
    }
    return moved[corner];
  };
  for (const auto& t : mesh.triangles) {
    if ((beyond[t.a] & beyond[t.b] & beyond[t.c]) != 0) continue;
    const auto a = keep(t.a);
    const auto b = keep(t.b);
    seen.triangles.push_back({a, b, keep(t.c)});
  }
  return seen;
}

double volumeOf(const Mesh& mesh) {
  double sixfold = 0.0;
  for (const auto& t : mesh.triangles) {
    const QVector3D across =
        QVector3D::crossProduct(mesh.vertices[t.b].position, mesh.vertices[t.c].position);
    sixfold += static_cast<double>(QVector3D::dotProduct(mesh.vertices[t.a].position, across));
  }
  return sixfold / 6.0;
}

}  // namespace study::gui::scene
