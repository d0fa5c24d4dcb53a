#pragma once

#include <string>
#include <vector>

namespace tests {

/// A file of tests/protocols/data, and what is to be said about it (or parts of it).
struct Refusal {
  std::string file;
  std::string path;
  std::string what;
  std::string fix;
};

/// data/bad: what a schema sees too. Study, languages, cohorts, devices, labels …
const std::vector<Refusal>& refusedHeads();
/// … conditions and their scenes …
const std::vector<Refusal>& refusedScenes();
/// … phases, blocks, orders …
const std::vector<Refusal>& refusedPhases();
/// … analysis and simulation.
const std::vector<Refusal>& refusedPlans();

/// data/semantic: what only our reader sees.
const std::vector<Refusal>& semanticRefusals();

}  // namespace tests
