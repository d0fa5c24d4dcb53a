#pragma once

#include "haptics/reaming/bone/packing.h"
#include "haptics/reaming/packing/box_tree.h"
#include "haptics/reaming/packing/triangle_mesh.h"

namespace haptics::reaming {

/// A parametric cup: half of a hollow sphere around the origin, open towards −z. For use without a
/// mesh of a bone.
class Acetabulum final : public Solid {
 public:
  /// @param inner, outer  radii [m], 0 <= inner < outer.
  /// @throws std::invalid_argument  if they are out of range.
  explicit Acetabulum(double inner = 0.0255, double outer = 0.041);

  SurfacePoint nearest(Vec3 place) const noexcept override;
  Vec3 lowerCorner() const noexcept override { return {-outer_, -outer_, 0.0}; }
  Vec3 upperCorner() const noexcept override { return {outer_, outer_, outer_}; }
  double volume() const noexcept override;

 private:
  double inner_;
  double outer_;
};

/// The interior of a mesh. The sign of the distance comes from angle-weighted pseudonormals of
/// faces, edges and corners (Bærentzen & Aanæs 2005).
class MeshSolid final : public Solid {
 public:
  /// @param mesh  valid, see problemsOf().
  explicit MeshSolid(TriangleMesh mesh);

  SurfacePoint nearest(Vec3 place) const noexcept override;
  Vec3 lowerCorner() const noexcept override { return box_.low; }
  Vec3 upperCorner() const noexcept override { return box_.high; }
  double volume() const noexcept override { return volume_; }

 private:
  /// Outward pseudonormals of a triangle's face, edges (from corner i to the next) and corners.
  struct Normals {
    Vec3 face;
    Vec3 edge[3];
    Vec3 corner[3];
  };

  TriangleMesh mesh_;
  BoxTree tree_;
  std::vector<Normals> normals_;
  Box box_;
  double volume_;
};

}  // namespace haptics::reaming
