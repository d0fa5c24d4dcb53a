#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "protocols/model/loaded_protocol.h"
#include "questionnaires/json/problem.h"

namespace tests {

/// The text of a file of tests/protocols/data, by kind ("good") and name ("usual").
std::string corpusText(std::string_view kind, std::string_view name);

/// The names of all files of a kind.
std::vector<std::string> corpusNames(std::string_view kind);

/// data/good/usual.json: two conditions on a punch, one block.
std::string usualProtocol();

/// @p text with @p part replaced by @p other, everywhere; fails the test where there is no @p part.
std::string with(std::string text, std::string_view part, std::string_view other);

/// usualProtocol() with phases after its own, each a JSON object.
std::string withPhases(const std::vector<std::string>& phases);

/// @p text, usualProtocol() or made of it, with a benchmark before its block, which then is
/// phase 2.
std::string withBenchmark(const std::string& text);

/// A protocol of two conditions of @p model on a reamer, one block; the parameters of both are JSON
/// objects.
std::string reamingProtocol(
    const std::string& model, const std::string& parametersOfA, const std::string& parametersOfB);

/// A protocol as loaded, or not, and all that was said.
struct Loading {
  std::optional<protocols::LoadedProtocol> loaded;
  std::vector<questionnaires::Problem> problems;

  std::string describe() const { return questionnaires::describe(problems); }
};

/// Loads @p json; the files that it names come from @p find.
Loading load(std::string_view json, const protocols::FileFinder& find = {});

/// The protocol itself; fails the test where it is not sound.
protocols::Protocol soundProtocol(std::string_view json);

}  // namespace tests
