#pragma once

#include <vector>

#include <QVector2D>

#include "study/gui/scene/shapes/mesh.h"

namespace study::gui::scene {

/// Places around something, in order, the last followed by the first.
using Ring = std::vector<QVector3D>;

/// A body through @p rings, all of one size, closed at either end; turned so that it holds
/// something, whatever way the rings run.
Mesh loft(const std::vector<Ring>& rings);

/// The same, the last ring followed by the first: a torus, say.
Mesh loop(const std::vector<Ring>& rings);

/// A circle of @p radius [mm] around @p centre, in the plane that @p across and @p up (unit
/// vectors) span.
Ring circle(QVector3D centre, QVector3D across, QVector3D up, float radius, int corners = 24);

/// A rectangle with round corners at @p x, from @p low to @p high along y, and as wide as
/// 2 · @p half along z [mm].
Ring slab(float x, float low, float high, float half, float rounding);

/// A tube of @p radius along the x axis, from @p from to @p to [mm].
Mesh rod(float from, float to, float radius, int corners = 24);

/// A tube whose middle follows @p path, which lies in the plane of x and y.
Mesh bent(const std::vector<QVector3D>& path, const std::vector<float>& radii);

/// A ring to put a finger through, in the plane of x and y [mm].
Mesh eyelet(QVector3D centre, float radius, float thickness);

/// What a profile (x: distance from the axis, y: height) draws when it is turned around the z axis.
/// It begins and ends on the axis.
Mesh turned(const std::vector<QVector2D>& profile, int corners = 64);

/// A sheet of @p columns × @p rows places (at least two each), in the order of @p places: row by
/// row. Not closed. Seen from where columns run to the right and rows run up, it is in front.
Mesh sheet(const std::vector<QVector3D>& places, int columns);

}  // namespace study::gui::scene
