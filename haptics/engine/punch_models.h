#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "haptics/engine/bucket_table.h"
#include "haptics/engine/force_model.h"
#include "haptics/engine/scene_spec.h"
#include "haptics/models/interpolation.h"

namespace haptics::engine {

/// The nodes of a curve with the index for searching them.
class IndexedCurve {
 public:
  /// @param nodes  valid, see problemsOf().
  IndexedCurve(
      std::vector<models::CurveNode<double>> nodes,
      const models::Interpolation<double>::Options& options);
  IndexedCurve(IndexedCurve&&) noexcept = default;  // the nodes stay where they are
  IndexedCurve& operator=(IndexedCurve&&) = delete;

  const models::Interpolation<double>& curve() const noexcept { return curve_; }
  double largestSlope() const noexcept;
  bool hasJumpAtEnd() const noexcept;
  std::size_t bytes() const noexcept;

 private:
  std::vector<models::CurveNode<double>> nodes_;
  models::Interpolation<double>::Options options_;
  BucketTable table_;
  models::Interpolation<double> curve_;
};

/// The recorded cut over travel; the opening branch exists only with hysteresis.
class InterpolationModel final : public ForceModel {
 public:
  /// @param spec  valid, see problemsOf().
  explicit InterpolationModel(const InterpolationSpec& spec);

  models::Response<double> respond(const ToolState& tool) noexcept override;
  void reset() noexcept override;
  double largestStiffness() const noexcept override;
  /// std::nullopt if the curve ends in a jump.
  std::optional<double> slopeBound() const noexcept override;
  /// How far the recording is a measurement at @p travel [travel units], in [0, 1].
  double trustAt(double travel) const noexcept;
  std::size_t bytes() const noexcept;

 private:
  struct Opening {
    IndexedCurve curve;
    models::Hysteresis<double> hysteresis;
    double steepestTurn = 0.0;  ///< [N per travel unit]
  };

  IndexedCurve closing_;
  std::unique_ptr<Opening> opening_;
  std::size_t hint_ = 0;
  models::Hysteresis<double>::State state_;
};

/// The elastic, ideally plastic reference.
class FiniteElementModel final : public ForceModel {
 public:
  /// @param spec  valid, see problemsOf().
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
  /// @param spec  valid, see problemsOf().
  KalmanModel(const KalmanSpec& spec, const typename Filter::Noise& noise);

  models::Response<double> respond(const ToolState& tool) noexcept override;
  void reset() noexcept override;
  double largestStiffness() const noexcept override;
  /// Its force depends on what it has felt: not bounded by the slopes of the two that it fuses.
  std::optional<double> slopeBound() const noexcept override { return std::nullopt; }
  double delay() const noexcept override { return delay_; }

 private:
  InterpolationModel interpolation_;
  FiniteElementModel finiteElements_;
  Filter filter_;
  models::MovingAverage<double> average_;
  double delay_;
  bool hasTravel_ = false;
  double lastTravel_ = 0.0;
};

using FactoredKalmanModel = KalmanModel<models::KalmanFilter<double>>;
/// With Q as eq. (22) prints it.
using PrintedKalmanModel = KalmanModel<models::KalmanFilter<double, models::TextbookCovariance>>;
extern template class KalmanModel<models::KalmanFilter<double>>;
extern template class KalmanModel<models::KalmanFilter<double, models::TextbookCovariance>>;

/// How much the interpolated force weighs in what a filter settles to, from 0 (the finite elements
/// alone) to 1 (the recording alone), for a hand that moves 0.02 travel units a step; the mean of
/// two steps where both forces take turns. Smoothing changes nothing of it.
///
/// @param spec  valid, see problemsOf().
double interpolationWeight(const KalmanSpec& spec) noexcept;

}  // namespace haptics::engine
