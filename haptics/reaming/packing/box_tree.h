#pragma once

#include <cstdint>
#include <vector>

#include "haptics/reaming/packing/triangle_mesh.h"

namespace haptics::reaming {

/// A box along the axes.
struct Box {
  Vec3 low;
  Vec3 high;

  void add(const Box& other) noexcept;
  bool meets(const Box& other) const noexcept;
  /// Of @p place from the box, squared; 0 inside [m²].
  double squaredDistanceTo(Vec3 place) const noexcept;
};

Box boxOf(const TriangleMesh& mesh, const TriangleMesh::Triangle& triangle) noexcept;
std::vector<Box> boxesOf(const TriangleMesh& mesh);

/// Boxes in a balanced tree, to find those near a point without reading all.
class BoxTree {
 public:
  explicit BoxTree(const std::vector<Box>& boxes);

  /// Calls @p see with the number of every box that meets @p box.
  template <typename See>
  void forEachOverlapping(const Box& box, See see) const {
    std::uint32_t stack[64];
    int depth = 0;
    stack[depth++] = 0;
    while (depth > 0) {
      const Node& node = nodes_[stack[--depth]];
      if (!node.box.meets(box)) continue;
      if (node.isLeaf()) {
        see(node.item);
      } else {
        stack[depth++] = node.item;
        stack[depth++] = node.item + 1;
      }
    }
  }

  /// Visits boxes, the nearer half first, that may hold something nearer to @p place than the
  /// squared distance that @p see last returned.
  template <typename See>
  void forEachNearer(Vec3 place, double square, See see) const {
    std::uint32_t stack[64];
    int depth = 0;
    stack[depth++] = 0;
    while (depth > 0) {
      const Node& node = nodes_[stack[--depth]];
      if (node.box.squaredDistanceTo(place) >= square) continue;
      if (node.isLeaf()) {
        square = see(node.item);
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
    std::uint32_t item = 0;  ///< of a leaf its box, else the first of two nodes side by side
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
