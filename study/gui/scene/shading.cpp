#include "study/gui/scene/shading.h"

#include <algorithm>
#include <cmath>

namespace study::gui::scene {
namespace {

constexpr float kBehind = -0.25F;
constexpr float kNearLamp = 2.1F;  // how bright a lamp is that things are close to
constexpr float kFarLamp = 1.05F;
constexpr float kShine = 0.85F;
constexpr float kDullest = 0.85F;  // gloss from which on it is metal
constexpr float kMetals = 10.0F;

/// What polished steel shows of what is around it, [0, 1]: light above and below, less
/// between.
float around(QVector3D normal, QVector3D toEye) {
  const float up = 2.0F * QVector3D::dotProduct(normal, toEye) * normal.y() - toEye.y();
  const float square = up * up;
  return (0.25F + 0.75F * square / (square + 0.12F)) * (up > 0.0F ? 1.0F : 0.75F);
}

/// To the 16th power.
float sixteenth(float x) {
  const float fourth = x * x * x * x;
  return fourth * fourth * fourth * fourth;
}

}  // namespace

Brightness brightnessOf(const Light& light, QVector3D place, QVector3D normal, float gloss) {
  const QVector3D toEye = -place.normalized();
  // A sheet may be seen from behind; a round body just turns away at its edge.
  if (QVector3D::dotProduct(normal, toEye) < kBehind) normal = -normal;
  const bool isNear = light.reach > 0.0F;
  const QVector3D way = isNear ? light.place - place : light.place;
  const float distance = way.length();
  const QVector3D toLamp = way / distance;
  const float share = isNear ? distance / light.reach : 0.0F;
  const float power = isNear ? kNearLamp / (1.0F + share * share) : kFarLamp;
  const float facing = std::max(0.0F, QVector3D::dotProduct(normal, toLamp));
  const float mirrored =
      std::max(0.0F, QVector3D::dotProduct(normal, (toLamp + toEye).normalized()));
  const float sharp = sixteenth(mirrored);
  const float sharper = sharp * sharp * sharp * sharp;
  const float shine = kShine * gloss * gloss * (sharp + gloss * (sharper - sharp));
  // What comes from everywhere comes a little more from above.
  const float ambient = light.ambient * (1.0F + 0.5F * normal.y());
  const float diffuse = ambient + power * facing;
  const float metal = std::clamp(kMetals * (gloss - kDullest), 0.0F, 1.0F);
  const float steel = ambient + power * (0.35F * facing + 0.6F * around(normal, toEye));
  return {diffuse + metal * (steel - diffuse), power * shine};
}

float vignette(float radius) {
  const float square = radius * radius;
  const float edge = std::clamp((1.0F - square) / 0.024F, 0.0F, 1.0F);
  return edge * (1.0F - 0.5F * square * square);
}

}  // namespace study::gui::scene
