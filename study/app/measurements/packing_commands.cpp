#include <chrono>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "haptics/reaming/packing/packed_bone.h"
#include "haptics/reaming/packing/packing_builder.h"
#include "haptics/reaming/packing/solids.h"
#include "haptics/timing/stopwatch.h"
#include "protocols/reading/packing_file.h"
#include "questionnaires/json/document.h"
#include "study/app/command_options.h"
#include "study/app/measurements/feed_table.h"
#include "study/app/measurements/packing_inputs.h"
#include "study/app/measurements/packing_report.h"
#include "study/app/write_report.h"
#include "study/model/new_file.h"
#include "study/model/user_error.h"
#include "study/storage/protocol_repository.h"

namespace study::app {
namespace {

namespace reaming = haptics::reaming;
namespace fs = std::filesystem;

constexpr double kMillimetre = 0.001;

struct BuildArguments {
  std::string mesh;
  std::string unit;
  std::string out;
  std::string name = "bone";
  std::string title = "A bone of spheres";
  std::optional<double> smallest;  ///< [mm]
  std::optional<double> largest;   ///< [mm]
  double reamerRadius = 26.0;      ///< [mm]
  reaming::PackingOptions options;
};

std::string checkedEnding(const std::string& path) {
  if (!path.ends_with(protocols::kPackingExtension)) {
    throw UserError("'" + path + "' does not end in '.packing'. Name it '" + path + ".packing'.");
  }
  if (fs::exists(path)) {
    throw UserError(
        "'" + path + "' is there already, and nothing is overwritten. Choose a new name.");
  }
  return path;
}

std::unique_ptr<reaming::Solid> bodyOf(const BuildArguments& command) {
  if (command.mesh.empty()) return std::make_unique<reaming::Acetabulum>();
  auto body = readBody(command.mesh, command.unit);
  for (const auto& remark : body.remarks) fmt::print(stderr, "{}: {}\n", command.mesh, remark);
  return std::make_unique<reaming::MeshSolid>(std::move(body.mesh));
}

void printSyntheticMark(const reaming::PackedBone& bone) {
  if (bone.isSynthetic) fmt::print("{}\n", syntheticMark(bone));
}

/// Prints the progress when the radius has changed. @return  true, to continue
bool printPackingProgress(const reaming::PackingProgress& progress, double& lastRadius) {
  if (progress.radius == lastRadius) return true;
  lastRadius = progress.radius;
  fmt::print(
      stderr,
      "{:>9} spheres, {:4.1f} % covered; looking for room for {:.3f} mm\n",
      progress.spheres,
      100.0 * progress.coverage,
      progress.radius / kMillimetre);
  return true;
}

int buildPacking(BuildArguments& command) {
  checkedEnding(command.out);
  auto& options = command.options;
  if (command.smallest) options.smallestRadius = kMillimetre * *command.smallest;
  if (command.largest) options.largestRadius = kMillimetre * *command.largest;
  if (!options.count && !options.coverage && !options.smallestRadius) options.count = 201'532;
  const auto body = bodyOf(command);
  const auto begin = std::chrono::steady_clock::now();
  reaming::PackedBone bone{.name = command.name, .title = command.title};
  bone.isSynthetic = command.mesh.empty();
  bone.reamerRadius = kMillimetre * command.reamerRadius;
  try {
    double lastRadius = 0.0;
    bone.packing = *reaming::pack(*body, options, [&](const auto& progress) {
      return printPackingProgress(progress, lastRadius);
    });
  } catch (const std::invalid_argument& wrong) {
    throw UserError(std::string("The spheres cannot be placed: ") + wrong.what() + ".");
  }
  const double seconds = haptics::timing::secondsSince(begin);
  protocols::PackingOrigin origin{.mesh = "parametric acetabulum", .seed = options.seed};
  if (!command.mesh.empty()) {
    origin.mesh = fs::path(command.mesh).filename().string();
    origin.sha256 =
        storage::sha256(questionnaires::readTextFile(command.mesh, protocols::kMaxPackingBytes));
  }
  writeNewFile(command.out, protocols::packingAsText(bone, origin));
  const auto flaws = reaming::flawsOf(bone.packing, *body);
  const auto& spheres = bone.packing.spheres;
  fmt::print(
      "{}: {} spheres of {:.3f} to {:.3f} mm cover {:.1f} % of {:.1f} cm³, in {:.1f} s.\n"
      "Largest overlap {:.1g} of a radius, out of the body {:.1g}. The literature reaches about "
      "85 % with\nspheres of any size (ProtoSphere); here none is larger than what can be felt "
      "apart.\n"
      "It has no densities yet:\n  palpate packing fit {} --material MATERIAL.json --out "
      "FITTED.packing\n",
      command.out,
      spheres.size(),
      spheres.back().radius / kMillimetre,
      spheres.front().radius / kMillimetre,
      100.0 * bone.packing.coverage(),
      1e6 * bone.packing.volume,
      seconds,
      std::max(flaws.overlap, 0.0),
      std::max(flaws.protrusion, 0.0),
      command.out);
  printSyntheticMark(bone);
  return 0;
}

void addBuildPacking(CLI::App& parentCommand, Action& action) {
  auto [verb, command] = addCommand(
      parentCommand,
      action,
      "build",
      "Fill a closed mesh, or the built-in acetabulum, with spheres",
      app::buildPacking);
  verb->add_option(
      "MESH",
      command.mesh,
      "Closed mesh (STL, OBJ, PLY) whose +z axis points into the acetabulum (default: the built-in "
      "acetabulum)");
  verb->add_option("--out", command.out, "New file that ends in .packing")
      ->type_name("FILE")
      ->required();
  verb->add_option("--unit", command.unit, "Unit of the mesh (default: derived from its size)")
      ->check(CLI::IsMember({"m", "mm"}));
  auto* count =
      verb->add_option("--count", command.options.count, "Number of spheres (default: 201532)");
  auto* coverage = verb->add_option(
                           "--coverage",
                           command.options.coverage,
                           "Share of the volume to fill, instead of --count")
                       ->check(finiteRange(0.01, 0.8));
  auto* smallest = verb->add_option(
                           "--smallest-radius",
                           command.smallest,
                           "Radius of the smallest sphere, instead of --count [mm]")
                       ->check(finiteRange(0.001, 50.0));
  count->excludes(coverage)->excludes(smallest);
  coverage->excludes(smallest);
  verb->add_option(
          "--largest-radius",
          command.largest,
          "Radius of the largest sphere [mm] (default: from count, smallest radius or volume)")
      ->check(finiteRange(0.001, 50.0));
  verb->add_option("--reamer-radius", command.reamerRadius, "Radius of the reamer [mm]")
      ->check(finiteRange(1.0, 100.0))
      ->capture_default_str();
  verb->add_option(
          "--seed", command.options.seed, "Random seed; the same seed gives the same spheres")
      ->capture_default_str();
  verb->add_option(
          "--threads",
          command.options.threads,
          "Number of threads; the result does not depend on it")
      ->check(CLI::Range(1, 256))
      ->capture_default_str();
  verb->add_option("--name", command.name, "Name of the bone")->capture_default_str();
  verb->add_option("--title", command.title, "Title shown in reports")->capture_default_str();
}

struct DensityArguments {
  const CLI::App* parsedCommand = nullptr;  ///< for finding out which options were given
  std::string packing;
  MaterialChoice material;
  std::string out;
  std::string report;
  reaming::BoneFitOptions options;
  std::string method = "exact";
  std::size_t layers = 12;  ///< layers for swarm optimisation
  reaming::SwarmOptions swarm;
};

/// The options of --method swarm.
constexpr const char* kSwarmOptions[]{"--layers", "--particles", "--iterations", "--seed"};

/// The function that computes the densities; empty for the exact method.
reaming::DensityMethod methodOf(const DensityArguments& command) {
  if (command.method == "exact") return {};
  return [&command](const reaming::ContactMatrix& matrix, std::span<const double> forces) {
    return reaming::fitBoneBySwarm(matrix, forces, command.layers, command.swarm);
  };
}

std::string describeSwarm(const DensityArguments& command) {
  return fmt::format(
      "a particle swarm ({}, {} particles, {} steps, seed {})",
      command.layers > 0 ? fmt::format("{} layers", command.layers) : "every sphere for itself",
      command.swarm.particles,
      command.swarm.iterations,
      command.swarm.seed);
}

void printFit(const reaming::CurveFit& curve, bool isSwarm) {
  const auto& spheres = curve.fit.spheres;
  if (isSwarm) {
    fmt::print("{:<8} error {:.2g} of the force\n", curve.curve, spheres.error);
    return;
  }
  fmt::print(
      "{:<8} error {:.2g} of the force (12 layers alone: {:.2g}); at most {:.1g} above the "
      "optimum; {} steps\n",
      curve.curve,
      spheres.error,
      curve.fit.layers.error,
      std::max(spheres.gap, 0.0),
      spheres.iterations);
}

/// Reams the fitted bone like the test machine of the paper, and prints the errors of the forces.
void printExperiments(const reaming::PackedBone& bone, const reaming::BoneFitReport& report) {
  double h = 0.0;
  for (const auto& curve : report.curves) {
    const auto result = reaming::ream(bone, h);
    fmt::print(
        "{:<8} reamed at 0.03 mm/s: {:.2g} of the force off the curve; {:.1f} % of the mass "
        "removed; ended by {}\n",
        curve.curve,
        reaming::errorOf(result, curve.depths, curve.wanted),
        100.0 * result.removedShare,
        result.stop);
    h += 0.5;
  }
}

/// Prints how the bone's torque is computed, and the errors of the fit.
void printFriction(const reaming::BoneFitReport& report, bool hasTorque) {
  if (!hasTorque) {
    fmt::print(
        "The material has no torque: {}\n",
        report.friction ? fmt::format("friction {:.3g} makes it.", *report.friction)
                        : "the scene's friction makes it.");
    return;
  }
  fmt::print("Friction {:.3g}; of the material's torque ", *report.friction);
  for (const auto& curve : report.curves) {
    const bool isLast = &curve == &report.curves.back();
    fmt::print(
        "the {} is {:.2g} off{}",
        curve.curve,
        curve.torqueError.value_or(0.0),
        isLast ? ".\n" : ", ");
  }
}

int fitDensities(DensityArguments& command) {
  checkedEnding(command.out);
  const bool isSwarm = command.method == "swarm";
  for (const auto* option : kSwarmOptions) {
    if (!isSwarm && command.parsedCommand->count(option) > 0) {
      throw UserError(std::string(option) + " is of a swarm: add --method swarm.");
    }
  }
  protocols::PackingOrigin origin;
  auto bone = readBone(command.packing, origin);
  const auto material = curvesOf(command.material, origin);
  if (isSwarm) origin.material += ", by " + describeSwarm(command);
  bone.isSynthetic = bone.isSynthetic || material.isSynthetic;
  reaming::BoneFitReport report;
  command.options.onProgress = [](const std::string& what) {
    fmt::print(stderr, "fitting {}\n", what);
  };
  command.options.method = methodOf(command);
  try {
    report = reaming::fitBoneToMaterial(bone, material.curves, material.torque, command.options);
  } catch (const std::invalid_argument& wrong) {
    throw UserError(command.packing + ": " + wrong.what() + ".");
  }
  for (const auto& curve : report.curves) printFit(curve, isSwarm);
  if (isSwarm) fmt::print("Densities by {}.\n", describeSwarm(command));
  fmt::print(
      "{:.0f} % of the spheres are touched by the experiment; the others are as the deepest layer "
      "that is. {:.1f} s.\n",
      100.0 * report.curves.front().fit.touchedShare,
      report.seconds);
  printFriction(report, !material.torque.isEmpty());
  printExperiments(bone, report);
  for (const auto& warning : warningsOf(report)) fmt::print("WARNING: {}\n", warning);
  writeNewFile(command.out, protocols::packingAsText(bone, origin));
  fmt::print(
      "Bone saved: {0}. Put it beside a protocol and name it there: \"packing\": \"{0}\".\n",
      fs::path(command.out).filename().string());
  printSyntheticMark(bone);
  if (!command.report.empty()) {
    writeDocument(command.report, "packing", packingReport(bone, report, feedTable(bone, report)));
    fmt::print("Report saved: {}/packing.html\n", command.report);
  }
  return 0;
}

void addFitDensities(CLI::App& parentCommand, Action& action) {
  auto [verb, command] = addCommand(
      parentCommand,
      action,
      "fit",
      "Fit the densities of a packing's spheres to a material",
      app::fitDensities);
  command.parsedCommand = verb;
  verb->add_option("PACKING", command.packing, "A packing from 'palpate packing build'")
      ->required();
  addMaterialOptions(*verb, command.material);
  verb->add_option("--out", command.out, "New file that ends in .packing")
      ->type_name("FILE")
      ->required();
  addReportFolder(*verb, command.report, "tables, figures");
  verb->add_option(
          "--depths", command.options.depths, "Number of depths at which the curve is fitted")
      ->check(CLI::Range(20, 2000))
      ->capture_default_str();
  verb->add_option(
          "--friction",
          command.options.friction,
          "Coefficient of friction between reamer and bone, if known (default: fitted to the "
          "torque)")
      ->check(finiteRange(0.0, 2.0));
  verb->add_option("--method", command.method, "Method: exact, or swarm (as in the reaming paper)")
      ->check(CLI::IsMember({"exact", "swarm"}))
      ->capture_default_str();
  verb->add_option(
          "--layers",
          command.layers,
          "With swarm: number of layers by depth, each of one density; 0: one density for each "
          "sphere")
      ->check(CLI::Range(0, 1000))
      ->capture_default_str();
  verb->add_option("--particles", command.swarm.particles, "With swarm: number of particles")
      ->check(CLI::Range(2, 100'000))
      ->capture_default_str();
  verb->add_option("--iterations", command.swarm.iterations, "With swarm: number of iterations")
      ->check(CLI::Range(1, 100'000'000))
      ->capture_default_str();
  verb->add_option("--seed", command.swarm.seed, "With swarm: random seed")->capture_default_str();
}

}  // namespace

void addPackingCommands(CLI::App& program, Action& action) {
  auto& parentCommand = addCommandGroup(
      program,
      "packing",
      "Model a bone by spheres that reaming removes: fill a mesh, fit densities");
  addBuildPacking(parentCommand, action);
  addFitDensities(parentCommand, action);
}

}  // namespace study::app
