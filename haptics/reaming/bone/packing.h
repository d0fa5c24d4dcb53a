#pragma once

#include <cmath>
#include <string>
#include <vector>

namespace haptics::reaming {

/// A place or a direction in the frame of a bone [m]: the reamer goes in along +z.
struct Vec3 {
  double x = 0.0;
  double y = 0.0;
  double z = 0.0;

  friend constexpr Vec3 operator+(Vec3 a, Vec3 b) noexcept {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
  }
  friend constexpr Vec3 operator-(Vec3 a, Vec3 b) noexcept {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
  }
  friend constexpr Vec3 operator*(double s, Vec3 a) noexcept { return {s * a.x, s * a.y, s * a.z}; }
};

constexpr double dot(Vec3 a, Vec3 b) noexcept {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
constexpr Vec3 cross(Vec3 a, Vec3 b) noexcept {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline double length(Vec3 a) noexcept {
  return std::sqrt(dot(a, a));
}

/// The nearest place of a solid's surface.
struct SurfacePoint {
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
  virtual SurfacePoint nearest(Vec3 place) const noexcept = 0;

  virtual Vec3 lowest() const noexcept = 0;   ///< corner of its box
  virtual Vec3 highest() const noexcept = 0;  ///< and the opposite one
  virtual double volume() const noexcept = 0;
};

/// A sphere of a packing, in the numbers in which it is kept.
struct Sphere {
  float x = 0.0F;  ///< [m]
  float y = 0.0F;
  float z = 0.0F;
  float radius = 0.0F;  ///< [m], > 0

  Vec3 centre() const noexcept { return {x, y, z}; }
};

/// A body as spheres that do not overlap (reaming paper, "Implementation approach").
struct Packing {
  std::vector<Sphere> spheres;  ///< from the largest to the smallest
  double volume = 0.0;          ///< of the body [m³]

  double filled() const noexcept;                                 ///< volume of the spheres [m³]
  double coverage() const noexcept { return filled() / volume; }  ///< share of the body
};

/// The worst of a packing, each as a share of a radius: for tests and reports.
struct PackingFlaws {
  double overlap = 0.0;     ///< of the smaller of two; 0 where no two overlap
  double protrusion = 0.0;  ///< out of the body
};
PackingFlaws flawsOf(const Packing& packing, const Solid& body);

}  // namespace haptics::reaming
