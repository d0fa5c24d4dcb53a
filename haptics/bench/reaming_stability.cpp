// A bone of spheres under extreme conditions: stiff coupling, uneven or missing spheres, invalid
// input.
#include <algorithm>
#include <cmath>
#include <limits>

#include "haptics/bench/stability.h"
#include "haptics/reaming/bone/bone.h"
#include "haptics/reaming/bone/sphere_field.h"
#include "haptics/reaming/packing/packing_builder.h"
#include "haptics/reaming/packing/solids.h"

namespace haptics::bench {
namespace {

using reaming::Bone;
using reaming::BoneOptions;
using reaming::Packing;
using reaming::PlungePath;
using reaming::Vec3;

constexpr double kTick = 0.001;
constexpr double kReamerRadius = 0.026;  // [m]

/// A simulation of a bone and a device, with the largest errors so far.
struct Run {
  Run(const Packing& packing, const std::vector<double>& densities, BoneOptions options)
      : bone(packing, densities, withCoverage(options, packing)),
        plunge(reaming::plungePathInto(bone.field(), kReamerRadius)),
        initialMass(bone.remainingMass()),
        coupling(options.coupling) {
    for (int i = 0; i < 50; ++i) bone.step(plunge.at(-0.0005), kTick);
  }

  void step(const reaming::Reamer& device) {
    const auto felt = bone.step(device, kTick);
    const double force = length(felt.force);
    largestForce = std::max(largestForce, std::isfinite(force) ? force : largestForce);
    isFinite &= std::isfinite(force) && std::isfinite(felt.frictionTorque);
    const double gap = length(device.centre - bone.tool().centre);
    if (std::isfinite(gap)) {  // the factor allows for rounding
      aboveCoupling = std::max(aboveCoupling, force - coupling * gap * (1.0 + 1e-9));
    }
  }
  void moveReamer(double from, double to, int steps) {
    for (int i = 1; i <= steps; ++i) step(plunge.at(from + (to - from) * i / steps));
  }
  double massError() const {
    const double now = bone.remainingMass() + bone.removedMass();
    return initialMass > 0.0 ? std::abs(now / initialMass - 1.0) : std::abs(now);
  }
  /// Number of groups that a step reads with the tool at @p depth, a measure of its cost.
  double groupsRead(double depth) const {
    double groups = 0.0;
    bone.field().forEachRange(
        plunge.at(depth), [&](std::uint32_t begin, std::uint32_t end) { groups += end - begin; });
    return groups;
  }

  Bone bone;
  PlungePath plunge;
  double initialMass;
  double coupling;
  double largestForce = 0.0;
  double aboveCoupling = 0.0;
  bool isFinite = true;

