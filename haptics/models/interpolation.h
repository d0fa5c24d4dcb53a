#pragma once

#include <stddef.h>

#include "haptics/models/response.h"
#include "haptics/models/segment_index.h"

namespace haptics::models {

/// A point of a force curve.
template <typename Scalar>
struct CurveNode {
  Scalar travel{};  ///< [travel units]
  Scalar force{};   ///< [N]
};

/// The force beyond either end of a recorded curve, which eq. (2) of the punch paper leaves open.
/// The enumerators' values are part of the wire protocol, docs/punch-protocol.md.
enum class Extrapolation {
  RampOut,       ///< the force at the end fades linearly to 0 over rampLength: "reduced to zero"
  Hold,          ///< the force at the end continues
  Zero,          ///< 0, with a jump
  AuthorsClamp,  ///< 0.01 N; and within the curve clamped to 0.01 N … 4.29 N
  Absent,  ///< undefined, since there is no measurement; within the curve see measurementWeightAt()
};

/// The force of a recorded cut, by linear interpolation between its points: eq. (2) of the punch
/// paper,
///
///     f(θ) = f*ₖ + (f*ₖ₊₁ − f*ₖ) (θ − θ*ₖ) / (θ*ₖ₊₁ − θ*ₖ)   for θ*ₖ ≤ θ ≤ θ*ₖ₊₁.
///
/// The interval k is looked up by position, not by time as the paper's index suggests. The caller
/// keeps the last interval as a hint, which serves for continuous motion; otherwise an index finds
/// the interval in O(1), or a bisection if there is no index.
template <typename Scalar>
class Interpolation {
 public:
  struct Options {
    Extrapolation extrapolation = Extrapolation::RampOut;
    /// [travel units], > 0. RampOut: length beyond each end over which the force fades. Absent:
    /// length inside each end over which measurementWeightAt() rises from 0 to 1.
    Scalar rampLength{1.5};
  };

  /// The range to which the authors' program clamps forces [N].
  static constexpr Scalar kAuthorsMinForce = Scalar(0.01);
  static constexpr Scalar kAuthorsMaxForce = Scalar(4.29);

  /// @param nodes  at least two, finite, with strictly increasing travel, see isSound(). They and
  ///               the index's table must outlive this object.
  constexpr Interpolation(
      const CurveNode<Scalar>* nodes,
      size_t count,
      const Options& options,
      const SegmentIndex<Scalar>& index = {}) noexcept
      : nodes_(nodes), count_(count), options_(options), index_(index) {}

  static constexpr bool isSound(
      const CurveNode<Scalar>* nodes, size_t count, const Options& options) noexcept {
    if (count < 2 || !isFinite(nodes[0]) || !(options.rampLength > Scalar{0})) return false;
    for (size_t i = 1; i < count; ++i) {
      if (!isFinite(nodes[i]) || !(nodes[i].travel > nodes[i - 1].travel)) return false;
      const Scalar slope =
          (nodes[i].force - nodes[i - 1].force) / (nodes[i].travel - nodes[i - 1].travel);
      if (!models::isFinite(slope)) return false;
    }
    return true;
  }

  /// Force and stiffness at @p travel [travel units]; undefined if it is NaN, and beyond the curve
  /// with Absent.
  /// @param hint  index of the interval; initialise to 0 and pass the same variable to every call.
  constexpr Response<Scalar> at(Scalar travel, size_t& hint) const noexcept {
    const auto& first = nodes_[0];
    const auto& last = nodes_[count_ - 1];
    if (!(travel >= first.travel)) return beyond(first.force, first.travel - travel, Scalar{-1});
    if (travel > last.travel) return beyond(last.force, travel - last.travel, Scalar{1});

    const size_t k = interval(travel, hint);
    hint = k;
    const auto& a = nodes_[k];
    const auto& b = nodes_[k + 1];
    const Scalar slope = (b.force - a.force) / (b.travel - a.travel);
    const Response<Scalar> response{a.force + slope * (travel - a.travel), slope, true};
    return options_.extrapolation == Extrapolation::AuthorsClamp ? clamped(response) : response;
  }

  /// Weight of the curve as a measurement at @p travel [travel units], for a filter: 1, except with
  /// Absent. With Absent it is 0 beyond the curve and rises linearly to 1 over rampLength inside
  /// it, so that the filter's output has no step at the ends.
  constexpr Scalar measurementWeightAt(Scalar travel) const noexcept {
    if (options_.extrapolation != Extrapolation::Absent) return Scalar{1};
    const Scalar before = travel - nodes_[0].travel;
    const Scalar behind = nodes_[count_ - 1].travel - travel;
    const Scalar within = before < behind ? before : behind;
    if (!(within > Scalar{0})) return Scalar{0};  // also if travel is NaN
    return within < options_.rampLength ? within / options_.rampLength : Scalar{1};
  }

