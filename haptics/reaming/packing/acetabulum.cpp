#include "haptics/reaming/packing/acetabulum.h"

#include <numbers>
#include <stdexcept>

namespace haptics::reaming {

Acetabulum::Acetabulum(double inner, double outer) : inner_(inner), outer_(outer) {
  if (!(inner >= 0.0 && inner < outer && outer <= 1.0)) {
    throw std::invalid_argument("the radii of an acetabulum: 0 ≤ inner < outer ≤ 1 m");
  }
}

Boundary Acetabulum::nearest(Vec3 place) const noexcept {
  const double radius = length(place);
  const Vec3 outward = radius > 0.0 ? (1.0 / radius) * place : Vec3{0.0, 0.0, 1.0};
  Boundary found{place.z, {0.0, 0.0, 1.0}};
  if (outer_ - radius < found.distance) found = {outer_ - radius, -1.0 * outward};
  if (inner_ > 0.0 && radius - inner_ < found.distance) found = {radius - inner_, outward};
  return found;
}

double Acetabulum::volume() const noexcept {
  return 2.0 / 3.0 * std::numbers::pi * (outer_ * outer_ * outer_ - inner_ * inner_ * inner_);
}

}  // namespace haptics::reaming
