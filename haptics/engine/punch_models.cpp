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

KalmanModel::KalmanModel(const KalmanSpec& spec)
    : interpolation_(spec.interpolation),
      finiteElements_(spec.finiteElements),
      filter_(spec.noise) {}

models::Response<double> KalmanModel::respond(const ToolState& tool) noexcept {
  const auto recorded = interpolation_.respond(tool);
  const auto elastic = finiteElements_.respond(tool);
  if (!recorded.isDefined || !elastic.isDefined) return {};

  const double travelled = hasTravel_ ? tool.travel - lastTravel_ : 0.0;
  lastTravel_ = tool.travel;
  hasTravel_ = true;
  const double force = filter_.step(travelled, elastic.force, recorded.force);
  if (!std::isfinite(force)) {  // a leap that no hand makes: begin anew
    reset();
    return {};
  }
  return {force, filter_.stiffness(), true};
}

void KalmanModel::reset() noexcept {
  interpolation_.reset();
  finiteElements_.reset();
  filter_.reset();
  hasTravel_ = false;
}

double KalmanModel::largestStiffness() const noexcept {
  return std::max(interpolation_.largestStiffness(), finiteElements_.largestStiffness());
}

}  // namespace haptics::engine
