#pragma once

#include <string>
#include <vector>

namespace tests {

/// A file of tests/questionnaires/data, and what is to be said about it (or parts of it).
struct Refusal {
  std::string file;
  std::string path;
  std::string what;
  std::string fix;
};

/// data/bad: what a schema sees too.
const std::vector<Refusal>& structuralRefusals();

/// data/semantic: what only our reader sees.
const std::vector<Refusal>& semanticRefusals();

}  // namespace tests
