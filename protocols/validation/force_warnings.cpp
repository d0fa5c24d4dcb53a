// Warnings on what the scene of a condition gives over the whole travel of its device: hardly
// anything, a pull, more than the device may give, the same as another condition.
#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "base/search.h"
#include "haptics/engine/compiled_scene.h"
#include "protocols/model/messages.h"
#include "protocols/validation/validation.h"
#include "questionnaires/json/document.h"

namespace protocols {
namespace {

namespace engine = haptics::engine;
using questionnaires::Problems;
using questionnaires::shown;

constexpr double kFeltForce = 0.2;         // less is hardly felt through a handle [N]
constexpr double kNoticeableForce = 0.05;  // [N]

/// The force of a scene at one travel of its device.
struct ForceAt {
  double travel = 0.0;  ///< [device's travel unit]
  double force = 0.0;   ///< [N]

  bool operator==(const ForceAt&) const = default;
};

/// The forces of a scene over the whole travel of its device.
struct ForceSweep {
  std::vector<ForceAt> closing;
  std::vector<ForceAt> opening;

  bool operator==(const ForceSweep&) const = default;
};

/// The forces of @p condition at the speed of 'scene play', without noise and removal of bone.
ForceSweep sweepOf(const Condition& condition, const haptics::devices::DeviceKind& kind) {
  constexpr int kSteps = 1000;
  auto scene = condition.scene();
  scene.isVisualised = false;
  if (auto plain = engine::withoutNoiseAndRemoval(scene.model)) scene.model = std::move(*plain);
  engine::CompiledScene compiled(scene);
  const double step = (kind.travel.most - kind.travel.least) / kSteps;
  const double speed = kind.travel.playSpeed;
  ForceSweep sweep;
  const auto add = [&](std::vector<ForceAt>& forces, int index, double velocity) {
    const double travel = kind.travel.least + index * step;
    const auto response =
        compiled.respond({.travel = travel, .velocity = velocity, .dt = step / speed});
    if (response.isDefined) forces.push_back({travel, response.force});
  };
  for (int i = 0; i <= kSteps; ++i) add(sweep.closing, i, speed);
  for (int i = kSteps - 1; i >= 0; --i) add(sweep.opening, i, -speed);
  return sweep;
}

/// @p value for a message, with as many decimal places as its unit needs.
std::string rounded(double value, double places) {
  return shown(std::round(value * places) / places);
}

/// Checks the forces of one condition while its device closes.
class ForceCheck {
 public:
  ForceCheck(
      const std::vector<ForceAt>& closing,
      const DeviceRequirement& device,
      std::string path,
      Problems& problems)
      : device_(device),
        kind_(*device.kind),
        forces_(closing),
        path_(std::move(path)),
        problems_(problems) {}

  void all(bool hasElementsOnly) {
    if (!warnOfNothing()) warnOfPull();
    if (hasElementsOnly) warnOfLimit();
  }

 private:
  bool warnOfNothing() {
    double most = 0.0;
    for (const auto& at : forces_) most = std::max(most, std::abs(at.force));
    if (most >= kFeltForce) return false;
    problems_.warn(
        path_,
        message("hardly_felt", rounded(most, 1000.0), inShownUnit(kind_.travel.least), shownMost()),
        message("hardly_felt.fix"));
    return true;
  }

  void warnOfPull() {
    const auto count = [&](auto is) { return std::ranges::count_if(forces_, is, &ForceAt::force); };
    const auto pulls = count([](double force) { return force < -kNoticeableForce; });
    const auto pushes = count([](double force) { return force > kNoticeableForce; });
    if (pulls <= pushes) return;
    problems_.warn(path_, message("force_pulls"), message("force_pulls.fix"));
  }

  void warnOfLimit() {
    double most = 0.0;
    std::optional<double> from;
    double to = 0.0;
    for (const auto& at : forces_) {
      most = std::max(most, at.force);
      if (at.force <= device_.maxForce) continue;
      if (!from) from = at.travel;
      to = at.travel;
    }
    if (!from) return;
    problems_.warn(
        path_,
        message(
            "elements_beyond_limit",
            rounded(most, 10.0),
            shown(device_.maxForce),
            inShownUnit(*from),
            inShownUnit(to)),
        message("elements_beyond_limit.fix"));
  }

  std::string inShownUnit(double travel) const {
    return rounded(travel * kind_.shown.factor, 10.0);
  }
  std::string shownMost() const {
    return inShownUnit(kind_.travel.most).append(kind_.shown.suffix);
  }

  const DeviceRequirement& device_;
  const haptics::devices::DeviceKind& kind_;
  const std::vector<ForceAt>& forces_;
  std::string path_;
  Problems& problems_;
};

std::string pathOf(std::size_t condition) {
  return "$.conditions[" + std::to_string(condition) + "].scene";
}

bool isFeltTogether(const Protocol& protocol, const std::string& a, const std::string& b) {
  return std::ranges::any_of(protocol.phases, [&](const auto& phase) {
    return base::contains(phase.trials.conditions, a) && base::contains(phase.trials.conditions, b);
  });
}

bool lookAlike(const Condition& a, const Condition& b) {
  return a.device == b.device && a.isVisualised == b.isVisualised &&
         a.tissueDrawing == b.tissueDrawing && a.anatomy == b.anatomy;
}

/// Warns if a condition has the same forces as one before it in a block. Conditions of bone are
/// left out: they may differ in noise and removal, which their forces here lack.
void warnOfSameForces(
    const Protocol& protocol,
    const std::vector<ForceSweep>& sweeps,
    std::size_t index,
    Problems& problems) {
  const auto& condition = protocol.conditions[index];
  if (engine::infoOf(*condition.model).tissue == haptics::devices::Tissue::Bone) return;
  for (std::size_t i = 0; i < index; ++i) {
    const auto& other = protocol.conditions[i];
    if (!lookAlike(condition, other) || sweeps[i] != sweeps[index]) continue;
    if (!isFeltTogether(protocol, condition.id, other.id)) continue;
    problems.warn(
        pathOf(index), message("same_force", condition.id, other.id), message("same_force.fix"));
    return;
  }
}

}  // namespace

void addForceWarnings(const Protocol& protocol, Problems& problems) {
  std::vector<ForceSweep> sweeps(protocol.conditions.size());
  for (std::size_t i = 0; i < protocol.conditions.size(); ++i) {
    const auto& condition = protocol.conditions[i];
    const auto* device = protocol.device(condition.device);
    const auto parts = engine::partsOf(*condition.model);
    if (device == nullptr || parts.packing != nullptr) continue;  // a packing was fitted to forces
    sweeps[i] = sweepOf(condition, *device->kind);
    const bool hasElementsOnly = parts.elements != nullptr && parts.filter == nullptr;
    ForceCheck(sweeps[i].closing, *device, pathOf(i) + ".parameters", problems)
        .all(hasElementsOnly);
    warnOfSameForces(protocol, sweeps, i, problems);
  }
}

}  // namespace protocols
