#pragma once

#include "haptics/models/covariance.h"
#include "haptics/models/response.h"

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
        scheme_ == KalmanScheme::SpaceDomain ? processVariances(travelled) : noise_.process);
  }

  /// Factored beforehand: slope 3/2Δθ, and a quarter of the stiffness' variance is left.
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

/// What can be made of the process noise that eq. (22) of the punch paper prints:
/// [7.0275 0.02772; 0.2772 6.1024].
enum class ProcessNoiseReading {
  AsPrinted,    ///< not symmetric: for replaying what was published, nothing else
  Symmetrised,  ///< 0.2772 on both sides: 0.02772 is a misprint
  StateOrder,   ///< and the diagonal in the order of the state (f, ζ): the recordings give 6.1024
                ///< for the force, 7.038 for the stiffness
  Product,      ///< off the diagonal the product of both deviations, as "σ_f σ_ζ" says
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

  /// With the published process noise, read so. AsPrinted reads as Symmetrised here.
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

  /// Why no filter can be run with this; nullptr where one can. An indefinite Q ends with a
  /// negative variance while the force still looks sane; Q = 0 and R = 0 weigh 0 against 0.
  constexpr const char* whyUnsound() const noexcept {
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

  /// With Q as eq. (22) prints it.
  constexpr typename KalmanFilter<Scalar, TextbookCovariance>::Noise asPrinted() const noexcept {
    return {
        {Scalar(7.0275), Scalar(0.02772), Scalar(0.2772), Scalar(6.1024)},
        finiteElements,
        interpolation,
        wandering};
  }
};

/// The filter `authors-firmware` with its steady-state gains for a hand that hardly moves, for
/// processors without fast division. It is a different filter if Δθ varies, and has its own name.
template <typename Scalar>
class SteadyFilter {
 public:
  struct Gains {
    Scalar finiteElements{};           ///< of the force
    Scalar finiteElementsStiffness{};  ///< of the stiffness [1/travel unit]
    Scalar interpolation{};
    Scalar interpolationStiffness{};
  };

  /// Of a filter with this noise, after @p steps steps of no way. Before anything moves.
  static constexpr Gains gainsOf(
      const KalmanFilter<double>::Noise& noise, int steps = 200) noexcept {
    FactoredCovariance<double> covariance;
    covariance.set(noise.process);
    FactoredCovariance<double>::Gain elastic;
    FactoredCovariance<double>::Gain recorded;
    for (int i = 0; i < steps; ++i) {
      covariance.predict(0.0, noise.process);
      elastic = covariance.correct(noise.finiteElements);
      covariance.predict(0.0, noise.process);
      recorded = covariance.correct(noise.interpolation);
    }
    return {
        Scalar(elastic.force),
        Scalar(elastic.stiffness),
        Scalar(recorded.force),
        Scalar(recorded.stiffness)};
  }

  constexpr explicit SteadyFilter(const Gains& gains) noexcept : gains_(gains) {}

  constexpr void reset() noexcept { force_ = stiffness_ = Scalar{}; }

  constexpr Scalar step(
      Scalar travelled, Scalar finiteElementForce, Scalar interpolatedForce) noexcept {
    correct(travelled, finiteElementForce, gains_.finiteElements, gains_.finiteElementsStiffness);
    correct(travelled, interpolatedForce, gains_.interpolation, gains_.interpolationStiffness);
    return force_;
  }

 private:
  constexpr void correct(
      Scalar travelled, Scalar measured, Scalar gain, Scalar gainStiffness) noexcept {
    force_ += stiffness_ * travelled;
    const Scalar innovation = measured - force_;
    force_ += gain * innovation;
    stiffness_ += gainStiffness * innovation;
  }

  Gains gains_;
  Scalar force_{};
  Scalar stiffness_{};
};

}  // namespace haptics::models
