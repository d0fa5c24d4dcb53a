#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "base/joined.h"
#include "haptics/devices/simulated_device.h"
#include "haptics/engine/compiled_scene.h"
#include "haptics/engine/model_names.h"
#include "haptics/engine/passivity.h"
#include "haptics/engine/rendered_slope.h"
#include "protocols/model/loaded_protocol.h"
#include "study/app/command_options.h"
#include "study/app/json_file.h"
#include "study/app/paint_figures.h"
#include "study/app/scene_cost.h"
#include "study/app/scene_play.h"
#include "study/model/new_file.h"
#include "study/model/user_error.h"
#include "study/trial/device_file.h"
#include "study/trial/hardware_device_set.h"

namespace study::app {
namespace {

struct PlayArguments {
  std::string file;
  std::vector<std::string> conditions;
  std::string profile = "closing";
  std::string out;
  std::string xAxis = "travel";
  std::optional<double> from;
  std::optional<double> to;
  std::optional<double> speed;
  std::optional<double> rate;
  double quantum = 0.0;
  std::vector<double> interpolationNoise;
  std::optional<std::string> smoothing;
};

struct ExplainArguments {
  std::string file;
  std::string condition;
  std::string devices;  ///< a device file; empty: the simulated device
  bool visualised = false;
  bool cost = false;
  bool json = false;
};

void printSources(
    const std::vector<protocols::SceneDataSource>& sources, const std::string& condition) {
  for (const auto& source : sources) {
    const auto& all = source.conditions;
    if (std::ranges::find(all, condition) == all.end()) continue;
    fmt::print("\n  felt from {}\n", protocols::describe(source));
  }
}

std::string verdictOn(
    const haptics::engine::Passivity& passivity,
    const haptics::engine::RenderedSlope& slope,
    const haptics::devices::Capabilities& device) {
  if (const auto& cycle = passivity.limitCycle) {
    return fmt::format(
        "FAIL, on a hand that\n  rests the force alternates by {:.4g} N at {:.4g} Hz (largest at a "
        "travel of {:.4g}): no damping takes that up; take another variant, or smooth it",
        cycle->amplitude,
        cycle->frequency,
        cycle->travel);
  }
  if (passivity.isPassiveWith(device.damping)) {
    if (slope.jitter > 0.0) return "PASS without its jitter";
    const bool isProved = slope.basis == haptics::engine::RenderedSlope::Basis::Proved;
    return isProved ? "PASS, whatever the hand does" : "PASS in the motions that were tried";
  }
  return device.kind->tissue == haptics::devices::Tissue::Bone
             ? "WARN, the hand must add the rest; a shorter period of the device needs less"
             : "WARN, the hand must add the rest; \"slope_limit\" makes a cut gentler";
}

/// Prints what the slope does not cover.
void printBasis(
    const haptics::engine::RenderedSlope& slope, const haptics::devices::Capabilities& device) {
  using Basis = haptics::engine::RenderedSlope::Basis;
  if (slope.basis == Basis::Swept) {
    fmt::print(
        "  the slope is the largest of a sweep, not a proved bound: rest at 40 places, 0.1 to 45 "
        "{}/s, reversals, in and out of the recording;\n  at rest the force stepped by at most "
        "{:.3g} N\n",
        device.kind->shown.unit,
        slope.largestStepAtRest);
  } else if (slope.basis == Basis::Sampled) {
    fmt::print(
        "  the slope is the largest between closely spaced depths, not a proved bound: less than a "
        "step may be steeper\n");
  }
  if (slope.jitter > 0.0) {
    fmt::print(
        "  the slope is of the force without its jitter of {:.3g} N (rms), which a hand feels at "
        "rest, too: no damping takes that up\n",
        slope.jitter);
  }
}

/// Prints the stiffness K, the damping that passivity requires, and whether the device has it.
void printPassivity(
    const haptics::engine::CompiledScene& scene,
    const haptics::engine::RenderedSlope& slope,
    const haptics::devices::Capabilities& device) {
  const haptics::engine::Passivity passivity{
      .stiffness = slope.steepest,
      .period = 1.0 / device.rate,
      .filterDelay = scene.delay() / device.rate,
      .limitCycle = slope.limitCycle};
  const auto unit = device.kind->travel.unit;
  fmt::print(
      "\n  stiffest slope {:.4g} N/{}; at {:.0f} Hz passivity (eq. (25), b > KT/2) needs {:.3g} "
      "N·s/{} of damping;\n  the {} has {:.3g} of its own: {}\n",
      slope.steepest,
      unit,
      device.rate,
      passivity.requiredDamping(),
      unit,
      device.name,
      device.damping,
      verdictOn(passivity, slope, device));
  printBasis(slope, device);
}

void printTorque(
    const haptics::engine::CompiledScene& scene, const haptics::devices::Capabilities& device) {
  if (!scene.hasTorque()) return;
  if (device.rendersTorque()) {
    fmt::print("  the {} gives a torque of up to {:g} N·m\n", device.name, device.maxTorque);
  } else {
    fmt::print("  not rendered: torque; the {} gives none\n", device.name);
  }
}

/// Warns if the force jumps at the beginning or end of a curve.
void printJumps(
    const std::vector<haptics::engine::ForceJump>& jumps,
    const haptics::devices::DeviceKind& kind) {
  const bool isCut = kind.tissue == haptics::devices::Tissue::Meniscus;
  for (const auto& jump : jumps) {
    fmt::print(
        "\n  WARN, the recorded force {} from {:.2f} to {:.2f} N at once, at a travel of {:.4g} "
        "{}: take\n  {}\n",
        jump.to < jump.from ? "drops" : "rises",
        jump.from,
        jump.to,
        jump.travel,
        kind.travel.unit,
        isCut ? "\"ramp-out\" or \"absent\", or a cut that ends with no force"
              : "a curve that begins with no force, or set \"removal\" to true");
  }
}

void print(
    const protocols::Condition& condition,
    const haptics::engine::CompiledScene& scene,
    const haptics::engine::RenderedSlope& slope,
    const haptics::devices::Capabilities& device,
    const std::vector<SceneCost>& costs) {
  fmt::print("{} ({}) on a {}\n\n", condition.id, condition.title, condition.device);
  for (const auto& pass : scene.passes()) {
    fmt::print(
        "  {}  {:<34} {}{}\n",
        pass.isInUse ? "in " : "out",
        pass.name,
        pass.why,
        pass.bytes > 0 ? fmt::format(" ({} bytes)", pass.bytes) : "");
  }
  if (!costs.empty()) {
    fmt::print("\n  what a tick takes on this computer [ns]              median      p99\n");
    for (const auto& cost : costs) {
      fmt::print("  {:<52} {:>6.1f}   {:>6.1f}\n", cost.what, cost.time.median, cost.time.p99);
    }
  }
  printPassivity(scene, slope, device);
  printTorque(scene, device);
  printJumps(haptics::engine::jumpsOf(*condition.model), *device.kind);
}

const protocols::Condition& conditionOf(
    const protocols::Protocol& protocol, const std::string& id) {
  if (const auto* condition = protocol.condition(id)) return *condition;
  const auto known = base::joined(protocol.conditions, ", ", &protocols::Condition::id);
  throw UserError("There is no condition '" + id + "'. There are: " + known + ".");
}

/// The capabilities of the simulated device for @p condition.
haptics::devices::Capabilities simulatedCapabilitiesFor(
    const protocols::Protocol& protocol, const protocols::Condition& condition) {
  return haptics::devices::simulated(*protocol.device(condition.device)->kind);
}

/// The capabilities of the device for @p condition: of the device in the device file, or of the
/// simulated one.
haptics::devices::Capabilities capabilitiesFor(
    const ExplainArguments& options,
    const protocols::Protocol& protocol,
    const protocols::Condition& condition) {
  if (options.devices.empty()) return simulatedCapabilitiesFor(protocol, condition);
  HardwareDeviceSet deviceSet(loadDevices(options.devices), [](const auto& need) {
    return simulatedHandFor(need, 1, {}, 0);
  });
  const auto* device = deviceSet.find(condition.device);
  if (device == nullptr) {
    throw UserError(options.devices + " has no device '" + condition.device + "'.");
  }
  return device->capabilities();
}

int explain(const ExplainArguments& options) {
  const auto file = loadOrPrintProblems(options.file);
  if (!file) return 1;
  const auto* condition = &conditionOf(file->protocol, options.condition);
  auto spec = condition->scene();
  spec.isVisualised = spec.isVisualised || options.visualised;
  haptics::engine::CompiledScene scene(spec);
  const auto device = capabilitiesFor(options, file->protocol, *condition);
  const auto slope = haptics::engine::renderedSlope(spec, *device.kind, device.rate);
  std::vector<SceneCost> costs;
  if (options.cost) costs = measureCosts(spec, *device.kind);
  if (options.json) {
    std::fputs(passesAsJson(*condition, scene, slope, device, costs).c_str(), stdout);
  } else {
    print(*condition, scene, slope, device, costs);
    printSources(file->sources, condition->id);
  }
  return 0;
}

/// The motion of the tool, from the device's smallest travel to the end of the data of all scenes;
/// to the device's largest travel if the data of a scene have no end.
Motion motionFor(
    const PlayArguments& options,
    const haptics::devices::Capabilities& device,
    const std::vector<const protocols::Condition*>& conditions) {
  Motion motion{.least = options.from.value_or(device.leastTravel), .quantum = options.quantum};
  motion.most = motion.least;
  double speed = device.kind->travel.playSpeed;
  for (const auto* condition : conditions) {
    const auto end = haptics::engine::endOfData(*condition->model);
    motion.most = std::max(motion.most, end.value_or(device.largestTravel));
    // above the reamer's feed limit the force would grow without bound
    const double limit = 0.9 * haptics::engine::largestFeedOf(condition->scene());
    if (limit > 0.0) speed = std::min(speed, limit);
  }
  if (options.to) motion.most = *options.to;
  if (!(motion.most > motion.least)) {
    throw UserError(fmt::format(
        "The motion would go from {:g} to {:g}: give --from and --to a way to close.",
        motion.least,
        motion.most));
  }
  if (options.profile == "cut") motion.shape = Motion::Shape::Cut;
  if (options.profile == "sine") motion.shape = Motion::Shape::Sine;
  motion.speed = options.speed.value_or(speed);
  motion.rate = options.rate.value_or(device.rate);
  return motion;
}

/// Plays a condition without noise, or once for each requested noise.
void playCondition(
    const PlayArguments& options,
    const protocols::Condition& condition,
    haptics::engine::SceneSpec spec,
    const TravelProfile& profile,
    std::vector<PlayedCurve>& curves) {
  const auto* written = haptics::engine::partsOf(spec.model).filter;
  const bool isAlone = options.conditions.size() == 1;
  const auto add = [&](const std::string& title, bool withFilterInputs) {
    for (auto& curve : play(condition.id, title, spec, profile, withFilterInputs)) {
      curves.push_back(std::move(curve));
    }
  };
  if (written == nullptr) {
    add(condition.title, false);
    return;
  }
  auto filter = *written;
  if (options.smoothing) {
    filter.smoothing =
        haptics::engine::valueIn(haptics::engine::kSmoothingNames, *options.smoothing);
  }
  spec.model = filter;
  if (options.interpolationNoise.empty()) {
    add(condition.title, isAlone);
    return;
  }
  bool isFirst = true;
  for (const double noise : options.interpolationNoise) {
    filter.noise.interpolation = noise;
    spec.model = filter;
    add(fmt::format("{} (R {:g} N²)", condition.title, noise), isAlone && isFirst);
    isFirst = false;
  }
}

/// The output file with another extension: "out.csv" and "out.svg" for "out", "out.csv" or
/// "out.svg".
std::string withExtension(const std::string& out, const char* extension) {
  std::filesystem::path path(out);
  const auto own = path.extension();
  if (own == ".csv" || own == ".svg") path.replace_extension();
  return path.string() + extension;
}

/// The requested conditions. @throws UserError  if they need different devices.
std::vector<const protocols::Condition*> playedConditions(
    const PlayArguments& options, const protocols::Protocol& protocol) {
  std::vector<const protocols::Condition*> conditions;
  for (const auto& id : options.conditions) {
    conditions.push_back(&conditionOf(protocol, id));
    if (simulatedCapabilitiesFor(protocol, *conditions.back()).kind !=
        simulatedCapabilitiesFor(protocol, *conditions.front()).kind) {
      throw UserError("These conditions are felt on different devices; play them one by one.");
    }
  }
  return conditions;
}

int playScene(const PlayArguments& options) {
  const auto file = loadOrPrintProblems(options.file);
  if (!file) return 1;
  const auto conditions = playedConditions(options, file->protocol);
  const auto device = simulatedCapabilitiesFor(file->protocol, *conditions.front());
  const auto profile = profileOf(motionFor(options, device, conditions));
  std::vector<PlayedCurve> curves;
  for (const auto* condition : conditions) {
    playCondition(options, *condition, condition->scene(), profile, curves);
  }
  report::Document document{
      .parts = {
          {.figures = {
               {.chart = asChart(profile, curves, *device.kind, options.xAxis == "time")}}}}};
  paintFigures(document);
  const auto& svg = document.parts.front().figures.front().svg;
  const std::string csv = withExtension(options.out, ".csv");
  writeNewFile(csv, asCsv(asTable(profile, curves)));
  fmt::print("Curves saved: {} ({} curves of {} steps)", csv, curves.size(), profile.travel.size());
  if (!svg.empty()) {
    const std::string picture = withExtension(options.out, ".svg");
    writeNewFile(picture, svg);
    fmt::print(", picture: {}", picture);
  }
  fmt::print(".\n");
  return 0;
}

template <typename Names>
std::vector<std::string> namesIn(const Names& known) {
  std::vector<std::string> names;
  for (const auto& named : known) names.emplace_back(named.name);
  return names;
}

void addPlay(CLI::App& parentCommand, Action& action) {
  auto [play, options] = addCommand(
      parentCommand,
      action,
      "play",
      "Plot the force of conditions over travel, before the force limit",
      playScene);
  addProtocolFile(*play, options.file);
  play->add_option(
          "--condition",
          options.conditions,
          "Ids of the conditions to draw together; a single one with a Kalman filter is drawn with "
          "its two input forces")
      ->required();
  play->add_option(
          "--profile",
          options.profile,
          "Motion of the tool: closing at constant speed, a cut (closes and opens), or a sine")
      ->check(CLI::IsMember({"closing", "cut", "sine"}))
      ->capture_default_str();
  play->add_option(
          "--from",
          options.from,
          "Travel at which the tool begins [punch: travel units, paddle: degrees, reamer: m] "
          "(default: the device's smallest)")
      ->check(finiteRange(-1e6, 1e6));
  play->add_option(
          "--to",
          options.to,
          "Travel at which the tool turns or ends, in the unit of --from (default: where the "
          "scene's data end)")
      ->check(finiteRange(-1e6, 1e6));
  play->add_option(
          "--speed",
          options.speed,
          "Speed, in the unit of --from per second (default: punch 57, paddle 150, reamer 0.005, "
          "but at most 90 % of the feed that its bone allows)")
      ->check(finiteRange(1e-6, 1e6));
  play->add_option("--rate", options.rate, "Rate of the steps [Hz] (default: the device's)")
      ->check(finiteRange(1.0, 10'000.0));
  play->add_option(
          "--encoder",
          options.quantum,
          "Resolution of the encoder, in the unit of --from (default: 0, exact)")
      ->check(finiteRange(0.0, 1.0));
  play->add_option(
          "--interpolation-noise",
          options.interpolationNoise,
          "Variances R of the interpolated force in a Kalman filter [N²]; one curve for each "
          "(punch paper, Fig. 11)")
      ->check(finiteRange(0.0, 1e9));
  play->add_option(
          "--smoothing",
          options.smoothing,
          "Smoothing of the filtered force: none, two-point (mean of two steps), authors-firmware "
          "(as in the published code) (default: the protocol's)")
      ->check(CLI::IsMember(namesIn(haptics::engine::kSmoothingNames)));
  play->add_option("--over", options.xAxis, "Horizontal axis of the figure")
      ->check(CLI::IsMember({"travel", "time"}))
      ->capture_default_str();
  play->add_option(
          "--out", options.out, "CSV file to write; the figure (.svg) is written beside it")
      ->type_name("FILE")
      ->required();
}

}  // namespace

void addSceneCommands(CLI::App& program, Action& action) {
  auto& parentCommand = addCommandGroup(
      program, "scene", "Explain how the force of a condition is computed (its scene), or plot it");
  addPlay(parentCommand, action);
  auto [explain, options] = addCommand(
      parentCommand,
      action,
      "explain",
      "Explain how the force of a condition is computed: its steps, those that are left out, and "
      "why",
      app::explain);
  addProtocolFile(*explain, options.file);
  explain->add_option("--condition", options.condition, "Id of the condition in the protocol")
      ->required();
  explain
      ->add_option(
          "--devices",
          options.devices,
          "Device file: explain the scene for its device (default: the simulated device)")
      ->type_name("FILE");
  explain->add_flag(
      "--visualised",
      options.visualised,
      "Explain the force as in a block in which participants also see the simulation");
  explain->add_flag(
      "--cost",
      options.cost,
      "Also measure how long one step of the force takes, with and without the optional parts");
  explain->add_flag("--json", options.json, "Print JSON");
}

}  // namespace study::app
