#include "haptics/bench/tiled_bone.h"

#include <algorithm>
#include <cmath>

#include "haptics/reaming/packing/acetabulum.h"
#include "haptics/reaming/packing/packing_builder.h"

namespace haptics::bench {
namespace {

using reaming::Boundary;
using reaming::Vec3;

/// The cube from the origin to (1, 1, 1), in decimetres or whatever.
class Cube final : public reaming::Solid {
 public:
  Boundary nearest(Vec3 p) const noexcept override {
    const double all[]{p.x, 1.0 - p.x, p.y, 1.0 - p.y, p.z, 1.0 - p.z};
    const Vec3 inward[]{{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
    const auto best = static_cast<std::size_t>(std::min_element(all, all + 6) - all);
    return {all[best], inward[best]};
  }
  Vec3 lowest() const noexcept override { return {}; }
  Vec3 highest() const noexcept override { return {1.0, 1.0, 1.0}; }
  double volume() const noexcept override { return 1.0; }
};

}  // namespace

reaming::Packing tiledBone(std::size_t count) {
  constexpr std::size_t kTile = 3000;
  static const auto tile = *reaming::pack(Cube(), {.count = kTile});
  const reaming::Acetabulum cup;
  reaming::Packing packing{.spheres = {}, .volume = cup.volume()};
  // A little more than wanted; the smallest of the last are left out.
  const double edge =
      std::cbrt(1.0 * static_cast<double>(kTile) * cup.volume() / static_cast<double>(count));
  const Vec3 low = cup.lowest();
  const Vec3 size = cup.highest() - low;
  const auto along = [&](double extent) { return static_cast<int>(extent / edge) + 1; };
  for (int k = 0; k < along(size.z); ++k) {
    for (int j = 0; j < along(size.y); ++j) {
      for (int i = 0; i < along(size.x); ++i) {
        const Vec3 corner = low + edge * Vec3{1.0 * i, 1.0 * j, 1.0 * k};
        for (const auto& s : tile.spheres) {
          const Vec3 centre = corner + edge * s.centre();
          const double radius = 0.999999 * edge * s.radius;
          if (cup.nearest(centre).distance < radius) continue;
          packing.spheres.push_back(
              {static_cast<float>(centre.x),
               static_cast<float>(centre.y),
               static_cast<float>(centre.z),
               static_cast<float>(radius)});
        }
      }
    }
  }
  return packing;
}

}  // namespace haptics::bench
