#include "haptics/reaming/packing/box_tree.h"

#include <algorithm>
#include <array>
#include <numeric>

namespace haptics::reaming {

void Box::add(const Box& other) noexcept {
  low = {std::min(low.x, other.low.x), std::min(low.y, other.low.y), std::min(low.z, other.low.z)};
  high = {
      std::max(high.x, other.high.x),
      std::max(high.y, other.high.y),
      std::max(high.z, other.high.z)};
}

bool Box::overlaps(const Box& other) const noexcept {
  return low.x <= other.high.x && other.low.x <= high.x && low.y <= other.high.y &&
         other.low.y <= high.y && low.z <= other.high.z && other.low.z <= high.z;
}

double Box::squaredDistanceTo(Vec3 place) const noexcept {
  const Vec3 off{
      std::max({low.x - place.x, 0.0, place.x - high.x}),
      std::max({low.y - place.y, 0.0, place.y - high.y}),
      std::max({low.z - place.z, 0.0, place.z - high.z})};
  return dot(off, off);
}

Box boxOf(std::span<const Vec3> places) noexcept {
  Box box{places.front(), places.front()};
  for (const Vec3 place : places) box.add({place, place});
  return box;
}

Box boxOf(const TriangleMesh& mesh, const TriangleMesh::Triangle& triangle) noexcept {
  const auto& v = mesh.vertices;
  return boxOf(std::array{v[triangle[0]], v[triangle[1]], v[triangle[2]]});
}

std::vector<Box> boxesOf(const TriangleMesh& mesh) {
  std::vector<Box> boxes;
  boxes.reserve(mesh.triangles.size());
  for (const auto& triangle : mesh.triangles) boxes.push_back(boxOf(mesh, triangle));
  return boxes;
}

BoxTree::BoxTree(const std::vector<Box>& boxes) {
  std::vector<std::uint32_t> items(boxes.size());
  std::iota(items.begin(), items.end(), 0U);
  nodes_.reserve(2 * boxes.size());
  nodes_.emplace_back();
  build(0, items, 0, items.size(), boxes);
}

void BoxTree::build(
    std::uint32_t node,
    std::vector<std::uint32_t>& items,
    std::size_t from,
    std::size_t to,
    const std::vector<Box>& boxes) {
  Box all = boxes[items[from]];
  for (std::size_t i = from; i < to; ++i) all.add(boxes[items[i]]);
  nodes_[node].box = all;
  if (to - from == 1) {
    nodes_[node].item = items[from];
    return;
  }
  const Vec3 size = all.high - all.low;
  const auto centreAlong = [&](const Box& box) {
    if (size.x >= size.y && size.x >= size.z) return box.low.x + box.high.x;
    return size.y >= size.z ? box.low.y + box.high.y : box.low.z + box.high.z;
  };
  const std::size_t middle = from + (to - from) / 2;
  const auto at = [&](std::size_t i) { return items.begin() + static_cast<std::ptrdiff_t>(i); };
  std::nth_element(at(from), at(middle), at(to), [&](std::uint32_t a, std::uint32_t b) {
    return centreAlong(boxes[a]) < centreAlong(boxes[b]);
  });
  const auto first = static_cast<std::uint32_t>(nodes_.size());
  nodes_[node].item = first;
  nodes_[node].isInner = true;
  nodes_.emplace_back();
  nodes_.emplace_back();
  build(first, items, from, middle, boxes);
  build(first + 1, items, middle, to, boxes);
}

}  // namespace haptics::reaming
