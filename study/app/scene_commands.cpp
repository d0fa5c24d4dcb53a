#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <memory>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "haptics/devices/simulated_device.h"
#include "haptics/engine/compiled_scene.h"
#include "haptics/engine/passivity.h"
#include "protocols/loaded_protocol.h"
#include "study/app/commands.h"
#include "study/app/json_file.h"
#include "study/session.h"

namespace study::app {
namespace {

struct ExplainOptions {
  std::string file;
  std::string condition;
  bool visualised = false;
  bool json = false;
};

/// What one tick of the scene takes on this computer, while the tool goes to and fro [ns]: a
/// median, warm.
double tickTime(haptics::engine::CompiledScene& scene, double mostTravel) {
  using Clock = std::chrono::steady_clock;
  constexpr int kRepeats = 41;
  constexpr int kTicks = 2000;
  std::vector<double> times;
  double sum = 0.0;
  for (int repeat = 0; repeat < kRepeats; ++repeat) {
    const auto start = Clock::now();
    for (int i = 0; i < kTicks; ++i) {
      const double travel = mostTravel * 0.5 * (1.0 - std::cos(0.004 * i));
      sum += scene.respond({.travel = travel}).force;
    }
    times.push_back(
        std::chrono::duration<double, std::nano>(Clock::now() - start).count() / kTicks);
  }
  std::nth_element(times.begin(), times.begin() + kRepeats / 2, times.end());
  return std::isfinite(sum) ? times[kRepeats / 2] : 0.0;
}

void print(
    const protocols::Condition& condition,
    const haptics::engine::CompiledScene& scene,
    const haptics::devices::Capabilities& device,
    double nanoseconds) {
  fmt::print("{} ({}) on a {}\n\n", condition.id, condition.title, condition.device);
  for (const auto& pass : scene.passes()) {
    fmt::print(
        "  {}  {:<34} {}{}\n",
        pass.isIn ? "in " : "out",
        pass.name,
        pass.why,
        pass.bytes > 0 ? fmt::format(" ({} bytes)", pass.bytes) : "");
  }
  const double stiffness = scene.largestStiffness();
  const haptics::engine::Passivity passivity{.stiffness = stiffness, .period = 1.0 / device.rate};
  fmt::print("\n  one tick of all that is in: {:.0f} ns, median, on this computer\n", nanoseconds);
  fmt::print(
      "  stiffest slope {:.4g} N/{}; at {:.0f} Hz passivity (eq. (25), b > KT/2) needs {:.3g} "
      "N·s/{} of "
      "damping;\n  the {} has {:.3g} of its own, the hand adds more\n",
      stiffness,
      device.travelUnit,
      device.rate,
      passivity.neededDamping(),
      device.travelUnit,
      device.name,
      device.damping);
}

int explain(const ExplainOptions& options) {
  questionnaires::Problems problems;
  const auto loaded = protocols::loadProtocolFile(options.file, problems);
  if (!loaded) {
    std::fputs(questionnaires::inWords(problems.all()).c_str(), stderr);
    return 1;
  }
  const auto* condition = loaded->protocol.condition(options.condition);
  if (condition == nullptr) {
    std::string known;
    for (const auto& c : loaded->protocol.conditions) known += (known.empty() ? "" : ", ") + c.id;
    throw NotNow("There is no condition '" + options.condition + "'. There are: " + known + ".");
  }
  auto spec = condition->scene;
  spec.device = loaded->protocol.device(condition->device)->kind;
  spec.isVisualised = spec.isVisualised || options.visualised;
  haptics::engine::CompiledScene scene(spec);
  const auto device = spec.device == haptics::devices::DeviceKind::Punch
                          ? haptics::devices::simulatedPunch()
                          : haptics::devices::simulatedReamer();
  const double nanoseconds = tickTime(scene, device.mostTravel);
  if (options.json) {
    std::fputs(passesAsJson(condition->id, scene, nanoseconds).c_str(), stdout);
  } else {
    print(*condition, scene, device, nanoseconds);
  }
  return 0;
}

}  // namespace

void addSceneCommands(CLI::App& program, Action& action) {
  auto* noun = program.add_subcommand("scene", "What a condition consists of");
  noun->require_subcommand(1);
  auto options = std::make_shared<ExplainOptions>();
  auto* explain = noun->add_subcommand(
      "explain", "What a condition needs, what is left out and why, and what it costs");
  explain->add_option("FILE", options->file, "A protocol file, or one of the library by name")
      ->required();
  explain->add_option("--condition", options->condition, "Its id in the protocol")->required();
  explain->add_flag("--visualised", options->visualised, "As in a block with visualisation");
  explain->add_flag("--json", options->json, "For programs");
  explain->callback([&action, options] { action = [options] { return app::explain(*options); }; });
}

}  // namespace study::app
