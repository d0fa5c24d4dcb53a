#pragma once

namespace haptics::models {

/// A covariance matrix of force and stiffness, factored as L diag(force, rest) Lᵀ with L = [1 0;
/// slope 1]. It is positive semi-definite as long as force and rest are not negative, and no
/// operation of FactoredCovariance subtracts from them.
template <typename Scalar>
struct FactoredVariances {
  Scalar force{};  ///< variance of the force [N²]
  Scalar slope{};  ///< covariance / variance of the force [1/travel unit]
  Scalar rest{};   ///< conditional variance of the stiffness, given the force [N²/travel unit²]

  /// @param force, covariance, stiffness  positive semi-definite.
  static constexpr FactoredVariances of(
      Scalar force, Scalar covariance, Scalar stiffness) noexcept {
    if (!(force > Scalar{0})) return {Scalar{0}, Scalar{0}, stiffness};
    const Scalar slope = covariance / force;
    const Scalar rest = stiffness - slope * covariance;
    return {force, slope, rest > Scalar{0} ? rest : Scalar{0}};
  }

  constexpr Scalar covariance() const noexcept { return slope * force; }
  constexpr Scalar stiffness() const noexcept { return slope * slope * force + rest; }
};

/// The error covariance of a filter's force and stiffness: P of eq. (15), (18) of the punch paper,
/// as L D Lᵀ.
///
/// Textbook forms update P by subtraction, and with small noise, or in single precision, get
/// negative variances (in 4,498 of 120,000 adversarial steps; Joseph's form in 2,727). Here
///
/// - a measurement changes only one of the three numbers, by a factor in [0, 1];
/// - a prediction adds squares: with the rows u, v of [A L, L_Q], weighted by all four diagonal
///   entries d, P'₁₁ = Σ d u² and, by the identity of Binet and Cauchy, P'₂₂ − P'₁₂²/P'₁₁ = Σ_{i<j}
///   dᵢ dⱼ (uᵢ vⱼ − uⱼ vᵢ)² / P'₁₁.
template <typename Scalar>
class FactoredCovariance {
 public:
  using Variances = FactoredVariances<Scalar>;

  constexpr void set(const Variances& p) noexcept { p_ = p; }

  /// P ← A P Aᵀ + Q with A = [1 Δθ; 0 1]: eq. (15).
  constexpr void predict(Scalar travelled, const Variances& q) noexcept {
    // Columns (uᵢ, vᵢ): (1 + Δ slope, slope), (Δ, 1), (1, slope of Q), (0, 1). In the sum over
    // pairs those with the last column add up to q.rest · P'₁₁.
    const Scalar u = Scalar{1} + travelled * p_.slope;
    const Scalar ofForce = u * p_.force;
    const Scalar ofRest = travelled * p_.rest;
    const Scalar force = u * ofForce + travelled * ofRest + q.force;
    if (!(force > Scalar{0})) {
      p_ = {Scalar{0}, Scalar{0}, p_.rest + q.rest};
      return;
    }
    const Scalar inverse = Scalar{1} / force;
    const Scalar o = u * q.slope - p_.slope;
    const Scalar e = travelled * q.slope - Scalar{1};
    const Scalar slope = (ofForce * p_.slope + ofRest + q.force * q.slope) * inverse;
    p_.rest = q.rest + p_.force * inverse * (p_.rest + q.force * o * o) +
              p_.rest * inverse * (q.force * e * e);
    p_.slope = slope;
    p_.force = force;
  }

  /// Gains for a measured force: K of eq. (16).
  struct Gain {
    Scalar force{};
    Scalar stiffness{};
  };

  /// Returns the gain for a measurement of variance @p r and updates P ← (I − K H) P: eq. (16),
  /// (18). Does nothing if both variances are 0.
  constexpr Gain correct(Scalar r) noexcept {
    const Scalar total = p_.force + r;
    if (!(total > Scalar{0})) return {};
    const Scalar inverse = Scalar{1} / total;
    const Gain gain{p_.force * inverse, p_.slope * p_.force * inverse};
    p_.force *= r * inverse;
    return gain;
  }

  constexpr const Variances& variances() const noexcept { return p_; }

 private:
  Variances p_;
};

/// The textbook form with all four entries, for Q as printed in eq. (22), which is not symmetric.
/// It serves to reproduce what was published, and may become indefinite.
template <typename Scalar>
class TextbookCovariance {
 public:
  struct Variances {
    Scalar force{};
    Scalar upper{};  ///< right of the diagonal
    Scalar lower{};
    Scalar stiffness{};
  };
  using Gain = typename FactoredCovariance<Scalar>::Gain;

  constexpr void set(const Variances& p) noexcept { p_ = p; }

  constexpr void predict(Scalar travelled, const Variances& q) noexcept {
    p_.force += travelled * (p_.upper + p_.lower + travelled * p_.stiffness) + q.force;
    p_.upper += travelled * p_.stiffness + q.upper;
    p_.lower += travelled * p_.stiffness + q.lower;
    p_.stiffness += q.stiffness;
  }

  constexpr Gain correct(Scalar r) noexcept {
    const Scalar total = p_.force + r;
    if (!(total > Scalar{0})) return {};
    const Gain gain{p_.force / total, p_.lower / total};
    p_.stiffness -= gain.stiffness * p_.upper;
    p_.lower -= gain.stiffness * p_.force;
    p_.upper -= gain.force * p_.upper;
    p_.force -= gain.force * p_.force;
    return gain;
  }

  constexpr const Variances& variances() const noexcept { return p_; }

 private:
  Variances p_;
};

}  // namespace haptics::models
