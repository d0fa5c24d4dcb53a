#pragma once

#include <stddef.h>

#include "haptics/models/response.h"

namespace haptics::models {

/// A node of a curve with a given value and slope.
template <typename Scalar>
struct HermiteNode {
  Scalar position{};  ///< [m]
  Scalar force{};     ///< [N]
  Scalar slope{};     ///< [N/m]
};

/// Force over displacement by cubic Hermite splines, as the reaming paper models the acetabulum:
/// on every interval the cubic that has the given forces and slopes at both ends (its eq. (1),
/// (3)). Value and slope are continuous, the second derivative is not, whatever the paper's eq. (3)
/// says.
///
/// Before the first node there is no force: the reamer is not yet in contact. Beyond the last one
/// the force stays.
template <typename Scalar>
class HermiteCurve {
 public:
  /// @param nodes  position strictly increasing, all finite, at least two: isSound() has been
  /// asked.
  ///               They outlive this object.
  constexpr HermiteCurve(const HermiteNode<Scalar>* nodes, size_t count) noexcept
      : nodes_(nodes), count_(count) {}

  static constexpr bool isSound(const HermiteNode<Scalar>* nodes, size_t count) noexcept {
    if (count < 2) return false;
    for (size_t i = 0; i < count; ++i) {
      const auto& n = nodes[i];
      const Scalar sum = n.position + n.force + n.slope;
      if (sum - sum != Scalar{0}) return false;
      if (i > 0 && !(n.position > nodes[i - 1].position)) return false;
    }
    return true;
  }

  /// @param hint  of the interval; start with 0 and hand back what came out.
  constexpr Response<Scalar> at(Scalar position, size_t& hint) const noexcept {
    const auto& last = nodes_[count_ - 1];
    if (!(position >= nodes_[0].position)) {
      return {Scalar{0}, Scalar{0}, position < nodes_[0].position};
    }
    if (position >= last.position) return {last.force, Scalar{0}, true};

    const size_t k = interval(position, hint);
    hint = k;
    const auto& a = nodes_[k];
    const auto& b = nodes_[k + 1];
    const Scalar h = b.position - a.position;
    const Scalar t = (position - a.position) / h;
    const Scalar rise = (b.force - a.force) / h;
    // f = a + h t (a' + t (q + t r)), with q and r from the end values and slopes.
    const Scalar r = a.slope + b.slope - Scalar{2} * rise;
    const Scalar q = rise - a.slope - r;
    return {
        a.force + h * t * (a.slope + t * (q + t * r)),
        a.slope + t * (Scalar{2} * q + Scalar{3} * t * r),
        true};
  }

 private:
  constexpr size_t interval(Scalar position, size_t hint) const noexcept {
    if (hint + 1 < count_ && nodes_[hint].position <= position &&
        position <= nodes_[hint + 1].position) {
      return hint;
    }
    size_t low = 0;
    size_t high = count_ - 1;
    while (high - low > 1) {
      const size_t middle = low + (high - low) / 2;
      (nodes_[middle].position <= position ? low : high) = middle;
    }
    return low;
  }

  const HermiteNode<Scalar>* nodes_;
  size_t count_;
};

}  // namespace haptics::models
