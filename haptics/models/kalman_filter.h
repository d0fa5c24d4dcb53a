#pragma once

#include "haptics/models/covariance.h"
#include "haptics/models/response.h"

namespace haptics::models {

/// How the two forces are used in a step of the handle by Δθ.
enum class KalmanScheme {
  PaperText,        ///< predict; then correct by one of the two, alternately: the force oscillates
                    ///< between them
  AuthorsFirmware,  ///< predict, correct by finite elements, predict again by the same Δθ, correct
                    ///< by interpolation
  Sequential,   ///< predict, correct by finite elements, correct by interpolation: the textbook
                ///< scheme
  SpaceDomain,  ///< as Sequential, with a Q that grows with travel: independent of the rate
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
/// The scheme decides how the forces are weighted (docs/force-models.md): with the published noise,
/// in the order of the state, the weight of the interpolation is 0.22, 0.44 and 0 in the first
/// three. In SpaceDomain it depends on R only.
///
/// In the first three schemes Q is added per step, so the force depends on the rate and on the
/// speed of the hand. In SpaceDomain the stiffness is a random walk over travel with variance
/// `wandering` per travel unit, which gives
///
///     Q = q [ |Δθ|³/3  Δθ|Δθ|/2 ; Δθ|Δθ|/2  |Δθ| ].
///
/// If the trust of the interpolated force is 0, it is not used. With a trust s in (0, 1) its
/// variance is
///
///     R_s = (R + (1 − s) P₁₁) / s,    so that    K₁ = s P₁₁ / (P₁₁ + R):
///
/// its gain is s times the full gain, so a trust that rises with travel causes no step in the
/// force.
template <typename Scalar, template <typename> typename Covariance = FactoredCovariance>
class KalmanFilter {
 public:
  using Variances = typename Covariance<Scalar>::Variances;

  struct Noise {
    Variances process;        ///< Q of eq. (22)
    Scalar finiteElements{};  ///< R of the finite-element force [N²]
    Scalar interpolation{};   ///< R of the interpolated force [N²]
    Scalar wandering{};       ///< q of SpaceDomain [N²/travel unit³]
  };

  /// @param noise  valid, see KalmanNoise::invalidReason().
  constexpr KalmanFilter(const Noise& noise, KalmanScheme scheme) noexcept
      : noise_(noise), scheme_(scheme) {
    reset();
  }

  constexpr void reset() noexcept {
    force_ = stiffness_ = Scalar{0};
    usesElementsNext_ = true;
    covariance_.set(noise_.process);
  }

