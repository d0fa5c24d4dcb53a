#pragma once

#include <utility>

#include "haptics/engine/force_model.h"
#include "haptics/engine/scene_spec.h"

namespace haptics::engine {

/// The recorded cut, replayed over travel.
class InterpolationModel final : public ForceModel {
 public:
  /// @param spec  sound.
  explicit InterpolationModel(InterpolationSpec spec);

  models::Response<double> respond(const ToolState& tool) noexcept override;
  void reset() noexcept override { hint_ = 0; }
  double largestStiffness() const noexcept override;

 private:
  InterpolationSpec spec_;
  models::Interpolation<double> curve_;
  std::size_t hint_ = 0;
};

/// The elastic, ideally plastic reference.
class FiniteElementModel final : public ForceModel {
 public:
  /// @param spec  sound.
  explicit FiniteElementModel(FiniteElementsSpec spec)
      : spec_(std::move(spec)), elements_(spec_.asParameters()) {}

  models::Response<double> respond(const ToolState& tool) noexcept override {
    return elements_.at(tool.travel, state_);
  }
  void reset() noexcept override { state_ = {}; }
  double largestStiffness() const noexcept override { return elements_.stiffness(); }

 private:
  FiniteElementsSpec spec_;
  models::FiniteElements<double> elements_;
  models::FiniteElements<double>::State state_;
};

/// Both, fused by a filter, and smoothed.
template <typename Filter>
class KalmanModel final : public ForceModel {
 public:
  /// @param spec  sound.
  KalmanModel(const KalmanSpec& spec, const typename Filter::Noise& noise);

  models::Response<double> respond(const ToolState& tool) noexcept override;
  void reset() noexcept override;
  double largestStiffness() const noexcept override;

 private:
  InterpolationModel interpolation_;
  FiniteElementModel finiteElements_;
  Filter filter_;
  models::MovingAverage<double> average_;
  bool hasTravel_ = false;
  double lastTravel_ = 0.0;
};

using FactoredKalmanModel = KalmanModel<models::KalmanFilter<double>>;
/// With Q as eq. (22) prints it.
using PrintedKalmanModel = KalmanModel<models::KalmanFilter<double, models::TextbookCovariance>>;
extern template class KalmanModel<models::KalmanFilter<double>>;
extern template class KalmanModel<models::KalmanFilter<double, models::TextbookCovariance>>;

}  // namespace haptics::engine
