#include "haptics/engine/punch_models.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace haptics::engine {
namespace {

std::vector<double> travelsOf(const std::vector<models::CurveNode<double>>& nodes) {
  std::vector<double> travels;
  for (const auto& node : nodes) travels.push_back(node.travel);
  return travels;
}

/// Delay of a slow change of force [ticks]: 0.5 for the mean of two samples. For the authors'
/// filter it is 1.5 from the two old samples, plus 0.5 from the feedback.
double delayOf(models::Smoothing smoothing) {
  if (smoothing == models::Smoothing::TwoPoint) return 0.5;
  return smoothing == models::Smoothing::AuthorsFirmware ? 2.0 : 0.0;
}

/// Appends the travels between which a curve of @p nodes is linear.
void addKinks(
    const std::vector<models::CurveNode<double>>& nodes,
    const models::Interpolation<double>::Options& options,
    std::vector<double>& travels) {
  using Curve = models::Interpolation<double>;
  constexpr double kFar = std::numeric_limits<double>::infinity();
  for (const auto& node : nodes) travels.push_back(node.travel);
  const double first = nodes.front().travel;
  const double last = nodes.back().travel;
  switch (options.extrapolation) {
    case models::Extrapolation::RampOut:
      travels.insert(travels.end(), {first - options.rampLength, last + options.rampLength});
      return;
    case models::Extrapolation::Hold:
    case models::Extrapolation::Absent:
      return;
    case models::Extrapolation::AuthorsClamp:
      for (std::size_t i = 1; i < nodes.size(); ++i) {
        const auto& a = nodes[i - 1];
        const auto& b = nodes[i];
        for (const double limit : {Curve::kAuthorsMinForce, Curve::kAuthorsMaxForce}) {
          const double share = (limit - a.force) / (b.force - a.force);
          if (share > 0.0 && share < 1.0) {
            travels.push_back(a.travel + share * (b.travel - a.travel));
          }
        }
      }
      [[fallthrough]];
    case models::Extrapolation::Zero:  // a jump beside each end
      travels.insert(travels.end(), {std::nextafter(first, -kFar), std::nextafter(last, kFar)});
  }
}

/// Largest slope added by the transition between the branches: their largest force difference over
/// the width of the transition [N per travel unit].
double steepestTransition(const InterpolationSpec& spec) {
  double widest = 0.0;
  for (const auto& forces : branchesAtKinks(spec)) {
    widest = std::max(widest, std::abs(forces.closing - forces.opening));
  }
  return widest / spec.transitionWidth;
}

}  // namespace

std::vector<BranchForces> branchesAtKinks(const InterpolationSpec& spec) {
  std::vector<double> travels;
  addKinks(spec.curve, spec.options, travels);
  addKinks(spec.opening, spec.options, travels);
  using Curve = models::Interpolation<double>;
  const Curve closing(spec.curve.data(), spec.curve.size(), spec.options);
  const Curve opening(spec.opening.data(), spec.opening.size(), spec.options);
  std::vector<BranchForces> all;
  for (const double travel : travels) {
    std::size_t hint = 0;
    std::size_t other = 0;
    const auto closed = closing.at(travel, hint);
    const auto opened = opening.at(travel, other);
    if (closed.isDefined && opened.isDefined) all.push_back({travel, closed.force, opened.force});
  }
  return all;
}

IndexedCurve::IndexedCurve(
    std::vector<models::CurveNode<double>> nodes,
    const models::Interpolation<double>::Options& options)
    : nodes_(std::move(nodes)),
      options_(options),
      table_(travelsOf(nodes_)),
      curve_(nodes_.data(), nodes_.size(), options_, table_.index()) {}

std::size_t IndexedCurve::bytes() const noexcept {
  return nodes_.size() * sizeof(nodes_[0]) + table_.bytes();
}

double IndexedCurve::largestSlope() const noexcept {
  double largest = 0.0;
  for (std::size_t i = 1; i < nodes_.size(); ++i) {
    const auto& a = nodes_[i - 1];
    const auto& b = nodes_[i];
    largest = std::max(largest, std::abs((b.force - a.force) / (b.travel - a.travel)));
  }
  if (options_.extrapolation == models::Extrapolation::RampOut) {
    const double end = std::max(std::abs(nodes_.front().force), std::abs(nodes_.back().force));
    largest = std::max(largest, end / options_.rampLength);
  }
  return largest;
}

