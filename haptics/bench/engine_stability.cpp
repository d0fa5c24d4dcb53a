// The engine at unusual rates, with clock jitter, and with NaN.
#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <utility>

#include "haptics/bench/stability.h"
#include "haptics/devices/hand.h"
#include "haptics/devices/punch/punch_kind.h"
#include "haptics/devices/simulated_device.h"
#include "haptics/engine/built_in_models.h"
#include "haptics/engine/force_engine.h"
#include "haptics/engine/passivity.h"
#include "haptics/engine/rendered_slope.h"
#include "haptics/recordings/cut.h"

namespace haptics::bench {
namespace {

// For schemes that use the two forces alternately, such as paper-text: the bound of the largest
// change of force between two ticks with quantised travel, and of the largest amplitude with a
// resting hand [N].
constexpr double kPublishedChatter = 4.0;

using Scenes = std::vector<std::pair<std::string, engine::SceneSpec>>;

Scenes allScenes() {
  using models::KalmanScheme;
  auto hysteresis = engine::publishedInterpolation();
  hysteresis.branches = engine::Branches::Hysteresis;
  const auto cut = recordings::parametricCut();
  for (const auto& node : cut.opening->nodes()) {
    hysteresis.opening.push_back({node.travel, node.force});
  }
  auto plastic = engine::publishedElements(5);
  plastic.parameters.yielding = models::YieldLaw::ReturnMap;
  return {
      {"interpolation", {.model = engine::publishedInterpolation()}},
      {"interpolation, hysteresis", {.model = hysteresis}},
      {"finite elements", {.model = engine::publishedElements(5)}},
      {"finite elements, return-map", {.model = plastic}},
      {"filter, paper-text", {.model = engine::publishedFilter(KalmanScheme::PaperText, 5)}},
      {"filter, authors-firmware",
       {.model = engine::publishedFilter(KalmanScheme::AuthorsFirmware, 5)}},
      {"filter, space-domain", {.model = engine::publishedFilter(KalmanScheme::SpaceDomain, 5)}}};
}

/// A device with prescribed samples.
class ScriptedDevice final : public devices::Device {
 public:
  const devices::Capabilities& capabilities() const noexcept override { return capabilities_; }
  devices::DeviceSample read(double) noexcept override { return sample; }
  void command(double force, double /*torque*/) noexcept override { commanded = force; }

  devices::DeviceSample sample{.status = devices::DeviceStatus::Ok};
  double commanded = 0.0;

