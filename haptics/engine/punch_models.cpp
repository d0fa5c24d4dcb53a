#include "haptics/engine/punch_models.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace haptics::engine {

InterpolationModel::InterpolationModel(InterpolationSpec spec)
    : spec_(std::move(spec)), curve_(spec_.curve.data(), spec_.curve.size(), spec_.options) {}

models::Response<double> InterpolationModel::respond(const ToolState& tool) noexcept {
  return curve_.at(tool.travel, hint_);
}

double InterpolationModel::largestStiffness() const noexcept {
  double largest = 0.0;
  for (std::size_t i = 1; i < spec_.curve.size(); ++i) {
    const auto& a = spec_.curve[i - 1];
    const auto& b = spec_.curve[i];
    largest = std::max(largest, std::abs((b.force - a.force) / (b.travel - a.travel)));
  }
  if (spec_.options.beyond == models::BeyondCurve::RampOut) {
    const double end =
        std::max(std::abs(spec_.curve.front().force), std::abs(spec_.curve.back().force));
    largest = std::max(largest, end / spec_.options.rampLength);
  }
  return largest;
}

template <typename Filter>
KalmanModel<Filter>::KalmanModel(const KalmanSpec& spec, const typename Filter::Noise& noise)
    : interpolation_(spec.interpolation),
      finiteElements_(spec.finiteElements),
      filter_(noise, spec.scheme),
      average_(spec.smoothing) {}

template <typename Filter>
models::Response<double> KalmanModel<Filter>::respond(const ToolState& tool) noexcept {
  const auto recorded = interpolation_.respond(tool);
  const auto elastic = finiteElements_.respond(tool);
  if (!recorded.isDefined || !elastic.isDefined) return {};

  const double travelled = hasTravel_ ? tool.travel - lastTravel_ : 0.0;
  lastTravel_ = tool.travel;
  hasTravel_ = true;
  const double force = average_.feed(filter_.step(travelled, elastic.force, recorded.force));
  if (!std::isfinite(force)) {  // a leap that no hand makes: begin anew
    reset();
    return {};
  }
  return {force, filter_.stiffness(), true};
}

template <typename Filter>
void KalmanModel<Filter>::reset() noexcept {
  interpolation_.reset();
  finiteElements_.reset();
  filter_.reset();
  average_.reset();
  hasTravel_ = false;
}

template <typename Filter>
double KalmanModel<Filter>::largestStiffness() const noexcept {
  return std::max(interpolation_.largestStiffness(), finiteElements_.largestStiffness());
}

template class KalmanModel<models::KalmanFilter<double>>;
template class KalmanModel<models::KalmanFilter<double, models::TextbookCovariance>>;

}  // namespace haptics::engine