 private:
  static BoneOptions withCoverage(BoneOptions options, const Packing& packing) {
    options.coverage = packing.coverage();
    return options;
  }
};

std::vector<double> uniformDensities(const Packing& packing, double density) {
  return std::vector<double>(packing.spheres.size(), density);
}

void addChecks(SweepChecks& sweep, const Run& run, const std::string& what, double parameter) {
  sweep.add(what + ": forces that are no number", parameter, run.isFinite ? 0.0 : 1.0, 0.0);
  sweep.add(what + ": force above its coupling [N]", parameter, run.aboveCoupling, 1e-6);
  sweep.add(what + ": mass unaccounted for, relative", parameter, run.massError(), 1e-6);
}

void sweepStiffCoupling(const Packing& packing, SweepChecks& sweep) {
  for (const double coupling : {1e3, 1e5, 1e8}) {  // 10⁸ N/m is 10⁵ N/mm
    Run run(packing, uniformDensities(packing, 2e5), {.coupling = coupling});
    run.moveReamer(0.0, 0.004, 4000);
    run.moveReamer(0.004, -0.001, 500);
    addChecks(sweep, run, "stiff contact", coupling);
  }
  for (const double density : {0.0, 1.0, 1e6, 1e12}) {
    Run run(packing, uniformDensities(packing, density), {});
    run.moveReamer(0.0, 0.008, 1000);
    addChecks(sweep, run, "density [N/m²]", density);
  }
}

/// A packing with spheres of 1/100 of the usual size among the others.
void sweepUnevenSpheres(const Packing& packing, SweepChecks& sweep) {
  auto mixed = packing;
  const std::size_t own = mixed.spheres.size();
  for (std::size_t i = 0; i < own; i += 3) {
    auto& large = mixed.spheres[i];
    large.radius *= 0.5F;
    auto tiny = large;
    tiny.x += 1.6F * large.radius;
    tiny.radius *= 0.02F;
    mixed.spheres.push_back(tiny);
  }
  Run run(mixed, uniformDensities(mixed, 2e5), {});
  run.moveReamer(0.0, 0.010, 3000);
  run.moveReamer(0.010, 0.0, 1000);
  addChecks(sweep, run, "tiny and huge spheres together", 50.0);
}

void sweepInvalidInput(const Packing& packing, SweepChecks& sweep) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  {
    Run run(packing, uniformDensities(packing, 2e5), {});
    for (const double depth : {0.015, 0.1, -0.05, 1e6, -1e6, 0.01}) {
      for (int i = 0; i < 300; ++i) run.step(run.plunge.at(depth));
    }
    addChecks(sweep, run, "teleported into the bone and through it", 0.1);
  }
  {
    Run run(packing, uniformDensities(packing, 2e5), {});
    run.moveReamer(0.0, 0.006, 500);
    for (int i = 0; i < 100; ++i) {
      run.step({kReamerRadius, {nan, 0.0, 0.0}, {0.0, 0.0, 1.0}});
      run.step({kReamerRadius, run.plunge.at(0.006).centre, {nan, nan, nan}});
      run.step(run.plunge.at(0.006));
    }
    addChecks(sweep, run, "pose that is no number", 0.0);
  }
  {
    Run run(packing, uniformDensities(packing, 2e5), {.isSpinning = false});
    run.moveReamer(0.0, 0.010, 1000);
    addChecks(sweep, run, "spun backwards", 0.0);
    sweep.add(
        "spun backwards: mass removed, relative",
        0.0,
        run.bone.removedMass() / run.initialMass,
        0.0);
  }
  {
    // Ream a core of the bone completely, and advance beyond it.
    auto core = packing;
    std::erase_if(core.spheres, [](const auto& s) { return std::hypot(s.x, s.y) > 0.018F; });
    Run run(core, uniformDensities(core, 1e4), {.mostAdvance = 5e-4});
    run.moveReamer(0.0, 0.06, 4000);
    addChecks(sweep, run, "everything removed", 0.0);
    sweep.add(
        "everything removed: mass left, relative",
        0.0,
        run.bone.remainingMass() / run.initialMass,
        1e-9);
    run.largestForce = 0.0;
    run.moveReamer(0.06, 0.07, 1000);
    sweep.add("everything removed: force afterwards [N]", 0.0, run.largestForce, 0.0);
  }
}

/// Moves the reamer to and fro and around for ten minutes.
void sweepEndurance(const Packing& packing, double effort, SweepChecks& sweep) {
  Run run(packing, uniformDensities(packing, 1e5), {});
  const double before = run.groupsRead(0.008);
  const std::size_t bytes = run.bone.field().bytes();
  const int steps = std::max(1000, static_cast<int>(effort * 600'000));
  for (int i = 0; i < steps; ++i) {
    const double minutes = static_cast<double>(i) / 60'000.0;
    auto pose = run.plunge.at(0.004 + 0.0012 * minutes + 0.003 * std::sin(0.004 * i));
    pose.centre.x = 0.002 * std::cos(0.0011 * i);
    pose.centre.y = 0.002 * std::sin(0.0013 * i);
    run.step(pose);
  }
  addChecks(sweep, run, "ten minutes", 10.0);
  sweep.add(
      "ten minutes: groups a step looks at, times as many",
      10.0,
      run.groupsRead(0.008) / before,
      1.5);  // remainders are at most a radius outside their cells
  sweep.add(
      "ten minutes: bytes grown by",
      10.0,
      static_cast<double>(run.bone.field().bytes() - bytes),
      0.0);
}

}  // namespace

void sweepReaming(double effort, StabilityResult& result) {
  const Packing packing = *reaming::pack(reaming::Acetabulum(), {.count = 4000});
  SweepChecks sweep(result, "reaming");
  sweepStiffCoupling(packing, sweep);
  sweepUnevenSpheres(packing, sweep);
  sweepInvalidInput(packing, sweep);
  sweepEndurance(packing, effort, sweep);
}

}  // namespace haptics::bench
