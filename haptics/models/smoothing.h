#pragma once

namespace haptics::models {

/// What is done with a force before it goes to the motor.
enum class Smoothing {
  None,
  TwoPoint,  ///< (xₖ + xₖ₋₁) / 2: the punch paper's Fig. 11. It hides a square wave
  AuthorsFirmware,  ///< yₖ = (yₖ₋₁ + xₖ₋₁ + xₖ₋₂) / 3: feeds itself, and leaves the present out
};

/// A moving average over the last forces.
template <typename Scalar>
class MovingAverage {
 public:
  constexpr explicit MovingAverage(Smoothing smoothing) noexcept : smoothing_(smoothing) {}

  constexpr void reset() noexcept { hasStarted_ = false; }

  constexpr Scalar feed(Scalar x) noexcept {
    if (!hasStarted_) y_ = last_ = beforeLast_ = x;  // as if it had always been so
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
