#pragma once

#include "haptics/reaming/bone/solid.h"
#include "haptics/reaming/packing/box_tree.h"
#include "haptics/reaming/packing/triangle_mesh.h"

namespace haptics::reaming {

/// What a mesh encloses. Inside and outside are told by the normals of faces, edges and corners,
/// weighted by their angles (Bærentzen & Aanæs 2005).
class MeshSolid final : public Solid {
 public:
  /// @param mesh  closed, right side out, without problems.
  explicit MeshSolid(TriangleMesh mesh);

  Boundary nearest(Vec3 place) const noexcept override;
  Vec3 lowest() const noexcept override { return low_; }
  Vec3 highest() const noexcept override { return high_; }
  double volume() const noexcept override { return volume_; }

 private:
  /// Of one triangle: outward, on its face, its edges (from corner i to the next) and corners.
  struct Normals {
    Vec3 face;
    Vec3 edge[3];
    Vec3 corner[3];
  };

  TriangleMesh mesh_;
  BoxTree tree_;
  std::vector<Normals> normals_;
  Vec3 low_;
  Vec3 high_;
  double volume_;
};

}  // namespace haptics::reaming
