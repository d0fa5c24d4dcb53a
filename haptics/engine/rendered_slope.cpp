#include "haptics/engine/rendered_slope.h"

#include <algorithm>
#include <cmath>
#include <variant>

#include "haptics/engine/compiled_scene.h"

namespace haptics::engine {
namespace {

// The sweep that the header describes; speeds in displayed units per second.
constexpr int kPositions = 40;
constexpr double kStrokeSpeeds[]{10.0, 45.0};
constexpr double kSlowSpeeds[]{0.1, 1.0};
constexpr double kRestTime = 0.4;          // [s]
constexpr double kSettledTime = 0.2;       // after it a force at rest should be constant [s]
constexpr double kLeastLimitCycle = 1e-3;  // larger peak-to-peak forces at rest are one [N]
constexpr double kSlowStrokeTime = 0.25;   // duration of each direction [s]
// Fraction of the range; smaller motions are rounding errors of a resting tool.
constexpr double kLeastMove = 1e-9;

/// Renders a scene tick by tick along the sweep, and keeps the largest slope.
class Sweep {
 public:
  Sweep(const SceneSpec& spec, const devices::DeviceKind& kind, double rate)
      : scene_(spec), rate_(rate), least_(kind.travel.least), shownUnit_(1.0 / kind.shown.factor) {
    const double end = endOfData(spec.model).value_or(kind.travel.most);
    const double most = std::max(kind.travel.most, end);
    const double beyond = 0.05 * (most - least_);  // a hand overshoots the end of the travel
    most_ = most + beyond;
    for (const auto& jump : jumpsOf(spec.model)) least_ = std::min(least_, jump.travel - beyond);
    travel_ = least_;
    measureStep();
  }

  RenderedSlope run() {
    for (const double speed : kStrokeSpeeds) {
      moveTo(most_, speed);
      moveTo(least_, speed);
      reverseEveryTenth(speed);
    }
    visitPositions(false);
    visitPositions(true);
    return result_;
  }

 private:
  double range() const noexcept { return most_ - least_; }

  void measureStep() noexcept {
    const double moved = travel_ - lastTravel_;
    const auto response =
        scene_.respond({.travel = travel_, .velocity = moved * rate_, .dt = 1.0 / rate_});
    if (response.isDefined && hasForce_) {
      const double step = std::abs(response.force - force_);
      if (std::abs(moved) > kLeastMove * range()) {
        result_.steepest = std::max(result_.steepest, step / std::abs(moved));
      } else {
        result_.largestStepAtRest = std::max(result_.largestStepAtRest, step);
      }
    }
    hasForce_ = response.isDefined;
    force_ = response.force;
    lastTravel_ = travel_;
  }

  /// @param speed  [shown unit/s]
  void moveTo(double goal, double speed) noexcept {
    const double from = travel_;
    const double seconds = std::abs(goal - from) / (speed * shownUnit_);
    const auto ticks = std::max(1L, std::lround(seconds * rate_));
    for (long i = 1; i <= ticks; ++i) {
      travel_ = from + (goal - from) * static_cast<double>(i) / static_cast<double>(ticks);
      measureStep();
    }
  }

  void reverseEveryTenth(double speed) noexcept {
    for (int i = 1; i <= 10; ++i) {
      moveTo(least_ + 0.1 * i * range(), speed);
      moveTo(travel_ - 0.05 * range(), speed);
    }
    moveTo(least_, speed);
  }

  void visitPositions(bool isOpening) noexcept {
    constexpr double kApproach = kStrokeSpeeds[0];
    moveTo(isOpening ? most_ : least_, kApproach);
    for (int i = 0; i < kPositions; ++i) {
      const double share = (i + 0.5) / kPositions;
      moveTo(least_ + (isOpening ? 1.0 - share : share) * range(), kApproach);
      rest();
      for (const double speed : kSlowSpeeds) {
        const double place = travel_;
        const double stretch = (isOpening ? -1.0 : 1.0) * speed * shownUnit_ * kSlowStrokeTime;
        moveTo(place + stretch, speed);
        moveTo(place, speed);
      }
    }
  }

  void rest() noexcept {
    double low = 0.0;
    double high = 0.0;
    int turns = 0;
    double lastStep = 0.0;
    const auto settling = std::lround(kSettledTime * rate_);
    const auto ticks = std::lround(kRestTime * rate_);
    for (long i = 0; i < ticks; ++i) {
      const double before = force_;
      measureStep();
      if (i < settling) continue;
      low = i == settling ? force_ : std::min(low, force_);
      high = i == settling ? force_ : std::max(high, force_);
      const double step = force_ - before;
      if (step * lastStep < 0.0) ++turns;
      if (step != 0.0) lastStep = step;
    }
    const double amplitude = high - low;
    const double known = result_.limitCycle ? result_.limitCycle->amplitude : kLeastLimitCycle;
    if (!(amplitude > known)) return;
    // A period has two reversals.
    const double frequency = 0.5 * turns * rate_ / static_cast<double>(ticks - settling - 1);
    if (turns > 1) result_.limitCycle = {amplitude, frequency, travel_};
  }

  CompiledScene scene_;
  double rate_;
  double least_;
  double most_ = 0.0;
  double shownUnit_;  ///< one displayed unit [travel unit]
  double travel_ = 0.0;
  double lastTravel_ = 0.0;
  double force_ = 0.0;
  bool hasForce_ = false;
  RenderedSlope result_;
};

SceneSpec withoutJitter(SceneSpec spec) {
  if (auto* material = std::get_if<MaterialSpec>(&spec.model)) material->jitter = {};
  return spec;
}

/// RMS of the noise that @p spec renders [N].
double jitterOf(const SceneSpec& spec) {
  const auto* material = partsOf(spec.model).material;
  // Bone that is removed has jitter only where the reamer can advance.
  if (material == nullptr || !(largestFeedOf(spec) > 0.0)) return 0.0;
  return material->forceScale * material->jitter.rms;
}

}  // namespace

RenderedSlope renderedSlope(const SceneSpec& spec, const devices::DeviceKind& kind, double rate) {
  using Basis = RenderedSlope::Basis;
  const double jitter = jitterOf(spec);
  const SceneSpec still = withoutJitter(spec);
  RenderedSlope slope;
  if (const auto bound = CompiledScene(still).slopeBound()) {
    slope.steepest = bound->slope;
    slope.basis = bound->isSampled ? Basis::Sampled : Basis::Proved;
  } else {
    slope = Sweep(still, kind, rate).run();
  }
  slope.jitter = jitter;
  return slope;
}

}  // namespace haptics::engine
