#include "study/gui/scene/scene.h"

#include <algorithm>
#include <cmath>

namespace study::gui::scene {

std::array<ContactShadow, 2> inEyeFrame(std::array<ContactShadow, 2> shadows, const Shot& shot) {
  for (auto& shadow : shadows) {
    shadow.from = shot.view.map(shadow.from);
    shadow.along = shot.view.mapVector(shadow.along);
  }
  return shadows;
}

QRect placeOf(const Shot& shot, QSize size) {
  const QRectF place = shot.placeIn(size);
  const double aspect = shot.isRound ? 1.0 : shot.aspect;
  if (aspect <= 0.0) return place.toRect();
  const double height = std::min(place.height(), place.width() / aspect);
  QRectF fitting(0.0, 0.0, aspect * height, height);
  fitting.moveCenter(place.center());
  return fitting.toRect();
}

QMatrix4x4 projectionOf(const Shot& shot, QSize place) {
  constexpr float kHalfDegree = 3.14159265F / 360.0F;
  const auto wide = static_cast<float>(std::max(place.width(), 1));
  const auto high = static_cast<float>(std::max(place.height(), 1));
  const float smaller = std::min(wide, high);
  const float reach = shot.nearest * std::tan(kHalfDegree * shot.fieldOfView) / smaller;
  QMatrix4x4 projection;
  projection.frustum(
      -reach * wide, reach * wide, -reach * high, reach * high, shot.nearest, shot.farthest);
  return projection;
}

}  // namespace study::gui::scene
