#pragma once

#include <cstdint>
#include <vector>

#include <QMatrix4x4>
#include <QRect>
#include <QSize>

#include "study/gui/scene/shapes/mesh.h"
#include "study/gui/scene/shapes/sphere_cloud.h"

namespace study::gui::scene {

/// A body in a scene, where it is now.
struct Part {
  Mesh mesh;
  QMatrix4x4 pose;
  std::uint64_t revision = 1;  ///< of the mesh: whoever keeps a copy looks whether it is old
  bool isShown = true;
};

/// Where the light comes from, seen from the eye.
struct Light {
  QVector3D place{2.0F, 3.0F, 0.0F};  ///< in front of the eye is −z [mm]
  float reach = 0.0F;    ///< half of it is left so far away [mm]; 0: the light is far, and even
  float ambient = 0.1F;  ///< that comes from everywhere, [0, 1]
};

/// One look at a scene: which part of the picture it fills, from where, and what is seen.
struct Shot {
  QRectF place{0.0, 0.0, 1.0, 1.0};  ///< in shares of the picture, from its upper left corner
  double aspect = 0.0;               ///< width by height, as large as it fits there; 0: all of it
  bool isRound = false;              ///< as through an arthroscope: a disc on black
  QMatrix4x4 view;                   ///< from the scene's frame to the eye's
  float fieldOfView = 40.0F;         ///< over the smaller side [°]
  float nearest = 1.0F;              ///< [mm]
  float farthest = 500.0F;           ///< [mm]
  Light light;
  Tint ground{0, 0, 0, 0};  ///< behind everything; a round look has none
  std::vector<std::size_t> parts;
  bool showsSpheres = false;
};

/// All that both renderers draw: bodies of triangles, spheres, and looks at them.
struct Scene {
  std::vector<Part> parts;
  SphereCloud* spheres = nullptr;  ///< nobody's here; nothing where there are none
  std::vector<Shot> shots;
};

/// Where @p shot is in a picture of @p size: a rectangle, as far as its aspect lets it fill
/// that; of a round look the square around the disc.
QRect placeOf(const Shot& shot, QSize size);

/// From the eye's frame to the square from −1 to 1, y up.
QMatrix4x4 projectionOf(const Shot& shot, QSize place);

}  // namespace study::gui::scene
