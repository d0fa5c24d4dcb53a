#pragma once

namespace haptics::models {

/// A filter over travel that fuses two forces into one: eq. (12)–(24) of the punch paper.
///
/// The state is the force f and the stiffness ζ = df/dθ; a step of the handle by Δθ predicts
///
///     f ← f + ζ Δθ,   P ← A P Aᵀ + Q,   A = [1 Δθ; 0 1],
///
/// and a measured force z with variance R corrects
///
///     K = P Hᵀ (H P Hᵀ + R)⁻¹,   x ← x + K (z − f),   P ← (I − K H) P,   H = [1 0].
///
/// step() is the variant `authors-firmware`, what the paper's participants felt: predict, correct
/// with the finite elements, predict again by the same Δθ, correct with the interpolation. Only
/// because Q is added twice do both forces weigh about the same.
template <typename Scalar>
class KalmanFilter {
 public:
  /// Variances as in eq. (22)–(24). Q is symmetric: the 0.02772 printed in its upper right corner
  /// is read as the 0.2772 of its lower left one.
  struct Noise {
    Scalar processForce{7.0275};       ///< Q₁₁
    Scalar processCovariance{0.2772};  ///< Q₁₂ = Q₂₁
    Scalar processStiffness{6.1024};   ///< Q₂₂
    Scalar finiteElements{0.001};      ///< R of the finite-element force [N²]
    Scalar interpolation{7.742};       ///< R of the interpolated force [N²]
  };

  /// @param noise  isSound() has been asked.
  constexpr explicit KalmanFilter(const Noise& noise) noexcept : noise_(noise) { reset(); }

  /// No variance negative or infinite, Q positive semi-definite, and something to weigh with: with
  /// Q = 0 and R = 0 the gain would be 0/0.
  static constexpr bool isSound(const Noise& n) noexcept {
    const Scalar sum = n.processForce + n.processStiffness + n.finiteElements + n.interpolation +
                       n.processCovariance;
    const bool finite = sum - sum == Scalar{0};
    return finite && n.processForce >= Scalar{0} && n.processStiffness >= Scalar{0} &&
           n.processForce * n.processStiffness >= n.processCovariance * n.processCovariance &&
           n.finiteElements >= Scalar{0} && n.interpolation >= Scalar{0} &&
           (n.processForce > Scalar{0} ||
            (n.finiteElements > Scalar{0} && n.interpolation > Scalar{0}));
  }

  constexpr void reset() noexcept {
    force_ = stiffness_ = Scalar{0};
    p11_ = noise_.processForce;
    p12_ = noise_.processCovariance;
    p22_ = noise_.processStiffness;
  }

  /// One step of the handle by @p travelled [travel units]; both forces in [N].
  constexpr Scalar step(
      Scalar travelled, Scalar finiteElementForce, Scalar interpolatedForce) noexcept {
    predict(travelled);
    correct(finiteElementForce, noise_.finiteElements);
    predict(travelled);
    correct(interpolatedForce, noise_.interpolation);
    return force_;
  }

  constexpr Scalar force() const noexcept { return force_; }
  /// Unobservable while the handle rests: for the filter's own use, not for showing.
  constexpr Scalar stiffness() const noexcept { return stiffness_; }

 private:
  constexpr void predict(Scalar travelled) noexcept {
    force_ += stiffness_ * travelled;
    p11_ += travelled * (Scalar{2} * p12_ + travelled * p22_) + noise_.processForce;
    p12_ += travelled * p22_ + noise_.processCovariance;
    p22_ += noise_.processStiffness;
  }

  constexpr void correct(Scalar measured, Scalar variance) noexcept {
    const Scalar total = p11_ + variance;
    if (!(total > Scalar{0})) return;  // both are certain: there is nothing to weigh
    const Scalar gainForce = p11_ / total;
    const Scalar gainStiffness = p12_ / total;
    const Scalar innovation = measured - force_;
    force_ += gainForce * innovation;
    stiffness_ += gainStiffness * innovation;
    p22_ -= gainStiffness * p12_;
    p12_ *= variance / total;
    p11_ *= variance / total;
  }

  Noise noise_;
  Scalar force_{};
  Scalar stiffness_{};
  Scalar p11_{};
  Scalar p12_{};
  Scalar p22_{};
};

}  // namespace haptics::models
