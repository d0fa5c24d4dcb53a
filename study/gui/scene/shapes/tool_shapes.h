#pragma once

#include "study/gui/scene/shapes/mesh.h"

namespace study::gui::scene {

/// The built-in arthroscopic punch. In its frame the hinge of the jaw is at the origin, the tip
/// points along x, and the upper jaw is on the side of +y [mm].
struct PunchShape {
  Mesh body;   ///< shaft and lower jaw
  Mesh grip;   ///< the fixed handle
  Mesh jaw;    ///< the upper jaw
  Mesh rod;    ///< moves the jaw, along the shaft
  Mesh lever;  ///< the moving handle
};

PunchShape punchShape();

/// The poses of the moving parts. @param openness  1: handles apart, jaw open; 0: closed.
QMatrix4x4 jawPose(float openness);
QMatrix4x4 rodPose(float openness);
QMatrix4x4 leverPose(float openness);

/// The length of the jaws beyond the hinge, and half of their width [mm].
inline constexpr float kJawLength = 9.0F;
inline constexpr float kJawHalfWidth = 1.45F;

/// The height of the upper jaw's edge above the lower jaw, at @p x from the hinge [mm].
float jawHeight(float openness, float x);

}  // namespace study::gui::scene
