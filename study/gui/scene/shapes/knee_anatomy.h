#pragma once

#include <optional>
#include <string>

#include <QMatrix4x4>
#include <QVector3D>

#include "protocols/reading/anatomy_file.h"
#include "study/gui/scene/shapes/mesh.h"

namespace study::gui::scene {

/// Positions in the built-in knee. x points to the right and y up. The tibial plateau is below, and
/// the meniscus behind it is a crescent whose horns point to the eye [mm].
struct KneeLayout {
  QVector3D arcCentre{0.0F, 0.0F, -2.0F};  ///< of the crescent
  float innerRadius = 13.0F;               ///< the free edge [mm]
  float outerRadius = 23.0F;
  float halfAngle = 118.0F;  ///< of the crescent, to each side of −z [°]
  float toolAngle = 12.0F;   ///< position of the punch's bite, to the right of −z [°]
  float heldAngle = 140.0F;  ///< angle spanned by the string of finite elements [°]
};

/// The point at distance @p radius [mm] from the arc's centre, @p angle [°] to the right of −z, at
/// y = 0.
QVector3D pointOnArc(const KneeLayout& layout, float angle, float radius);

/// The height of the tibial plateau [mm].
float plateauHeight(float x, float z);

/// The position of the bite: on the punch's lower jaw, at the tissue [mm].
QVector3D punchMouth(const KneeLayout& layout);

/// The pose of the punch: from its own frame to the knee's.
QMatrix4x4 punchPose(const KneeLayout& layout);

/// The colours of cartilage and synovium on surfaces without their own colours.
inline constexpr Tint kCartilage{232, 223, 207, 205};
inline constexpr Tint kSynovium{210, 122, 108, 165};

/// The built-in surfaces around the meniscus: cartilage below and above, and the joint capsule
/// behind.
Mesh plateauSurface(const KneeLayout& layout);
Mesh condyleSurface();
Mesh capsuleSurface(const KneeLayout& layout);

/// The surfaces around the meniscus.
struct KneeSurfaces {
  Mesh tibia;
  Mesh femur;
  Mesh capsule;
};

/// The built-in surfaces, each replaced by the surface of the same name in @p own if there is one.
/// A surface without colours gets the built-in colour.
KneeSurfaces kneeSurfaces(const KneeLayout& layout, const protocols::Anatomy* own);

/// The built-in knee as an OBJ file, in the frame and unit of protocols::Anatomy. Users fit their
/// anatomies to it. It contains meniscus and punch for orientation.
std::string kneeAsObj(const KneeLayout& layout);

}  // namespace study::gui::scene
