#pragma once

#include "study/gui/scene/shapes/mesh.h"

namespace study::gui::scene {

/// An arthroscopic punch of our own making, in a frame of its own: the jaw's hinge at the origin,
/// its tip along x, its upper jaw along y [mm].
struct PunchShape {
  Mesh body;   ///< shaft and lower jaw
  Mesh grip;   ///< the handle that stays
  Mesh jaw;    ///< the upper jaw
  Mesh rod;    ///< that moves it, along the shaft
  Mesh lever;  ///< the handle that is moved
};

PunchShape punchShape();

/// Where its moving parts are. @param openness  1: handles apart, jaw open; 0: closed.
QMatrix4x4 jawPose(float openness);
QMatrix4x4 rodPose(float openness);
QMatrix4x4 leverPose(float openness);

/// How far its jaws reach beyond the hinge, and half their width [mm].
inline constexpr float kJawLength = 9.0F;
inline constexpr float kJawHalfWidth = 1.45F;

/// The height of the upper jaw's edge above the lower jaw at @p x from the hinge [mm].
float jawHeight(float openness, float x);

/// An acetabular reamer of our own making: half a sphere of @p radius [mm] around the origin with
/// its teeth towards +z, on a shaft along −z.
struct ReamerShape {
  Mesh cap;    ///< spins; closed but for its teeth, which are closed each
  Mesh shaft;  ///< spins
};

ReamerShape reamerShape(float radius);

}  // namespace study::gui::scene
