#pragma once

#include "haptics/models/kalman_filter.h"

namespace haptics::models {

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
