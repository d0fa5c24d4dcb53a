#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "questionnaires/json/problem.h"

namespace study::app {

/// One seed of a swarm, and what it came to.
struct SwarmSeed {
  std::int64_t seed = 1;
  double error = 0.0;  ///< |Aρ − F| / |F|
  std::int64_t iterations = 0;
  double seconds = 0.0;
};

/// The seeds that one of several computers has run: what a cluster's job writes.
struct SwarmShard {
  std::string packing;      ///< SHA-256 of the packing file
  std::string material;     ///< what it was to feel like
  std::int64_t layers = 0;  ///< 0: every sphere for itself
  std::int64_t particles = 40;
  std::int64_t iterations = 500;  ///< at most
  double seconds = 0.0;           ///< at most; 0: as long as it takes
  std::int64_t seeds = 20;        ///< of all shards
  std::int64_t shard = 1;         ///< which of …
  std::int64_t shards = 1;        ///< … how many
  std::vector<SwarmSeed> results;
};

std::string asJson(const SwarmShard& shard);
std::optional<SwarmShard> readSwarmShard(std::string_view json, questionnaires::Problems& problems);

/// Everything that keeps @p shards from being one experiment: other settings, seeds that are
/// missing or there twice. Empty where they are whole.
std::vector<std::string> problemsOf(const std::vector<SwarmShard>& shards);

}  // namespace study::app