 private:
  static constexpr bool isFinite(const CurveNode<Scalar>& node) noexcept {
    return models::isFinite(node.travel) && models::isFinite(node.force);
  }

  static constexpr Response<Scalar> clamped(const Response<Scalar>& response) noexcept {
    if (response.force < kAuthorsMinForce) return {kAuthorsMinForce, Scalar{0}, true};
    if (response.force > kAuthorsMaxForce) return {kAuthorsMaxForce, Scalar{0}, true};
    return response;
  }

  constexpr Response<Scalar> beyond(
      Scalar force, Scalar distance, Scalar direction) const noexcept {
    if (!(distance > Scalar{0}) || options_.extrapolation == Extrapolation::Absent) return {};
    if (options_.extrapolation == Extrapolation::AuthorsClamp)
      return {kAuthorsMinForce, Scalar{0}, true};
    if (options_.extrapolation == Extrapolation::Hold) return {force, Scalar{0}, true};
    if (options_.extrapolation == Extrapolation::Zero || distance >= options_.rampLength) {
      return {Scalar{0}, Scalar{0}, true};
    }
    const Scalar slope = -direction * force / options_.rampLength;
    return {force + slope * direction * distance, slope, true};
  }

  constexpr size_t interval(Scalar travel, size_t hint) const noexcept {
    if (hint + 1 < count_) {
      if (isInInterval(hint, travel)) return hint;
      if (hint + 2 < count_ && isInInterval(hint + 1, travel)) return hint + 1;
      if (hint > 0 && isInInterval(hint - 1, travel)) return hint - 1;
    }
    return index_.find(travel, count_ - 1, [this](size_t k) { return nodes_[k].travel; });
  }

  constexpr bool isInInterval(size_t k, Scalar travel) const noexcept {
    return nodes_[k].travel <= travel && travel <= nodes_[k + 1].travel;
  }

  const CurveNode<Scalar>* nodes_;
  size_t count_;
  Options options_;
  SegmentIndex<Scalar> index_;
};

/// A recorded cut with different closing and opening branches: tissue that has been cut resists
/// less while the tool opens.
///
/// When the hand reverses, the force changes from one branch to the other over a travel of width w,
/// as with a play operator (Visintin, Differential Models of Hysteresis, III.2):
///
///     s ← clamp(s − Δθ/w, 0, 1),   f = (1 − s) f_closing(θ) + s f_opening(θ).
///
/// f is continuous and independent of speed and rate. It generates no energy on a closed loop as
/// long as the opening branch is nowhere above the closing one.
template <typename Scalar>
class Hysteresis {
 public:
  struct State {
    Scalar opening{};  ///< s: 0 on the closing branch, 1 on the opening one
    Scalar last{};     ///< last travel [travel units]
    bool hasLast = false;
    size_t closingHint = 0;
    size_t openingHint = 0;
  };

  /// @param width  w [travel units], > 0.
  constexpr Hysteresis(
      const Interpolation<Scalar>& closing,
      const Interpolation<Scalar>& opening,
      Scalar width) noexcept
      : closing_(closing), opening_(opening), width_(width) {}

  /// Force and stiffness at @p travel [travel units], given the state after the last call.
  constexpr Response<Scalar> at(Scalar travel, State& state) const noexcept {
    const auto closing = closing_.at(travel, state.closingHint);
    const auto opening = opening_.at(travel, state.openingHint);
    if (!closing.isDefined || !opening.isDefined) return {};

    const Scalar wanted =
        state.opening - (state.hasLast ? (travel - state.last) / width_ : Scalar{0});
    const bool isTurning = wanted > Scalar{0} && wanted < Scalar{1};
    state.opening = wanted > Scalar{0} ? (wanted < Scalar{1} ? wanted : Scalar{1}) : Scalar{0};
    state.last = travel;
    state.hasLast = true;
    const Scalar s = state.opening;
    const Scalar fall = closing.force - opening.force;
    return {
        closing.force - s * fall,
        closing.stiffness + s * (opening.stiffness - closing.stiffness) +
            (isTurning ? fall / width_ : Scalar{0}),
        true};
  }

 private:
  Interpolation<Scalar> closing_;
  Interpolation<Scalar> opening_;
  Scalar width_;
};

}  // namespace haptics::models
