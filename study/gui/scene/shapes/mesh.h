#pragma once

#include <cstdint>
#include <vector>

#include <QMatrix4x4>
#include <QVector3D>

namespace study::gui::scene {

/// A colour as it is drawn; gloss says how wet or polished a surface looks (0 dull, 255 mirror).
struct Tint {
  std::uint8_t red = 255;
  std::uint8_t green = 255;
  std::uint8_t blue = 255;
  std::uint8_t gloss = 60;
};

/// @p share of the way from @p a to @p b, in [0, 1].
Tint blend(Tint a, Tint b, float share);
/// @p tint, so much brighter: > 0.
Tint lit(Tint tint, float brightness);

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

/// Adds @p more to @p mesh.
void append(Mesh& mesh, const Mesh& more);

/// Turns and moves all of @p mesh.
void place(Mesh& mesh, const QMatrix4x4& pose);

void paint(Mesh& mesh, Tint tint);

/// Gives every vertex the normal of the triangles that share it.
void smoothen(Mesh& mesh);

/// Gives every corner the normal of those triangles around its place that meet its own at less
/// than @p angle [°]: round things look round, and edges stay edges.
void crease(Mesh& mesh, float angle);

/// Edges without a neighbour that runs the other way, places being the same within a micrometre.
/// A closed surface has none.
std::size_t openEdges(const Mesh& mesh);

/// What a closed surface holds [mm³]; below 0 where it is inside out.
double volumeOf(const Mesh& mesh);

}  // namespace study::gui::scene
