#pragma once

namespace haptics::models {

/// A sum that keeps what rounding would lose (Kahan 1965): its error does not grow with the number
/// of terms, as long as they have one sign. Not to be compiled with -ffast-math.
template <typename Scalar>
class CompensatedSum {
 public:
  constexpr void add(Scalar term) noexcept {
    const Scalar corrected = term - lost_;
    const Scalar sum = sum_ + corrected;
    lost_ = (sum - sum_) - corrected;
    if (!(lost_ - lost_ == Scalar{0})) lost_ = Scalar{0};  // a term without end
    sum_ = sum;
  }
  constexpr Scalar value() const noexcept { return sum_; }

 private:
  Scalar sum_{};
  Scalar lost_{};
};

}  // namespace haptics::models
