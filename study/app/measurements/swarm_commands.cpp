#include <algorithm>
#include <chrono>
#include <cstdio>
#include <memory>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "haptics/reaming/bone/sphere_field.h"
#include "haptics/reaming/packing/density_fit.h"
#include "protocols/reading/packing_file.h"
#include "questionnaires/json/document.h"
#include "study/app/commands.h"
#include "study/app/finite_range.h"
#include "study/app/measurements/packing_inputs.h"
#include "study/app/measurements/swarm_file.h"
#include "study/model/new_file.h"
#include "study/model/user_error.h"
#include "study/storage/protocol_repository.h"

namespace study::app {
namespace {

namespace reaming = haptics::reaming;

struct SwarmCommand {
  std::string packing;
  MaterialChoice material;
  std::string curve = "average";
  std::string shard = "1/1";
  std::string out;
  SwarmShard settings;
  int threads = 2;
};

/// "2/5" to 2 of 5.
void readShard(const std::string& text, SwarmShard& settings) {
  const auto slash = text.find('/');
  const std::string digits = "0123456789";
  const bool isTwo = slash != std::string::npos && slash > 0 && slash + 1 < text.size() &&
                     text.find_first_not_of(digits + "/") == std::string::npos &&
                     text.find('/', slash + 1) == std::string::npos && text.size() < 15;
  if (isTwo) {
    settings.shard = std::stoll(text.substr(0, slash));
    settings.shards = std::stoll(text.substr(slash + 1));
  }
  if (!isTwo || settings.shard < 1 || settings.shard > settings.shards) {
    throw UserError("'" + text + "' is no shard. Write which of how many, e.g. --shard 2/5.");
  }
}

/// The problem of every sphere, or of layers.
struct SwarmProblem {
  reaming::ContactMatrix matrix;
  std::vector<double> forces;
};

SwarmProblem problemOf(
    const reaming::PackedBone& bone, const reaming::CurveNodes& curve, std::int64_t layers) {
  constexpr std::size_t kDepths = 400;
  const std::vector<double> ones(bone.packing.spheres.size(), 1.0);
  const auto plunge =
      reaming::plungeInto(reaming::SphereField(bone.packing, ones), bone.reamerRadius);
  SwarmProblem problem;
  std::vector<double> depths;
  for (std::size_t i = 0; i < kDepths; ++i) {
    depths.push_back(curve.back().position * (static_cast<double>(i) + 0.5) / kDepths);
    problem.forces.push_back(std::max(0.0, reaming::forceOf(curve, depths.back())));
  }
  problem.matrix = reaming::contactMatrix(bone.packing, bone.packing.coverage(), plunge, depths);
  if (layers > 0) {
    const auto count = static_cast<std::size_t>(layers);
    problem.matrix =
        reaming::layered(problem.matrix, reaming::layersOf(problem.matrix, count), count);
  }
  return problem;
}

int swarm(SwarmCommand& command) {
  auto& shard = command.settings;
  readShard(command.shard, shard);
  protocols::PackingOrigin origin;
  const auto bone = readBone(command.packing, origin);
  const auto curves = curvesOf(command.material, origin).curves;
  shard.packing =
      storage::sha256(questionnaires::readTextFile(command.packing, protocols::kLargestPacking));
  shard.material = origin.material + ", " + command.curve;
  const auto& curve = command.curve == "minimum"   ? curves.minimum
                      : command.curve == "average" ? curves.average
                                                   : curves.maximum;
  const auto problem = problemOf(bone, curve, shard.layers);
  for (std::int64_t seed = shard.shard; seed <= shard.seeds; seed += shard.shards) {
    const auto begin = std::chrono::steady_clock::now();
    const auto fit = reaming::fitSwarm(
        problem.matrix,
        problem.forces,
        {.particles = static_cast<int>(shard.particles),
         .iterations = static_cast<int>(shard.iterations),
         .seed = static_cast<std::uint64_t>(seed),
         .threads = command.threads,
         .seconds = shard.seconds});
    const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - begin;
    shard.results.push_back({seed, fit.error, fit.iterations, passed.count()});
    fmt::print(
        stderr,
        "seed {}: error {:.3g} after {} iterations, {:.1f} s\n",
        seed,
        fit.error,
        fit.iterations,
        passed.count());
  }
  writeNewFile(command.out, asJson(shard));
  fmt::print("{} holds {} of {} seeds.\n", command.out, shard.results.size(), shard.seeds);
  return 0;
}

void addSwarm(CLI::App& noun, Action& action) {
  auto command = std::make_shared<SwarmCommand>();
  auto& settings = command->settings;
  auto* verb = noun.add_subcommand("swarm", "The paper's way to densities, seed by seed");
  verb->add_option("PACKING", command->packing, "As 'palpate packing build' made it")->required();
  addMaterialOptions(*verb, command->material);
  verb->add_option("--curve", command->curve, "Of the material")
      ->check(CLI::IsMember({"minimum", "average", "maximum"}))
      ->capture_default_str();
  verb->add_option("--layers", settings.layers, "By depth; 0: every sphere for itself")
      ->check(CLI::Range(0, 1000))
      ->capture_default_str();
  verb->add_option("--particles", settings.particles, "Of each swarm")
      ->check(CLI::Range(2, 100'000))
      ->capture_default_str();
  verb->add_option("--iterations", settings.iterations, "At most")
      ->check(CLI::Range(1, 100'000'000))
      ->capture_default_str();
  verb->add_option("--seconds", settings.seconds, "At most, for each seed; 0: no limit")
      ->check(finiteRange(0.0, 1e6))
      ->capture_default_str();
  verb->add_option("--seeds", settings.seeds, "From 1 on, in all shards together")
      ->check(CLI::Range(1, 100'000))
      ->capture_default_str();
  verb->add_option("--shard", command->shard, "Which of how many parts of the seeds, e.g. 2/5")
      ->capture_default_str();
  verb->add_option("--threads", command->threads, "However many, the same swarm")
      ->check(CLI::Range(1, 256))
      ->capture_default_str();
  verb->add_option("--out", command->out, "A new JSON file")->required();
  verb->callback([&action, command] { action = [command] { return swarm(*command); }; });
}

int merge(const std::vector<std::string>& files) {
  std::vector<SwarmShard> shards;
  for (const auto& file : files) {
    questionnaires::Problems problems;
    auto shard = readSwarmShard(questionnaires::readTextFile(file), problems);
    if (!shard) throw UserError(file + ":\n" + questionnaires::inWords(problems.all()));
    shards.push_back(std::move(*shard));
  }
  std::string wrong;
  for (const auto& problem : problemsOf(shards)) wrong += "\n  " + problem + ".";
  if (!wrong.empty()) throw UserError("The shards are not one whole experiment:" + wrong);
  std::vector<SwarmSeed> all;
  for (const auto& shard : shards) {
    all.insert(all.end(), shard.results.begin(), shard.results.end());
  }
  std::sort(all.begin(), all.end(), [](const auto& a, const auto& b) { return a.error < b.error; });
  double seconds = 0.0;
  for (const auto& seed : all) seconds += seed.seconds;
  const auto& settings = shards.front();
  fmt::print(
      "{} seeds, {} particles, {}; {}\nerror: best {:.4g}, median {:.4g}, worst {:.4g}; {:.1f} s "
      "for each on average.\n",
      all.size(),
      settings.particles,
      settings.layers > 0 ? fmt::format("{} layers", settings.layers)
                          : std::string("every sphere for itself"),
      settings.material,
      all.front().error,
      all[all.size() / 2].error,
      all.back().error,
      seconds / static_cast<double>(all.size()));
  return 0;
}

void addMerge(CLI::App& noun, Action& action) {
  auto files = std::make_shared<std::vector<std::string>>();
  auto* verb = noun.add_subcommand("merge", "Shards of a swarm to one result, if all are there");
  verb->add_option("FILES", *files, "As 'palpate packing swarm' wrote them")->required();
  verb->callback([&action, files] { action = [files] { return merge(*files); }; });
}

}  // namespace

void addSwarmCommands(CLI::App& packing, Action& action) {
  addSwarm(packing, action);
  addMerge(packing, action);
}

}  // namespace study::app