  /// Processes one step of the handle by @p travelled [travel units]; both forces in [N]. Returns
  /// the fused force [N].
  /// @param trust  s: weight of the interpolated force as a measurement, in [0, 1].
  constexpr Scalar step(
      Scalar travelled,
      Scalar finiteElementForce,
      Scalar interpolatedForce,
      Scalar trust = Scalar{1}) noexcept {
    predict(travelled);
    switch (scheme_) {
      case KalmanScheme::PaperText:
        if (usesElementsNext_) {
          correct(finiteElementForce, noise_.finiteElements);
        } else {
          correctWeighted(interpolatedForce, trust);
        }
        usesElementsNext_ = !usesElementsNext_;
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
    correctWeighted(interpolatedForce, trust);
    return force_;
  }

  constexpr Scalar force() const noexcept { return force_; }
  /// Not observable while the handle rests, so not to be displayed.
  constexpr Scalar stiffness() const noexcept { return stiffness_; }
  /// P, in the form of the covariance class.
  constexpr const Variances& variances() const noexcept { return covariance_.variances(); }

 private:
  constexpr void predict(Scalar travelled) noexcept {
    force_ += stiffness_ * travelled;
    covariance_.predict(
        travelled,
        scheme_ == KalmanScheme::SpaceDomain ? processVariances(travelled) : noise_.process);
  }

  /// Q of SpaceDomain, factored: slope is 3/(2 Δθ), and rest a quarter of the stiffness' variance.
  constexpr Variances processVariances(Scalar travelled) const noexcept {
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

  constexpr void correctWeighted(Scalar interpolatedForce, Scalar trust) noexcept {
    if (!(trust > Scalar{0})) return;
    const Scalar r = noise_.interpolation;
    const Scalar extraVariance = (Scalar{1} - trust) * covariance_.variances().force;
    correct(interpolatedForce, trust < Scalar{1} ? (r + extraVariance) / trust : r);
  }

  Noise noise_;
  KalmanScheme scheme_;
  Scalar force_{};
  Scalar stiffness_{};
  bool usesElementsNext_ = true;  ///< PaperText: the finite elements are next
  Covariance<Scalar> covariance_;
};

/// Interpretations of the process noise in eq. (22) of the punch paper, [7.0275 0.02772; 0.2772
/// 6.1024].
enum class ProcessNoiseReading {
  AsPrinted,    ///< not symmetric: only to reproduce what was published
  Symmetrised,  ///< 0.2772 off the diagonal: 0.02772 is a misprint
  StateOrder,   ///< as Symmetrised, with the diagonal in the order of the state (f, ζ): the
                ///< recordings give 6.1024 for the force, 7.038 for the stiffness
  Product,      ///< the product of both standard deviations off the diagonal, as "σ_f σ_ζ" says
};

/// The variances of eq. (22)–(24) of the punch paper.
template <typename Scalar>
struct KalmanNoise {
  Scalar processForce = Scalar(7.0275);       ///< Q₁₁ [N²]
  Scalar processCovariance = Scalar(0.2772);  ///< Q₁₂ = Q₂₁ [N²/travel unit]
  Scalar processStiffness = Scalar(6.1024);   ///< Q₂₂ [N²/travel unit²]
  Scalar finiteElements = Scalar(0.001);      ///< R of the finite-element force [N²]
  Scalar interpolation = Scalar(7.742);       ///< R of the interpolated force [N²]
  Scalar wandering = Scalar(7.0275);          ///< q of SpaceDomain [N²/travel unit³]

  /// The published noise, with the process noise in an interpretation. AsPrinted is treated as
  /// Symmetrised.
  static constexpr KalmanNoise published(ProcessNoiseReading reading) noexcept {
    KalmanNoise noise;
    if (reading == ProcessNoiseReading::StateOrder) {
      noise.processForce = Scalar(6.1024);
      noise.processStiffness = Scalar(7.0275);
    }
    if (reading == ProcessNoiseReading::Product) {
      noise.processCovariance = Scalar(6.5486);  // √(7.0275 · 6.1024)
    }
    return noise;
  }

  /// Why this noise is not valid; nullptr if it is. An indefinite Q leads to negative variances
  /// while the force still looks plausible; with Q = 0 and R = 0 the gain is 0/0.
  constexpr const char* invalidReason() const noexcept {
    const Scalar sum = processForce + processCovariance + processStiffness + finiteElements +
                       interpolation + wandering;
    const Scalar product = processForce * processStiffness;
    if (!isFinite(sum) || !isFinite(product)) {
      return "a variance of the Kalman filter is not finite";
    }
    if (finiteElements < Scalar{0} || interpolation < Scalar{0}) {
      return "the variance of a measured force (R) is negative; it is a square";
    }
    if (processForce < Scalar{0} || processStiffness < Scalar{0} || wandering < Scalar{0}) {
      return "the process noise (Q) has a negative variance; it is a square";
    }
    if (product < processCovariance * processCovariance) {
      return "the process noise (Q) is indefinite: covariance² must not exceed force · stiffness";
    }
    const bool isCertain = finiteElements == Scalar{0} || interpolation == Scalar{0};
    if (isCertain && processForce == Scalar{0}) {
      return "with no process noise (Q) and no measurement noise (R) there is nothing to weigh";
    }
    return nullptr;
  }

  constexpr typename KalmanFilter<Scalar>::Noise factored() const noexcept {
    return {
        FactoredVariances<Scalar>::of(processForce, processCovariance, processStiffness),
        finiteElements,
        interpolation,
        wandering};
  }

  /// With Q exactly as printed in eq. (22).
  constexpr typename KalmanFilter<Scalar, TextbookCovariance>::Noise asPrinted() const noexcept {
    return {
        {Scalar(7.0275), Scalar(0.02772), Scalar(0.2772), Scalar(6.1024)},
        finiteElements,
        interpolation,
        wandering};
  }
};

}  // namespace haptics::models
