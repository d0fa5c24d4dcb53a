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

/// An interpolation curve that owns its nodes and their search index.
class IndexedCurve {
 public:
  /// @param nodes  valid, see problemsOf().
  IndexedCurve(
      std::vector<models::CurveNode<double>> nodes,
      const models::Interpolation<double>::Options& options);
  // A moved vector keeps its buffer, to which curve_ points.
  IndexedCurve(IndexedCurve&&) noexcept = default;
  IndexedCurve& operator=(IndexedCurve&&) = delete;

  const models::Interpolation<double>& curve() const noexcept { return curve_; }
  /// Largest magnitude of the slope between two neighbouring nodes, or of a ramp beyond the ends
  /// (RampOut) [N/travel unit].
  double largestSlope() const noexcept;
  bool hasJumpAtEnd() const noexcept;
  std::size_t bytes() const noexcept;  ///< memory of nodes and search index

 private:
  std::vector<models::CurveNode<double>> nodes_;
  models::Interpolation<double>::Options options_;
  BucketTable table_;
  models::Interpolation<double> curve_;
};

/// The forces of both branches of a cut at one travel.
struct BranchForces {
  double travel = 0.0;   ///< [travel units]
  double closing = 0.0;  ///< [N]
  double opening = 0.0;  ///< [N]
};

/// The forces of both branches of @p spec wherever the slope of either changes, and on both sides
/// of a jump; in between both are linear, so their difference is largest at one of these travels.
/// Travels at which a branch is undefined are left out.
///
/// @param spec  valid, see problemsOf(), with hysteresis.
std::vector<BranchForces> branchesAtKinks(const InterpolationSpec& spec);

/// Force of a recorded cut over travel, with an opening branch if the spec has hysteresis.
class InterpolationModel final : public ForceModel {
 public:
  /// @param spec  valid, see problemsOf().
  explicit InterpolationModel(const InterpolationSpec& spec);

  models::Response<double> respond(const ToolState& tool) noexcept override;
  void reset() noexcept override;
  double largestStiffness() const noexcept override;
  /// std::nullopt if the curve ends in a jump.
  std::optional<SlopeBound> slopeBound() const noexcept override;
  /// The weight of the recording as a measurement at @p travel [travel units], in [0, 1].
  double measurementWeightAt(double travel) const noexcept;
  std::size_t bytes() const noexcept;

 private:
  struct Opening {
    IndexedCurve curve;
    models::Hysteresis<double> hysteresis;
    double steepestTransition = 0.0;  ///< [N per travel unit]
  };

  IndexedCurve closing_;
  std::unique_ptr<Opening> opening_;
  std::size_t hint_ = 0;
  models::Hysteresis<double>::State state_;
};

/// Force of the elastic, perfectly plastic finite elements.
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

/// Interpolation and finite elements, fused by a Kalman filter, and smoothed.
template <typename Filter>
class KalmanModel final : public ForceModel {
 public:
  /// @param spec  valid, see problemsOf().
  KalmanModel(const KalmanSpec& spec, const typename Filter::Noise& noise);

  models::Response<double> respond(const ToolState& tool) noexcept override;
  void reset() noexcept override;
  double largestStiffness() const noexcept override;
  /// The force depends on past motion, so the slopes of the two fused forces do not bound it.
  std::optional<SlopeBound> slopeBound() const noexcept override { return std::nullopt; }
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
/// With the process noise Q exactly as the punch paper prints it in eq. (22): not symmetric.
using KalmanModelWithPrintedNoise =
    KalmanModel<models::KalmanFilter<double, models::TextbookCovariance>>;
extern template class KalmanModel<models::KalmanFilter<double>>;
extern template class KalmanModel<models::KalmanFilter<double, models::TextbookCovariance>>;

/// The steady-state weight of the interpolated force in the filter's output, from 0 (only finite
/// elements) to 1 (only the recording), for a hand that moves 0.02 travel units per step. It is the
/// mean of two steps, since some schemes use the two forces alternately. Smoothing does not affect
/// the weight.
///
/// @param spec  valid, see problemsOf().
double interpolationWeight(const KalmanSpec& spec) noexcept;

}  // namespace haptics::engine
