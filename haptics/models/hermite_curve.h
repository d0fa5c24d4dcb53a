#pragma once

#include <stddef.h>

#include "haptics/models/response.h"
#include "haptics/models/segment_index.h"

namespace haptics::models {

/// A node of a curve with a given value and slope.
template <typename Scalar>
struct HermiteNode {
  Scalar position{};  ///< [m]
  Scalar force{};     ///< [N]
  Scalar slope{};     ///< [N/m]
};

/// The coefficients of the cubic between two nodes: f(u) = force + u (slope + u (square + u cube))
/// with u = position − begin. In double precision it fills one cache line.
template <typename Scalar>
struct alignas(8 * sizeof(Scalar)) CubicSegment {
  Scalar begin{};   ///< [m]
  Scalar end{};     ///< [m]
  Scalar force{};   ///< [N]
  Scalar slope{};   ///< [N/m]
  Scalar square{};  ///< [N/m²]
  Scalar cube{};    ///< [N/m³]

  /// The cubic with the values and slopes of both nodes at its ends: eq. (3) of the reaming paper.
  static constexpr CubicSegment between(
      const HermiteNode<Scalar>& a, const HermiteNode<Scalar>& b) noexcept {
    const Scalar h = b.position - a.position;
    const Scalar rise = (b.force - a.force) / h;
    const Scalar r = a.slope + b.slope - Scalar{2} * rise;
    const Scalar q = rise - a.slope - r;
    const Scalar square = q / h;
    const Scalar cube = r / h / h;
    // After an underflow or overflow the curve would miss its second node: mark it with NaN.
    const bool isFaithful =
        isNear(h * h / h, h) && isNear(square * h, q) && isNear(cube * h * h, r);
    constexpr auto kNone = static_cast<Scalar>(__builtin_nan(""));
    return {a.position, b.position, a.force, a.slope, square, isFaithful ? cube : kNone};
  }

  /// Whether @p value equals @p wanted within 0.1 %. That tolerance is larger than rounding errors
  /// in single precision, and far smaller than the error after an underflow or overflow.
  static constexpr bool isNear(Scalar value, Scalar wanted) noexcept {
    const Scalar slack = Scalar(1e-3) * (wanted < Scalar{0} ? -wanted : wanted);
    return value - wanted <= slack && wanted - value <= slack;
  }

  constexpr bool isFinite() const noexcept {
    return begin - begin == Scalar{0} && end - end == Scalar{0} && force - force == Scalar{0} &&
           slope - slope == Scalar{0} && square - square == Scalar{0} && cube - cube == Scalar{0};
  }

  /// Evaluates by Estrin's scheme: a chain of five dependent operations, where Horner's has seven.
  constexpr Response<Scalar> at(Scalar position) const noexcept {
    const Scalar u = position - begin;
    const Scalar uu = u * u;
    return {
        (force + u * slope) + uu * (square + u * cube),
        (slope + Scalar{2} * u * square) + Scalar{3} * uu * cube,
        true};
  }
};

/// Force over displacement by cubic Hermite splines, as the reaming paper models the acetabulum: on
/// every interval the cubic that has the given forces and slopes at both ends (its eq. (1), (3)).
/// Value and slope are continuous. The second derivative is not, contrary to the paper.
///
/// Before the first node the force is 0, since the reamer is not yet in contact. Beyond the last
/// node it is constant. The segment is found like the interval of Interpolation.
template <typename Scalar>
class HermiteCurve {
 public:
  using Segment = CubicSegment<Scalar>;

  /// @param segments  one or more, each beginning where the last one ends, all finite, see
  ///                  isSound(). They and the index's table must outlive this object.
  constexpr HermiteCurve(
      const Segment* segments, size_t count, const SegmentIndex<Scalar>& index = {}) noexcept
      : segments_(segments), count_(count), index_(index) {}

  static constexpr bool isSound(const Segment* segments, size_t count) noexcept {
    if (count < 1) return false;
    for (size_t i = 0; i < count; ++i) {
      const auto& segment = segments[i];
      if (!segment.isFinite() || !(segment.end > segment.begin)) return false;
      if (i > 0 && segment.begin != segments[i - 1].end) return false;
    }
    return true;
  }

  /// @param hint  index of the segment; initialise to 0 and pass the same variable to every call.
  constexpr Response<Scalar> at(Scalar position, size_t& hint) const noexcept {
    const Segment* segment = segments_ + (hint < count_ ? hint : 0);
    if (!(segment->begin <= position && position <= segment->end)) {
      if (!(position >= segments_[0].begin)) {
        return {Scalar{0}, Scalar{0}, position < segments_[0].begin};
      }
      const Segment& last = segments_[count_ - 1];
      if (position > last.end) return {last.at(last.end).force, Scalar{0}, true};
      hint = index_.find(position, count_, [this](size_t k) { return segments_[k].begin; });
      segment = segments_ + hint;
    }
    return segment->at(position);
  }

 private:
  const Segment* segments_;
  size_t count_;
  SegmentIndex<Scalar> index_;
};

}  // namespace haptics::models
