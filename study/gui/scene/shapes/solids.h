#pragma once

#include <vector>

#include <QVector2D>

#include "study/gui/scene/shapes/mesh.h"

namespace study::gui::scene {

/// A closed sequence of points: the last is followed by the first.
using Ring = std::vector<QVector3D>;

/// A body through @p rings of equal size, closed at both ends. Triangles face outwards, whatever
/// the direction of the rings.
Mesh loft(const std::vector<Ring>& rings);

/// A body through @p rings whose last ring is followed by the first, for example a torus.
Mesh loop(const std::vector<Ring>& rings);

/// A circle of @p radius [mm] around @p centre, in the plane of the unit vectors @p across and @p
/// up.
Ring circle(QVector3D centre, QVector3D across, QVector3D up, float radius, int corners = 24);

/// A rectangle with rounded corners at @p x, from @p low to @p high along y and from −@p half to @p
/// half along z [mm].
Ring slab(float x, float low, float high, float half, float rounding);

/// A tube of @p radius along the x axis, from @p from to @p to [mm].
Mesh rod(float from, float to, float radius, int corners = 24);

/// A tube along a smooth curve through @p path, which lies in the x-y plane [mm].
Mesh bentTube(const std::vector<QVector3D>& path, const std::vector<float>& radii);

/// A finger ring in the x-y plane [mm].
Mesh fingerRing(QVector3D centre, float radius, float thickness);

/// A plate from z = @p from to z = @p to, with edges bevelled by @p bevel [mm]. Its @p outline in
/// the x-y plane is star-shaped: a straight line from its middle to any of its corners lies inside.
Mesh plate(const std::vector<QVector2D>& outline, float from, float to, float bevel);

/// The solid of revolution of a profile (x: distance from the axis, y: height) around the z axis.
/// The profile must begin and end on the axis.
Mesh turned(const std::vector<QVector2D>& profile, int corners = 64);

/// A surface of @p columns × rows points (at least two each), given row by row in @p places. It is
/// not closed. Its front is the side from which columns run to the right and rows run up.
Mesh sheet(const std::vector<QVector3D>& places, int columns);

/// A sheet over (u, v) in [0, 1]², row by row, with a colour for each point.
template <typename Place, typename Paint>
Mesh surface(int columns, int rows, Place placeOf, Paint tintOf) {
  std::vector<QVector3D> places;
  std::vector<Tint> tints;
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      const float u = static_cast<float>(column) / static_cast<float>(columns - 1);
      const float v = static_cast<float>(row) / static_cast<float>(rows - 1);
      places.push_back(placeOf(u, v));
      tints.push_back(tintOf(u, v, places.back()));
    }
  }
  Mesh mesh = sheet(places, columns);
  for (std::size_t i = 0; i < tints.size(); ++i) mesh.vertices[i].tint = tints[i];
  return mesh;
}

}  // namespace study::gui::scene