 private:
  devices::Capabilities capabilities_ = devices::simulated(devices::punchKind());
};

/// The tool closes at constant speed through elastic tissue, and the force is held over each tick.
/// Returns the relative deviation of its mean error from K v T / 2, which eq. (25) predicts.
double forceErrorAgainstEquation(double rate) {
  constexpr double kSpeed = 57.0;
  constexpr int kTicksInside = 200;
  engine::CompiledScene held({.model = engine::publishedElements(5)});
  engine::CompiledScene moving({.model = engine::publishedElements(5)});
  const double period = 1.0 / rate;
  const auto ticks = std::max(1, static_cast<int>(3.5 / (kSpeed * period)));  // from 4.1 to 7.6
  double sum = 0.0;
  for (int i = 0; i < ticks; ++i) {
    const double from = 4.1 + kSpeed * period * i;
    const double force = held.respond({.travel = from}).force;
    for (int k = 0; k < kTicksInside; ++k) {
      const double travel = from + kSpeed * period * (k + 0.5) / kTicksInside;
      sum += moving.respond({.travel = travel}).force - force;
    }
  }
  const engine::Passivity passivity{.stiffness = held.largestStiffness(), .period = period};
  return std::abs(sum / (ticks * kTicksInside) / passivity.forceErrorAt(kSpeed) - 1.0);
}

/// Force of the space-domain filter at 6 travel units, after closing at 10 travel units/s [N].
double forceAtSixAfterSettling(double rate) {
  engine::CompiledScene scene(
      {.model = engine::publishedFilter(models::KalmanScheme::SpaceDomain, 5)});
  double force = 0.0;
  const auto steps = static_cast<long>(std::lround(0.6 * rate));
  for (long i = 0; i <= steps; ++i) {
    force =
        scene.respond({.travel = 6.0 * static_cast<double>(i) / static_cast<double>(steps)}).force;
  }
  return force;
}

/// Largest change of the force between ticks while the tool moves slowly through a cut, seen
/// through an encoder of resolution @p quantum.
double largestStep(const engine::SceneSpec& spec, double quantum, double speed) {
  engine::CompiledScene scene(spec);
  double last = 0.0;
  double largest = 0.0;
  const int ticks = static_cast<int>(8.5 / speed * 1000.0);
  for (int i = 0; i < ticks; ++i) {
    const double travel = quantum * std::round((2.0 + speed * 1e-3 * i) / quantum);
    const double force = scene.respond({.travel = travel}).force;
    if (i > 0) largest = std::max(largest, std::abs(force - last));
    last = force;
  }
  return largest;
}

/// With a resting hand the force must be constant, except with paper-text, whose limit cycle must
/// be found.
void sweepRestingHand(StabilityResult& result) {
  SweepChecks checks(result, "rest");
  for (const auto& [name, spec] : allScenes()) {
    for (const double rate : {375.0, 1000.0}) {
      const auto slope = engine::renderedSlope(spec, devices::punchKind(), rate);
      const double amplitude = slope.limitCycle ? slope.limitCycle->amplitude : 0.0;
      const bool alternates = name == "filter, paper-text";
      checks.add(
          "force that alternates on a resting hand [N], " + name,
          rate,
          amplitude,
          alternates ? kPublishedChatter : 1e-3);
      if (!alternates) continue;
      const double expected = rate / 2.0;
      checks.add(
          "its frequency is not found as half the rate, relative, " + name,
          rate,
          slope.limitCycle ? std::abs(slope.limitCycle->frequency / expected - 1.0) : INFINITY,
          0.01);
    }
  }
}

/// A step of the encoder must change the force by at most K times its size, except with paper-text,
/// whose two forces alternate with any encoder.
void sweepEncoders(StabilityResult& result) {
  SweepChecks checks(result, "encoder");
  for (const auto& [name, spec] : allScenes()) {
    const double stiffness = engine::CompiledScene(spec).largestStiffness();
    for (const double quantum : {0.0439, 0.176}) {
      for (const double speed : {0.5, 2.0}) {
        const bool alternates = name == "filter, paper-text";
        checks.add(
            "largest step [N] at " + std::string(speed < 1.0 ? "0.5" : "2") + " units/s, " + name,
            quantum,
            largestStep(spec, quantum, speed),
            alternates ? kPublishedChatter : stiffness * quantum * (1.0 + 1e-9));
      }
    }
  }
}

}  // namespace

void sweepRates(double effort, StabilityResult& result) {
  sweepRestingHand(result);
  sweepEncoders(result);
  SweepChecks checks(result, "rate");
  for (const double rate : {25.0, 100.0, 375.0, 1000.0, 2000.0, 4000.0, 8000.0}) {
    checks.add(
        "held force against K v T / 2, relative", rate, forceErrorAgainstEquation(rate), 1e-9);
  }
  const double reference = forceAtSixAfterSettling(64'000.0);
  for (const double rate : {375.0, 1000.0, 4000.0, 8000.0}) {
    checks.add(
        "space-domain: force at 6 units against 64 kHz [N]",
        rate,
        std::abs(forceAtSixAfterSettling(rate) - reference),
        0.02);
  }
  // Clock jitter: periods between a fifth and five times the nominal one.
  for (const auto& [name, spec] : allScenes()) {
    devices::SimulatedHand hand({.variation = 0.3, .seed = 3});
    devices::SimulatedDevice device(devices::punchKind(), hand);
    constexpr engine::SafetyLimits kLimits{.maxForce = 6.0, .maxRate = 300.0};
    engine::ForceEngine engine(device, kLimits);
    engine::CompiledScene scene(spec);
    engine.setScene(&scene);
    std::mt19937_64 random(11);
    std::uniform_real_distribution<double> exponent(std::log(0.2e-3), std::log(5e-3));
    double last = 0.0;
    int wrong = 0;
    for (int i = 0; i < static_cast<int>(effort * 30'000); ++i) {
      const double dt = std::exp(exponent(random));
      const auto sample = engine.tick(dt, static_cast<int>(dt / 1e-3));
      const bool isSound = std::isfinite(sample.force) &&
                           std::abs(sample.force) <= kLimits.maxForce &&
                           std::abs(sample.force - last) <= kLimits.maxRate * dt * (1.0 + 1e-9);
      wrong += isSound ? 0 : 1;
      last = sample.force;
    }
    checks.add("period × 0.2 to 5: forces beyond a limit, " + name, 0.0, wrong, 0.0);
  }
}

void sweepBadInput(double effort, StabilityResult& result) {
  SweepChecks checks(result, "bad input");
  constexpr double kTiny = std::numeric_limits<double>::denorm_min();
  const double bad[]{
      NAN,
      -NAN,
      INFINITY,
      -INFINITY,
      kTiny,
      -kTiny,
      1e-310,
      0.0,
      -0.0,
      1e308,
      -1e308,
      1e155,
      -1e155,
      1e17,
      4.0,
      11.0};
  const devices::DeviceStatus statuses[]{
      devices::DeviceStatus::Ok,
      devices::DeviceStatus::Ok,
      devices::DeviceStatus::Ok,
      devices::DeviceStatus::Stale,
      devices::DeviceStatus::Faulted,
      devices::DeviceStatus::NotAnswering};
  for (const auto& [name, spec] : allScenes()) {
    ScriptedDevice device;
    constexpr engine::SafetyLimits kLimits{
        .maxForce = 6.0, .maxRate = 300.0, .isPassivityControlled = true};
    engine::ForceEngine engine(device, kLimits);
    engine::CompiledScene scene(spec);
    engine.setScene(&scene);
    std::mt19937_64 random(13);
    const auto any = [&](double usual) {
      return random() % 3 == 0 ? bad[random() % std::size(bad)] : usual;
    };
    int wrong = 0;
    for (int i = 0; i < static_cast<int>(effort * 200'000); ++i) {
      device.sample = {
          .status = random() % 4 == 0 ? statuses[random() % std::size(statuses)]
                                      : devices::DeviceStatus::Ok,
          .travel = any(5.0 + 5.0 * std::sin(0.01 * i)),
          .velocity = any(10.0),
          .isDeadManHeld = random() % 50 != 0};
      engine.tick(any(1e-3), static_cast<int>(random() % 4));
      if (random() % 20 == 0) engine.arm();
      const bool isSound =
          std::isfinite(device.commanded) && std::abs(device.commanded) <= kLimits.maxForce;
      wrong += isSound ? 0 : 1;
    }
    // After invalid input the engine must render the same force as an engine that never had any:
    // the tool opens, then closes to 5 travel units. Compare means of two ticks, because the
    // scheme paper-text alternates between two forces, and which comes first depends on the number
    // of valid ticks before.
    const auto forceAtFive = [](engine::ForceEngine& what, ScriptedDevice& through) {
      what.arm();
      through.sample = {.status = devices::DeviceStatus::Ok, .travel = 0.0};
      for (int i = 0; i < 300; ++i) what.tick(1e-3);
      for (int i = 0; i <= 500; ++i) {
        through.sample.travel = 0.01 * i;
        what.tick(1e-3);
      }
      for (int i = 0; i < 100; ++i) what.tick(1e-3);
      const double before = through.commanded;
      what.tick(1e-3);
      return 0.5 * (before + through.commanded);
    };
    const double after = forceAtFive(engine, device);
    ScriptedDevice fresh;
    engine::ForceEngine unaffected(fresh, kLimits);
    engine::CompiledScene same(spec);
    unaffected.setScene(&same);
    const double usual = forceAtFive(unaffected, fresh);
    checks.add(
        "forces that are no number or too large, " + name, 0.0, static_cast<double>(wrong), 0.0);
    checks.add(
        "difference of the force afterwards [N], " + name,
        0.0,
        std::isfinite(after) ? std::abs(after - usual) : INFINITY,
        0.02);
  }
}

void SweepChecks::add(
    std::string what,
    double parameter,
    double measured,
    double bound,
    const char* build,
    int elements) {
  result_.checks.push_back(
      {.sweep = sweep_,
       .what = std::move(what),
       .build = build,
       .parameter = parameter,
       .measured = std::isnan(measured) ? INFINITY : measured,
       .bound = bound,
       .elements = elements});
}

StabilityResult runStability(
    double effort, const std::function<void(const std::string&)>& progress) {
  StabilityResult result;
  const std::pair<const char*, void (*)(double, StabilityResult&)> sweeps[]{
      {"finite elements over 24 decades", sweepFiniteElements},
      {"Kalman filter over 24 decades", sweepFilter},
      {"splines over 600 decades", sweepSplines},
      {"virtual walls", sweepWalls},
      {"encoders, rates and a clock that trembles", sweepRates},
      {"numbers that are none", sweepBadInput},
      {"reaming", sweepReaming}};
  for (const auto& [name, sweep] : sweeps) {
    progress(name);
    sweep(effort, result);
  }
  return result;
}

}  // namespace haptics::bench
