#include "study/gui/scene/shapes/noise.h"

#include <cmath>
#include <cstdint>

namespace study::gui::scene {
namespace {

/// A pseudo-random number in [−1, 1] for a point of the lattice.
float latticeNoise(std::int32_t x, std::int32_t y, std::int32_t z) {
  auto mixed = static_cast<std::uint32_t>(x) * 0x8da6b343U ^
               static_cast<std::uint32_t>(y) * 0xd8163841U ^
               static_cast<std::uint32_t>(z) * 0xcb1ab31fU;
  mixed = (mixed ^ (mixed >> 15U)) * 0x2c1b3c6dU;
  mixed = (mixed ^ (mixed >> 12U)) * 0x297a2d39U;
  mixed ^= mixed >> 15U;
  return static_cast<float>(mixed & 0xffffU) / 32767.5F - 1.0F;
}

float mixed(float from, float to, float share) {
  return from + share * (to - from);
}

}  // namespace

float noiseAt(QVector3D place) {
  const QVector3D low(std::floor(place.x()), std::floor(place.y()), std::floor(place.z()));
  const auto x = static_cast<std::int32_t>(low.x());
  const auto y = static_cast<std::int32_t>(low.y());
  const auto z = static_cast<std::int32_t>(low.z());
  QVector3D share = place - low;
  share *= share * (QVector3D(3.0F, 3.0F, 3.0F) - 2.0F * share);
  const auto alongX = [&](std::int32_t j, std::int32_t k) {
    return mixed(latticeNoise(x, j, k), latticeNoise(x + 1, j, k), share.x());
  };
  const auto alongY = [&](std::int32_t k) {
    return mixed(alongX(y, k), alongX(y + 1, k), share.y());
  };
  return mixed(alongY(z), alongY(z + 1), share.z());
}

float roughnessAt(QVector3D place, int octaves) {
  float sum = 0.0F;
  float weight = 0.5F;
  for (int i = 0; i < octaves; ++i, weight *= 0.5F) {
    sum += weight * noiseAt(place);
    place *= 2.0F;
  }
  return sum;
}

}  // namespace study::gui::scene
