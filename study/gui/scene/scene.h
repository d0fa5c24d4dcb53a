#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <QMatrix4x4>
#include <QRect>
#include <QSize>

#include "study/gui/scene/shapes/mesh.h"
#include "study/gui/scene/shapes/sphere_cloud.h"

namespace study::gui::scene {

/// A body in a scene, with its current pose.
struct Part {
  Mesh mesh;
  QMatrix4x4 pose;
  std::uint64_t revision = 1;  ///< of the mesh; a renderer compares it with that of its copy
  bool isShown = true;
  bool isTool = false;  ///< a closed surface, not darkened by the tool's own shadow
};

/// The soft shadow of a tool on what it nearly touches: surfaces are darker the closer they are to
/// a rod with round ends. In the scene's frame [mm].
struct ContactShadow {
  QVector3D from;       ///< one end of the rod's axis
  QVector3D along;      ///< to the other one; a sphere if it is 0
  float radius = 0.0F;  ///< of the rod
  float reach = 1.0F;   ///< distance at which the shadow ends
  float depth = 0.0F;   ///< share of light that is lost at the rod; 0: no shadow
};

/// A lamp, in the eye's frame.
struct Light {
  QVector3D place{2.0F, 3.0F, 0.0F};  ///< the eye looks along −z [mm]
  float reach = 0.0F;    ///< distance at which half of the light is left [mm]; 0: a distant lamp of
                         ///< constant brightness
  float power = 1.05F;   ///< brightness of what faces the lamp, at the lamp if it is near
  float ambient = 0.1F;  ///< light from all directions, [0, 1]
};

/// All of a picture of @p size [px].
inline QRectF wholePicture(QSizeF size) {
  return {QPointF(), size};
}

/// One view of a scene: its place in the picture, its camera, and what it shows.
struct Shot {
  QRectF (*placeIn)(QSizeF picture) = wholePicture;  ///< where it lies in a picture of that size
  double aspect = 0.0;        ///< width by height, as large as fits into its place; 0: all of it
  bool isRound = false;       ///< a disc, as through an arthroscope
  QMatrix4x4 view;            ///< from the scene's frame to the eye's
  float fieldOfView = 40.0F;  ///< across the smaller side [°]
  float nearest = 1.0F;       ///< [mm]
  float farthest = 500.0F;    ///< [mm]
  Light light;
  std::vector<std::size_t> parts;
  bool showsSpheres = false;
};

/// What a renderer draws: bodies of triangles, spheres, and the views of them.
struct Scene {
  std::vector<Part> parts;
  Tint ground{30, 33, 36, 0};            ///< the background
  std::array<ContactShadow, 2> shadows;  ///< of two tools, or of two parts of one
  SphereCloud* spheres = nullptr;        ///< not owned; nullptr: no spheres
  std::vector<Shot> shots;
};

/// @p shadows in the eye's frame of @p shot.
std::array<ContactShadow, 2> inEyeFrame(std::array<ContactShadow, 2> shadows, const Shot& shot);

/// The rectangle of @p shot in a picture of @p size [px], with the shot's aspect ratio; for a round
/// view the square around the disc.
QRect placeOf(const Shot& shot, QSize size);

/// The perspective projection from the eye's frame to [−1, 1], with y up.
QMatrix4x4 projectionOf(const Shot& shot, QSize place);

}  // namespace study::gui::scene
