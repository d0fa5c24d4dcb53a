#pragma once

#include "haptics/models/covariance.h"
#include "haptics/models/finite.h"
#include "haptics/models/kalman_filter.h"

namespace haptics::models {

/// What can be made of the process noise that eq. (22) of the punch paper prints:
/// [7.0275 0.02772; 0.2772 6.1024].
enum class ProcessReading {
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
  static constexpr KalmanNoise published(ProcessReading reading) noexcept {
    KalmanNoise noise;
    if (reading == ProcessReading::StateOrder) {
      noise.processForce = Scalar(6.1024);
      noise.processStiffness = Scalar(7.0275);
    }
    if (reading == ProcessReading::Product) {
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

}  // namespace haptics::models
