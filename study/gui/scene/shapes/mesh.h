#pragma once

#include <cstdint>
#include <vector>

#include <QMatrix4x4>
#include <QVector3D>

namespace study::gui::scene {

/// A colour and the gloss of a surface (0: matt, 255: mirror).
struct Tint {
  std::uint8_t red = 255;
  std::uint8_t green = 255;
  std::uint8_t blue = 255;
  std::uint8_t gloss = 60;
};

/// The colour at @p share of the way from @p a to @p b, in [0, 1].
Tint blend(Tint a, Tint b, float share);
/// The colour @p tint times @p brightness, > 0.
Tint shaded(Tint tint, float brightness);

struct Vertex {
  QVector3D position;  ///< [mm]
  QVector3D normal;    ///< unit vector, outwards
  Tint tint;
};

struct Triangle {
  std::uint32_t a = 0;  ///< counterclockwise, seen from outside
  std::uint32_t b = 0;
  std::uint32_t c = 0;
};

/// A surface of triangles.
struct Mesh {
  std::vector<Vertex> vertices;
  std::vector<Triangle> triangles;
};

/// Appends @p more to @p mesh.
void append(Mesh& mesh, const Mesh& more);

/// Transforms all of @p mesh by @p pose.
void place(Mesh& mesh, const QMatrix4x4& pose);

void paint(Mesh& mesh, Tint tint);

/// Sets each vertex's normal to the area-weighted mean of the triangles that share it.
void smoothen(Mesh& mesh);

/// Sets each corner's normal to the area-weighted mean of the triangles at its position whose angle
/// to its own triangle is less than @p angle [°]. Round surfaces look round and edges stay sharp.
void crease(Mesh& mesh, float angle);

/// The part of @p mesh that the eye of @p view may see: the triangles within a cone of half @p
/// field [°] around its axis. Other triangles are left out, as are vertices without a triangle.
Mesh visiblePart(const Mesh& mesh, const QMatrix4x4& view, float field);

/// The volume of a closed surface [mm³]; negative if its triangles face inwards.
double volumeOf(const Mesh& mesh);

}  // namespace study::gui::scene
