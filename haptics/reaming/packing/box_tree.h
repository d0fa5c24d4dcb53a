#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "haptics/reaming/packing/triangle_mesh.h"

namespace haptics::reaming {

/// An axis-aligned box.
struct Box {
  Vec3 low;
  Vec3 high;

  void add(const Box& other) noexcept;
  bool overlaps(const Box& other) const noexcept;
  /// Squared distance of @p place from the box [m²]; 0 inside.
  double squaredDistanceTo(Vec3 place) const noexcept;
};

Box boxOf(std::span<const Vec3> places) noexcept;  ///< all of @p places; at least one
Box boxOf(const TriangleMesh& mesh, const TriangleMesh::Triangle& triangle) noexcept;
std::vector<Box> boxesOf(const TriangleMesh& mesh);

/// A balanced tree of boxes (bounding volume hierarchy), for finding boxes near a point.
class BoxTree {
 public:
  explicit BoxTree(const std::vector<Box>& boxes);

  /// Calls @p take with the index of every box that overlaps @p box.
  template <typename Take>
  void forEachOverlapping(const Box& box, Take take) const {
    std::uint32_t stack[64];
    int depth = 0;
    stack[depth++] = 0;
    while (depth > 0) {
      const Node& node = nodes_[stack[--depth]];
      if (!node.box.overlaps(box)) continue;
      if (node.isLeaf()) {
        take(node.item);
      } else {
        stack[depth++] = node.item;
        stack[depth++] = node.item + 1;
      }
    }
  }

  /// Calls @p take with the index of every box whose squared distance from @p place is less than
  /// @p square [m²]; the nearer half of the tree is searched first. @p take returns the new,
  /// smaller squared distance.
  template <typename Take>
  void forEachNearer(Vec3 place, double square, Take take) const {
    std::uint32_t stack[64];
    int depth = 0;
    stack[depth++] = 0;
    while (depth > 0) {
      const Node& node = nodes_[stack[--depth]];
      if (node.box.squaredDistanceTo(place) >= square) continue;
      if (node.isLeaf()) {
        square = take(node.item);
        continue;
      }
      const double first = nodes_[node.item].box.squaredDistanceTo(place);
      const double second = nodes_[node.item + 1].box.squaredDistanceTo(place);
      const bool isFirstNearer = first < second;
      stack[depth++] = isFirstNearer ? node.item + 1 : node.item;
      stack[depth++] = isFirstNearer ? node.item : node.item + 1;
    }
  }

 private:
  struct Node {
    Box box;
    std::uint32_t item = 0;  ///< leaf: index of its box; inner node: index of its first child,
                             ///< which the second follows
    bool isInner = false;

    bool isLeaf() const noexcept { return !isInner; }
  };
  void build(
      std::uint32_t node,
      std::vector<std::uint32_t>& items,
      std::size_t from,
      std::size_t to,
      const std::vector<Box>& boxes);

  std::vector<Node> nodes_;
};

}  // namespace haptics::reaming
