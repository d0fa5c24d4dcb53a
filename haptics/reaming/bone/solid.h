#pragma once

#include "haptics/reaming/bone/vec3.h"

namespace haptics::reaming {

/// The nearest place of a solid's surface.
struct Boundary {
  double distance = 0.0;  ///< signed: above 0 inside [m]
  Vec3 inward;            ///< where that distance grows: a unit vector
};

/// A body that can be filled.
class Solid {
 public:
  virtual ~Solid() = default;
  Solid() = default;
  Solid(const Solid&) = delete;
  Solid& operator=(const Solid&) = delete;

  /// Any number of threads.
  virtual Boundary nearest(Vec3 place) const noexcept = 0;

  virtual Vec3 lowest() const noexcept = 0;   ///< corner of its box
  virtual Vec3 highest() const noexcept = 0;  ///< and the opposite one
  virtual double volume() const noexcept = 0;
};

}  // namespace haptics::reaming
