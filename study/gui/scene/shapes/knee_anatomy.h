#pragma once

#include <optional>
#include <string>

#include <QMatrix4x4>
#include <QVector3D>

#include "protocols/reading/anatomy_file.h"
#include "study/gui/scene/shapes/mesh.h"

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

/// How cartilage and a joint's capsule look where they are not painted more finely.
inline constexpr Tint kCartilage{238, 231, 216, 205};
inline constexpr Tint kSynovium{170, 78, 70, 130};

/// What surrounds the meniscus, as plain curved sheets: cartilage below and above, the joint's
/// capsule behind.
Mesh plateauSurface(const KneeLayout& layout);
Mesh condyleSurface();
Mesh capsuleSurface(const KneeLayout& layout);

/// What surrounds the meniscus.
struct KneeSurfaces {
  Mesh tibia;
  Mesh femur;
  Mesh capsule;
};

/// Surfaces of our own making, and in their place those that @p own has, if there is one. A surface
/// without colours is painted as ours is.
KneeSurfaces kneeSurfaces(const KneeLayout& layout, const protocols::Anatomy* own);

/// Our own knee as an OBJ file's text, in the frame and the unit that protocols::Anatomy has: what
/// anatomies can be fitted to. Meniscus and punch are in it for orientation.
std::string kneeAsObj(const KneeLayout& layout);

}  // namespace study::gui::scene
