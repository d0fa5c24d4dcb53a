#include "tests/protocols/small_protocol.h"

#include <algorithm>
#include <filesystem>
#include <utility>

#include <gtest/gtest.h>

#include "protocols/load_protocol.h"
#include "questionnaires/json/document.h"
#include "tests/support/test_data.h"

namespace tests {
namespace {

const std::filesystem::path kCorpora = tests::repository() / "tests/protocols/data";

}  // namespace

std::string corpusText(std::string_view kind, std::string_view name) {
  return questionnaires::readTextFile((kCorpora / kind / (std::string(name) + ".json")).string());
}

std::vector<std::string> corpusNames(std::string_view kind) {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(kCorpora / kind)) {
    if (entry.path().extension() == ".json") names.push_back(entry.path().stem().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

std::string usualProtocol() {
  return corpusText("good", "usual");
}

std::string with(std::string text, std::string_view part, std::string_view other) {
  EXPECT_NE(text.find(part), std::string::npos) << part;
  for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at)) {
    text.replace(at, part.size(), other);
    at += other.size();
  }
  return text;
}

std::string withPhases(const std::vector<std::string>& phases) {
  const std::string end = "\n  ],\n  \"analysis\"";
  std::string added;
  for (const auto& phase : phases) added += ", " + phase;
  return with(usualProtocol(), end, added + end);
}

std::string withBenchmark(const std::string& text) {
  const std::string consent = R"("instrument": "consent-punch" },)";
  const std::string benchmark =
      R"({"id": "real", "type": "benchmark", "text": "Please cut.", "minimum_cuts": 3},)";
  return with(text, consent, consent + benchmark);
}

std::string reamingProtocol(
    const std::string& model, const std::string& parametersOfA, const std::string& parametersOfB) {
  const auto scene = [&](const std::string& parameters) {
    return R"({"device": "arm", "model": ")" + model + R"(", "parameters": )" + parameters + "}";
  };
  return R"({
    "$schema": "protocol-1.schema.json",
    "study": {"id": "bone", "title": "Bone", "version": "1"},
    "languages": ["en"], "cohorts": [{"id": "all", "title": "All"}],
    "devices": [{"id": "arm", "kind": "reamer", "max_force_n": 100,
                 "max_force_rate_n_per_s": 5000}],
    "conditions": [
      {"id": "a", "title": "A", "scene": )" +
         scene(parametersOfA) + R"(},
      {"id": "b", "title": "B", "scene": )" +
         scene(parametersOfB) + R"(}],
    "labels": {"policy": "random"},
    "phases": [{"id": "consent", "type": "consent", "instrument": "consent-punch"},
               {"id": "felt", "type": "block", "conditions": ["a", "b"],
                "order": {"type": "balancedLatinSquare"}, "minimum_cuts": 1}]})";
}

Loading load(std::string_view json, const protocols::FileFinder& find) {
  const protocols::FileFinder nothing = [](const std::string&) { return std::nullopt; };
  questionnaires::Problems problems;
  Loading loading;
  loading.loaded = protocols::loadProtocol(json, find ? find : nothing, problems);
  loading.problems = problems.all();
  return loading;
}

protocols::Protocol soundProtocol(std::string_view json) {
  const auto loading = load(json);
  EXPECT_TRUE(loading.loaded.has_value()) << loading.describe();
  return loading.loaded ? loading.loaded->protocol : protocols::Protocol();
}

}  // namespace tests
