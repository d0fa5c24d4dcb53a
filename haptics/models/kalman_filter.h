#pragma once

#include "haptics/models/covariance.h"

namespace haptics::models {

/// How the two forces enter a step of the handle by Δθ.
enum class KalmanScheme {
  PaperText,        ///< predict; then one of the two, in turn: a square wave between them
  AuthorsFirmware,  ///< predict, finite elements, predict again by the same Δθ, interpolation
  Sequential,       ///< predict, finite elements, interpolation: as a textbook would
  SpaceDomain,      ///< as Sequential, with a Q that grows with the way: the same at every rate
};

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
/// Which of the schemes runs decides what is felt (docs/force-models.md):
/// with the published noise, in the order of the state, the interpolation weighs 0.22, 0.44 and
/// nothing in the first three. In SpaceDomain only R decides.
///
/// Q is per step in the first three, so that what is felt depends on the rate and on the speed of
/// the hand. In SpaceDomain a stiffness that wanders by `wandering` per unit of travel gives
///
///     Q = q [ |Δθ|³/3  Δθ|Δθ|/2 ; Δθ|Δθ|/2  |Δθ| ].
///
/// Where the interpolated force is no measurement (trust 0), its correction is left out: there is a
/// prediction only, and P grows until the finite elements correct it. Where it is partly trusted,
/// by a share s in (0, 1), it enters with the variance
///
///     R_s = (R + (1 − s) P₁₁) / s,    so that    K₁ = s P₁₁ / (P₁₁ + R):
///
/// its gain is s times what it would be. A share that grows with travel takes it up without a step.
template <typename Scalar, template <typename> typename Covariance = FactoredCovariance>
class KalmanFilter {
 public:
  using Variances = typename Covariance<Scalar>::Noise;

  struct Noise {
    Variances process;        ///< Q of eq. (22)
    Scalar finiteElements{};  ///< R of the finite-element force [N²]
    Scalar interpolation{};   ///< R of the interpolated force [N²]
    Scalar wandering{};       ///< q of SpaceDomain [N²/travel unit³]
  };

  /// @param noise  whyUnsound() has been asked.
  constexpr KalmanFilter(const Noise& noise, KalmanScheme scheme) noexcept
      : noise_(noise), scheme_(scheme) {
    reset();
  }

  constexpr void reset() noexcept {
    force_ = stiffness_ = Scalar{0};
    isElastic_ = true;
    covariance_.set(noise_.process);
  }

  /// One step of the handle by @p travelled [travel units]; both forces in [N].
  /// @param trust  s: how far the interpolated force is a measurement, in [0, 1].
  constexpr Scalar step(
      Scalar travelled,
      Scalar finiteElementForce,
      Scalar interpolatedForce,
      Scalar trust = Scalar{1}) noexcept {
    predict(travelled);
    switch (scheme_) {
      case KalmanScheme::PaperText:
        if (isElastic_) {
          correct(finiteElementForce, noise_.finiteElements);
        } else {
          correctPartly(interpolatedForce, trust);
        }
        isElastic_ = !isElastic_;
        return force_;
      case KalmanScheme::AuthorsFirmware:
        correct(finiteElementForce, noise_.finiteElements);
        predict(travelled);
        break;
      case KalmanScheme::Sequential:
      case KalmanScheme::SpaceDomain:
        correct(finiteElementForce, noise_.finiteElements);
        break;
    }
    correctPartly(interpolatedForce, trust);
    return force_;
  }

  constexpr Scalar force() const noexcept { return force_; }
  /// Unobservable while the handle rests: for the filter's own use, not for showing.
  constexpr Scalar stiffness() const noexcept { return stiffness_; }
  /// P, in the form in which it is kept.
  constexpr const Variances& variances() const noexcept { return covariance_.variances(); }

 private:
  constexpr void predict(Scalar travelled) noexcept {
    force_ += stiffness_ * travelled;
    covariance_.predict(
        travelled,
        scheme_ == KalmanScheme::SpaceDomain ? wanderingOver(travelled) : noise_.process);
  }

  /// Factored beforehand: slope 3/2Δθ, and a quarter of the stiffness' variance is left.
  constexpr Variances wanderingOver(Scalar travelled) const noexcept {
    if constexpr (requires(Variances v) { v.slope; }) {
      const Scalar way = travelled < Scalar{0} ? -travelled : travelled;
      const Scalar third = noise_.wandering * way * way * way / Scalar{3};
      if (third == Scalar{0}) return {Scalar{0}, Scalar{0}, noise_.wandering * way};
      return {third, Scalar(1.5) / travelled, noise_.wandering * way / Scalar{4}};
    } else {
      return noise_.process;
    }
  }

  constexpr void correct(Scalar measured, Scalar variance) noexcept {
    const auto gain = covariance_.correct(variance);
    const Scalar innovation = measured - force_;
    force_ += gain.force * innovation;
    stiffness_ += gain.stiffness * innovation;
  }

  constexpr void correctPartly(Scalar interpolatedForce, Scalar trust) noexcept {
    if (!(trust > Scalar{0})) return;
    const Scalar r = noise_.interpolation;
    const Scalar doubt = (Scalar{1} - trust) * covariance_.variances().force;
    correct(interpolatedForce, trust < Scalar{1} ? (r + doubt) / trust : r);
  }

  Noise noise_;
  KalmanScheme scheme_;
  Scalar force_{};
  Scalar stiffness_{};
  bool isElastic_ = true;  ///< PaperText: whose turn it is
  Covariance<Scalar> covariance_;
};

}  // namespace haptics::models
