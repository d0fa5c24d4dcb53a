#pragma once

#include "haptics/reaming/bone/solid.h"

namespace haptics::reaming {

/// A cup of our own making: half of a hollow sphere around the origin, open towards −z. Nobody's
/// bone; where no mesh is at hand, it lets everything else be tried.
class Acetabulum final : public Solid {
 public:
  /// @param inner, outer  radii [m], 0 <= inner < outer.
  /// @throws std::invalid_argument  if they are not.
  explicit Acetabulum(double inner = 0.0255, double outer = 0.041);

  Boundary nearest(Vec3 place) const noexcept override;
  Vec3 lowest() const noexcept override { return {-outer_, -outer_, 0.0}; }
  Vec3 highest() const noexcept override { return {outer_, outer_, outer_}; }
  double volume() const noexcept override;

 private:
  double inner_;
  double outer_;
};

}  // namespace haptics::reaming
