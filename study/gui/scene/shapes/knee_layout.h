#pragma once

#include <QMatrix4x4>
#include <QVector3D>

namespace study::gui::scene {

/// Where things lie in the knee that we draw: x to the right, y up, the shin's plateau below, the
/// meniscus as a crescent behind, its horns towards the eye [mm].
struct KneeLayout {
  QVector3D arcCentre{0.0F, 0.0F, -2.0F};  ///< of the crescent
  float innerRadius = 13.0F;               ///< its free edge [mm]
  float outerRadius = 23.0F;
  float halfAngle = 118.0F;  ///< of the crescent, to either side of −z [°]
  float toolAngle = 12.0F;   ///< where the punch bites, to the right of −z [°]
  float heldAngle = 140.0F;  ///< over which the string of finite elements lies [°]
};

/// The place @p radius from the arc's centre, @p angle [°] to the right of −z, at height 0.
QVector3D onArc(const KneeLayout& layout, float angle, float radius);

/// The height of the shin's plateau.
float plateauHeight(float x, float z);

/// Where the punch bites: on its lower jaw, at the tissue.
QVector3D punchMouth(const KneeLayout& layout);

/// Where the punch is: from its own frame to the knee's.
QMatrix4x4 punchPose(const KneeLayout& layout);

}  // namespace study::gui::scene
