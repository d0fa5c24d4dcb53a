#include "study/gui/scene/shapes/knee_layout.h"

#include <cmath>

namespace study::gui::scene {

QVector3D onArc(const KneeLayout& layout, float angle, float radius) {
  constexpr float kDegree = 3.14159265F / 180.0F;
  const float a = kDegree * angle;
  return layout.arcCentre + radius * QVector3D(std::sin(a), 0.0F, -std::cos(a));
}

float plateauHeight(float x, float z) {
  const float dz = z + 4.0F;
  return 0.0022F * (x * x + dz * dz) - 0.4F;
}

QVector3D punchMouth(const KneeLayout& layout) {
  constexpr float kBiteIn = 1.9F;  // from the free edge [mm]
  constexpr float kAbove = 1.25F;  // the plateau, of the lower jaw [mm]
  QVector3D mouth = onArc(layout, layout.toolAngle, layout.innerRadius + kBiteIn);
  mouth.setY(plateauHeight(mouth.x(), mouth.z()) + kAbove);
  return mouth;
}

QMatrix4x4 punchPose(const KneeLayout& layout) {
  constexpr float kReach = 5.6F;  // of the hinge from the bite [mm]
  const QVector3D along = QVector3D(-0.42F, -0.06F, -0.90F).normalized();
  const QVector3D across = QVector3D::crossProduct(along, {0, 1, 0}).normalized();
  const QVector3D up = QVector3D::crossProduct(across, along);
  const QVector3D hinge = punchMouth(layout) - kReach * along;
  return {
      along.x(),
      up.x(),
      across.x(),
      hinge.x(),  //
      along.y(),
      up.y(),
      across.y(),
      hinge.y(),  //
      along.z(),
      up.z(),
      across.z(),
      hinge.z(),  //
      0.0F,
      0.0F,
      0.0F,
      1.0F};
}

}  // namespace study::gui::scene
