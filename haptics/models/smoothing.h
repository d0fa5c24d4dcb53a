#pragma once

namespace haptics::models {

/// Filters of the force before it is sent to the motor.
enum class Smoothing {
  None,
  TwoPoint,  ///< (xₖ + xₖ₋₁) / 2: Fig. 11 of the punch paper; cancels an alternating force
  AuthorsFirmware,  ///< yₖ = (yₖ₋₁ + xₖ₋₁ + xₖ₋₂) / 3: recursive, without the present sample
};

/// Applies a Smoothing to a sequence of forces.
template <typename Scalar>
class MovingAverage {
 public:
  constexpr explicit MovingAverage(Smoothing smoothing) noexcept : smoothing_(smoothing) {}

  constexpr void reset() noexcept { hasStarted_ = false; }

  constexpr Scalar feed(Scalar x) noexcept {
    if (!hasStarted_) y_ = last_ = beforeLast_ = x;  // as if the force had always been x
    hasStarted_ = true;
    switch (smoothing_) {
      case Smoothing::None:
        y_ = x;
        break;
      case Smoothing::TwoPoint:
        y_ = (x + last_) / Scalar{2};
        break;
      case Smoothing::AuthorsFirmware:
        y_ = (y_ + last_ + beforeLast_) / Scalar{3};
        break;
    }
    beforeLast_ = last_;
    last_ = x;
    return y_;
  }

 private:
  Smoothing smoothing_;
  bool hasStarted_ = false;
  Scalar y_{};
  Scalar last_{};
  Scalar beforeLast_{};
};

}  // namespace haptics::models
