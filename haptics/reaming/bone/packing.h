#pragma once

#include <cmath>
#include <string>
#include <vector>

namespace haptics::reaming {

/// A position [m] or a direction in the frame of a bone; the reamer advances along +z.
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

/// Distance and direction to the nearest point of a solid's surface.
struct SurfacePoint {
  double distance = 0.0;  ///< signed: positive inside [m]
  Vec3 inward;            ///< unit vector in which the distance grows
};

/// A body that can be filled with spheres.
class Solid {
 public:
  virtual ~Solid() = default;
  Solid() = default;
  Solid(const Solid&) = delete;
  Solid& operator=(const Solid&) = delete;

  /// May be called by several threads at once.
  virtual SurfacePoint nearest(Vec3 place) const noexcept = 0;

  virtual Vec3 lowerCorner() const noexcept = 0;  ///< lower corner of the bounding box
  virtual Vec3 upperCorner() const noexcept = 0;  ///< upper corner
  virtual double volume() const noexcept = 0;
};

/// A sphere of a packing, in single precision as stored.
struct Sphere {
  float x = 0.0F;  ///< [m]
  float y = 0.0F;
  float z = 0.0F;
  float radius = 0.0F;  ///< [m], > 0

  Vec3 centre() const noexcept { return {x, y, z}; }
};

/// Non-overlapping spheres that approximate a body (reaming paper, "Implementation approach").
struct Packing {
  std::vector<Sphere> spheres;  ///< from the largest to the smallest
  double volume = 0.0;          ///< of the body [m³]

  double filled() const noexcept;  ///< volume of the spheres [m³]
  double coverage() const noexcept {
    return filled() / volume;
  }  ///< fraction of the body that the spheres fill
};

/// The largest errors of a packing, each relative to a radius of a sphere; for tests and reports.
struct PackingFlaws {
  double overlap = 0.0;     ///< of two spheres, relative to the smaller radius; 0 if none overlap
  double protrusion = 0.0;  ///< of a sphere out of the body
};
PackingFlaws flawsOf(const Packing& packing, const Solid& body);

}  // namespace haptics::reaming
