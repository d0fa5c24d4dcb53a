#include "study/app/measurements/swarm_file.h"

#include <map>
#include <tuple>

#include <nlohmann/json.hpp>

#include "questionnaires/json/document.h"

namespace study::app {
namespace {

constexpr std::string_view kSwarmFormat = "palpate-swarm-1";
constexpr std::int64_t kMost = 1'000'000'000;
constexpr std::int64_t kMostSeeds = 100'000;

/// What all shards of an experiment have in common.
auto settingsOf(const SwarmShard& s) {
  return std::tie(
      s.packing, s.material, s.layers, s.particles, s.iterations, s.seconds, s.seeds, s.shards);
}

}  // namespace

std::string asJson(const SwarmShard& shard) {
  nlohmann::ordered_json json{
      {"format", kSwarmFormat},
      {"packing_sha256", shard.packing},
      {"material", shard.material},
      {"layers", shard.layers},
      {"particles", shard.particles},
      {"iterations", shard.iterations},
      {"seconds", shard.seconds},
      {"seeds", shard.seeds},
      {"shard", shard.shard},
      {"shards", shard.shards},
      {"results", nlohmann::ordered_json::array()}};
  for (const auto& seed : shard.results) {
    json["results"].push_back(
        {{"seed", seed.seed},
         {"error", seed.error},
         {"iterations", seed.iterations},
         {"seconds", seed.seconds}});
  }
  return json.dump(1) + "\n";
}

std::optional<SwarmShard> readSwarmShard(
    std::string_view json, questionnaires::Problems& problems) {
  questionnaires::Problems found;
  std::optional<SwarmShard> shard;
  if (const auto value = questionnaires::parseJson(json, found)) {
    const questionnaires::Node root(*value, "$", found);
    const bool isOne = root.isObjectWith(
        {"format",
         "packing_sha256",
         "material",
         "layers",
         "particles",
         "iterations",
         "seconds",
         "seeds",
         "shard",
         "shards",
         "results"});
    if (isOne && root.text("format") != kSwarmFormat) {
      root.problem("format", "this holds no swarm", "write one with 'palpate packing swarm'");
    }
    if (isOne) {
      shard = SwarmShard{
          .packing = root.text("packing_sha256"),
          .material = root.text("material"),
          .layers = root.wholeNumber("layers", 0, kMost),
          .particles = root.wholeNumber("particles", 1, kMost),
          .iterations = root.wholeNumber("iterations", 1, kMost),
          .seconds = root.number("seconds", 0.0, 1e9),
          .seeds = root.wholeNumber("seeds", 1, kMostSeeds),
          .shard = root.wholeNumber("shard", 1, kMost),
          .shards = root.wholeNumber("shards", 1, kMost),
          .results = {}};
      for (const auto& node : root.list("results")) {
        if (!node.isObjectWith({"seed", "error", "iterations", "seconds"})) continue;
        shard->results.push_back(
            {node.wholeNumber("seed", 1, kMost),
             node.number("error", 0.0, 1e300),
             node.wholeNumber("iterations", 0, kMost),
             node.number("seconds", 0.0, 1e9)});
      }
    }
  }
  problems.append(found);
  return found.hasErrors() ? std::nullopt : std::move(shard);
}

std::vector<std::string> problemsOf(const std::vector<SwarmShard>& shards) {
  if (shards.empty()) return {"there are no shards"};
  std::vector<std::string> problems;
  std::map<std::int64_t, int> seen;
  for (const auto& shard : shards) {
    if (settingsOf(shard) != settingsOf(shards.front())) {
      problems.push_back(
          "shard " + std::to_string(shard.shard) +
          " is of another experiment: its packing, material or settings differ");
    }
    for (const auto& seed : shard.results) ++seen[seed.seed];
  }
  std::string missing;
  for (std::int64_t seed = 1; seed <= shards.front().seeds; ++seed) {
    if (seen.count(seed) == 0) missing += (missing.empty() ? "" : ", ") + std::to_string(seed);
  }
  if (!missing.empty()) problems.push_back("seeds are missing: " + missing);
  for (const auto& [seed, times] : seen) {
    if (times > 1) problems.push_back("seed " + std::to_string(seed) + " is there twice");
    if (seed > shards.front().seeds) {
      problems.push_back("seed " + std::to_string(seed) + " is none of this experiment's");
    }
  }
  return problems;
}

}  // namespace study::app