bool IndexedCurve::hasJumpAtEnd() const noexcept {
  const double first = nodes_.front().force;
  const double last = nodes_.back().force;
  switch (options_.extrapolation) {
    case models::Extrapolation::RampOut:
    case models::Extrapolation::Hold:
      return false;
    case models::Extrapolation::Zero:
    case models::Extrapolation::Absent:
      return first != 0.0 || last != 0.0;
    case models::Extrapolation::AuthorsClamp:
      constexpr double kSmallestForce = models::Interpolation<double>::kAuthorsMinForce;
      return first > kSmallestForce || last > kSmallestForce;
  }
  return true;
}

InterpolationModel::InterpolationModel(const InterpolationSpec& spec)
    : closing_(spec.curve, spec.options) {
  if (spec.branches == Branches::ClosingOnly) return;
  IndexedCurve opening(spec.opening, spec.options);
  const models::Hysteresis<double> hysteresis(
      closing_.curve(), opening.curve(), spec.transitionWidth);
  opening_ =
      std::make_unique<Opening>(Opening{std::move(opening), hysteresis, steepestTransition(spec)});
}

models::Response<double> InterpolationModel::respond(const ToolState& tool) noexcept {
  if (opening_ != nullptr) return opening_->hysteresis.at(tool.travel, state_);
  return closing_.curve().at(tool.travel, hint_);
}

void InterpolationModel::reset() noexcept {
  hint_ = 0;
  state_ = {};
}

double InterpolationModel::largestStiffness() const noexcept {
  const double closing = closing_.largestSlope();
  if (opening_ == nullptr) return closing;
  return std::max(closing, opening_->curve.largestSlope()) + opening_->steepestTransition;
}

std::optional<SlopeBound> InterpolationModel::slopeBound() const noexcept {
  const bool hasJump =
      closing_.hasJumpAtEnd() || (opening_ != nullptr && opening_->curve.hasJumpAtEnd());
  if (hasJump) return std::nullopt;
  return ForceModel::slopeBound();
}

double InterpolationModel::measurementWeightAt(double travel) const noexcept {
  const double closing = closing_.curve().measurementWeightAt(travel);
  if (opening_ == nullptr) return closing;
  return std::min(closing, opening_->curve.curve().measurementWeightAt(travel));
}

std::size_t InterpolationModel::bytes() const noexcept {
  return sizeof(*this) + closing_.bytes() +
         (opening_ != nullptr ? sizeof(Opening) + opening_->curve.bytes() : 0);
}

template <typename Filter>
KalmanModel<Filter>::KalmanModel(const KalmanSpec& spec, const typename Filter::Noise& noise)
    : interpolation_(spec.interpolation),
      finiteElements_(spec.finiteElements),
      filter_(noise, spec.scheme),
      average_(spec.smoothing),
      delay_(delayOf(spec.smoothing)) {}

template <typename Filter>
models::Response<double> KalmanModel<Filter>::respond(const ToolState& tool) noexcept {
  const auto recorded = interpolation_.respond(tool);
  const auto elastic = finiteElements_.respond(tool);
  const double trust = interpolation_.measurementWeightAt(tool.travel);
  if (!elastic.isDefined || (!recorded.isDefined && trust > 0.0)) return {};

  const double travelled = hasTravel_ ? tool.travel - lastTravel_ : 0.0;
  lastTravel_ = tool.travel;
  hasTravel_ = true;
  const double force = average_.feed(filter_.step(travelled, elastic.force, recorded.force, trust));
  if (!std::isfinite(force)) {  // only an impossible motion causes this: start again
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

namespace {

/// Steady output of a filter that fuses 0 N and 1 N. The tool moves back and forth, so that the
/// filter estimates no slope.
template <typename Filter>
double steadyOutput(Filter filter) noexcept {
  constexpr double kStep = 0.02;  // [travel units]: 20 a second at 1 kHz
  constexpr int kSteps = 20'000;
  double last = 0.0;
  double force = 0.0;
  for (int i = 0; i < kSteps; ++i) {
    last = force;
    force = filter.step(i / 100 % 2 == 0 ? kStep : -kStep, 0.0, 1.0);
  }
  return 0.5 * (last + force);
}

}  // namespace

double interpolationWeight(const KalmanSpec& spec) noexcept {
  using Printed = models::KalmanFilter<double, models::TextbookCovariance>;
  if (spec.isProcessAsPrinted) return steadyOutput(Printed(spec.noise.asPrinted(), spec.scheme));
  return steadyOutput(models::KalmanFilter<double>(spec.noise.factored(), spec.scheme));
}

}  // namespace haptics::engine
