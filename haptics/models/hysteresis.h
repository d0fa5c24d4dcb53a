#pragma once

#include <stddef.h>

#include "haptics/models/interpolation.h"

namespace haptics::models {

/// A recorded cut whose opening is not its closing: the tissue that has given way does not push
/// back as it did.
///
/// Closing follows the closing branch, opening the opening branch. Where the hand turns, the force
/// passes from one to the other over a width of travel w, as a play operator does (Visintin,
/// Differential Models of Hysteresis, III.2):
///
///     s ← clamp(s − Δθ/w, 0, 1),   f = (1 − s) f_closing(θ) + s f_opening(θ).
///
/// f is continuous, independent of speed and rate, and gives no energy on a closed loop as long as
/// the opening branch nowhere lies above the closing one.
template <typename Scalar>
class Hysteresis {
 public:
  struct State {
    Scalar opening{};  ///< s: 0 on the closing branch, 1 on the opening one
    Scalar last{};     ///< travel [travel units]
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

  /// Force and stiffness at @p travel [travel units], after where the hand was before.
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
