#include "haptics/reaming/bone/plunge.h"

#include <limits>
#include <stdexcept>

namespace haptics::reaming {

Plunge plungeInto(const SphereField& field, double radius) {
  // A sphere is first touched, teeth foremost, where the reamer's centre is √((R+r)² − ρ²) before
  // it, ρ its distance from the axis.
  double start = std::numeric_limits<double>::infinity();
  for (std::size_t slot = 0; slot < field.slotCount(); ++slot) {
    const double r = field.group(slot).radius[slot % kLanes];
    if (!(r > 0.0)) continue;
    const Vec3 c = field.centre(slot);
    const double square = (radius + r) * (radius + r) - c.x * c.x - c.y * c.y;
    if (square >= 0.0) start = std::min(start, c.z - std::sqrt(square));
  }
  if (!std::isfinite(start)) {
    throw std::invalid_argument(
        "the reamer passes beside the bone: turn and move the mesh so that +z through its origin "
        "goes into the cup");
  }
  constexpr double kBefore = 1e-5;  // [m]
  return {radius, start - kBefore};
}

}  // namespace haptics::reaming
