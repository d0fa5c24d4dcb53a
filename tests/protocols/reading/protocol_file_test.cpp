#include "protocols/reading/protocol_file.h"

#include <algorithm>
#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "protocols/load_protocol.h"
#include "protocols/model/loaded_protocol.h"
#include "tests/protocols/small_protocol.h"
#include "tests/support/refused_files.h"
#include "tests/support/scratch_folder.h"
#include "tests/support/test_data.h"

namespace protocols {
namespace protocol_file_test {

using questionnaires::Problem;
using questionnaires::Problems;
using questionnaires::Severity;

struct Reading {
  std::optional<LoadedProtocol> loaded;
  std::vector<Problem> problems;
};

/// Loads a file of the corpora, with what lies beside it.
Reading read(const std::string& kind, const std::string& name) {
  const auto file = tests::repository() / "tests/protocols/data" / kind;
  Problems problems;
  Reading reading{.loaded = loadProtocolFile((file / (name + ".json")).string(), problems)};
  reading.problems = problems.all();
  return reading;
}

std::vector<tests::RefusedFile> refused(const std::string& kind) {
  return tests::refusedFiles(tests::repository() / "tests/protocols/data" / kind);
}

/// Refused, with the problem that is expected, where it is expected, and how to correct it.
void expectRefusals(const std::string& kind) {
  for (const auto& file : refused(kind)) {
    const auto reading = read(kind, file.name);
    EXPECT_FALSE(reading.loaded.has_value()) << file.name;
    tests::expectProblem(file, reading.problems);
  }
}

TEST(ProtocolFile, ReportsStructuralProblemsWithTheirFix) {
  expectRefusals("bad");
}

TEST(ProtocolFile, ReportsWhatNoSchemaCanCheck) {
  expectRefusals("semantic");
}

TEST(ProtocolFile, SaysNothingTwiceAndLittleThatFollows) {
  for (const auto* kind : {"bad", "semantic"}) {
    for (const auto& refusal : refused(kind)) {
      const auto reading = read(kind, refusal.name);
      std::set<std::pair<std::string, std::string>> said;
      for (const auto& problem : reading.problems) {
        EXPECT_TRUE(said.insert({problem.path, base::describe(problem.what)}).second)
            << refusal.name;
        EXPECT_EQ(problem.severity, Severity::Error) << refusal.name;
      }
      EXPECT_LE(said.size(), 3U) << refusal.name << "\n" << describe(reading.problems);
    }
  }
}

TEST(ProtocolFile, SaysInOneSentenceThatATableOrACutIsNoProtocol) {
  const tests::ScratchFolder folder;
  Problems problems;
  EXPECT_FALSE(loadProtocolFile(folder.write("bench.csv", "t_ms,load_N\n0,0\n"), problems));
  ASSERT_EQ(problems.all().size(), 1U);
  EXPECT_EQ(base::describe(problems.all()[0].what), "this is a table (CSV), not a protocol");
  EXPECT_EQ(read("bad", "a-cut").problems.size(), 1U);
}

TEST(ProtocolFile, ReadsValidProtocols) {
  for (const auto& name : tests::corpusNames("good")) {
    const auto reading = read("good", name);
    EXPECT_TRUE(reading.loaded.has_value()) << name << "\n" << describe(reading.problems);
  }
}

TEST(ProtocolFile, ReportsAllProblemsAtOnce) {
  const auto loading = tests::load(
      R"({"$schema": "protocol-2.schema.json",
          "study": {"id": "my study", "title": "", "versoin": "1"},
          "languages": ["de"],
          "cohorts": [{"id": "a", "title": "A"}, {"id": "a", "title": "B", "planned": 1.5}],
          "devices": [{"id": "d", "kind": "punch", "max_force_n": "8",
                       "max_force_rate_n_per_s": 1e308}],
          "instrument_files": ["../mine.json"],
          "conditions": [
            {"id": "x", "title": "X", "scene": {"device": "e", "model": "interpolation",
             "parameters": {"cut": "away.json", "beyound": "hold"}}},
            {"id": "y", "title": "Y", "scene": {"device": "d", "model": "finite-elements",
             "parameters": {"tool_position": 3}}}],
          "labels": {"policy": "rnadom"},
          "phases": [
            {"id": "b", "type": "block", "conditions": ["x", "z"], "minimum_cuts": 0,
             "order": {"type": "reversed", "of": "b"},
             "questionnaires": [{"instrument": "realism-cuts"}]},
            {"id": "p", "type": "preference", "instrument": "debrief", "block": "c"}],
          "analysis": {"families": [
            {"id": "f", "title": "F", "instrument": "realism-cuts", "test": "welsh",
             "correction": "none", "alpha": 1.5,
             "comparisons": [{"first": "x", "second": "x"}, {"first": "x", "second": "w"}]}]},
          "simulation": {"realism": {"w": 0}, "answer_deviation": -1}})");
  EXPECT_FALSE(loading.loaded.has_value());
  std::vector<std::string> places;
  for (const auto& problem : loading.problems)
    places.push_back(problem.path + " " + base::describe(problem.what));
  const std::vector<std::string> expected{
      "$.$schema this is written for 'protocol-2.schema.json'",
      "$.study.versoin unknown key 'versoin'",
      "$.study.id 'my study' cannot be an id",
      "$.study.title this text is empty",
      "$.study 'version' is missing",
      "$.languages 'en' is not among the languages",
      "$.cohorts[1].planned a whole number is expected here, not one with a decimal point",
      "$.devices[0].max_force_n a number is expected here, not a text",
      "$.devices[0].max_force_rate_n_per_s this number is out of range",
      "$.conditions[0].scene.parameters.beyound unknown key 'beyound'",
      "$.conditions[0].scene.parameters.cut there is no file 'away.json'",
      "$.labels.policy unknown word 'rnadom'",
      "$.phases[0].minimum_cuts this number is out of range",
      "$.analysis.families[0].test unknown word 'welsh'",
      "$.analysis.families[0].alpha this number is out of range",
      "$.simulation.answer_deviation this number is out of range",
      "$.instrument_files[0] '../mine.json' lies outside the protocol's folder",
      "$.cohorts[1].id two cohorts share the id 'a'",
      "$.conditions[0].scene.device there is no device 'e' in this protocol",
      "$.conditions[1].scene.parameters the finite elements need start < tool position < end, one "
      "or more elements, a stiffness above 0 and a yield force that is not negative",
      "$.phases[0] something is felt here before anybody has agreed to take part",
      "$.phases[1].instrument 'debrief' does not ask for an alternative",
      "$.phases[0].conditions[1] there is no condition 'z'",
      "$.phases[0].order.of the orders of these blocks refer to each other in a circle",
      "$.phases[1].block there is no block 'c'",
      "$.analysis.families[0].comparisons[0] a condition is compared with itself",
      "$.analysis.families[0].comparisons[1].second there is no condition 'w'",
      "$.simulation.realism.w there is no condition 'w'",
  };
  EXPECT_EQ(places, expected);
}

TEST(ProtocolFile, ReportsWrongParametersOfAModelThatIsMisnamed) {
  for (const auto* model : {"fem", "finite-element"}) {
    auto json =
        tests::with(tests::usualProtocol(), "\"finite-elements\"", '"' + std::string(model) + '"');
    json = tests::with(json, "yield_force_n", "yield_force");
    const auto described = tests::load(json).describe();
    for (const auto* part :
         {"$.conditions[0].scene.model",
          "did you mean 'finite-elements'?",
          "$.conditions[0].scene.parameters.yield_force: unknown key 'yield_force'",
          "did you mean 'yield_force_n'?",
          "$.conditions[1].scene.parameters.yield_force"}) {
      EXPECT_NE(described.find(part), std::string::npos) << part << "\n" << described;
    }
  }
}

TEST(ProtocolFile, OffersAFixForEveryProblemExceptWrongTypes) {
  const std::vector<std::string> clear{"a number is expected here", "true or false is expected"};
  for (const auto* kind : {"bad", "semantic"}) {
    for (const auto& refusal : refused(kind)) {
      for (const auto& problem : read(kind, refusal.name).problems) {
        const bool isClear = std::any_of(clear.begin(), clear.end(), [&](const auto& words) {
          return base::describe(problem.what).starts_with(words);
        });
        EXPECT_TRUE(isClear || !problem.fix.empty())
            << refusal.name << " " << base::describe(problem.what);
      }
    }
  }
}

std::optional<std::string> nothing(const std::string& /*name*/) {
  return std::nullopt;
}

TEST(ProtocolFile, KeepsProblemsThatWereFoundBefore) {
  Problems problems;
  problems.add("$", "something else");
  EXPECT_TRUE(loadProtocol(tests::usualProtocol(), nothing, problems).has_value());
  EXPECT_EQ(problems.all()[0].what, base::Message::verbatim("something else"));
}

TEST(ProtocolFile, ReadsAProtocolWithErrorsAsFarAsItCan) {
  Problems problems;
  const auto text = tests::with(tests::usualProtocol(), "random", "by chance");
  EXPECT_FALSE(loadProtocol(text, nothing, problems).has_value());
  EXPECT_TRUE(readUnvalidatedProtocol(text, nothing, problems).has_value());
  EXPECT_FALSE(readUnvalidatedProtocol("[]", nothing, problems).has_value());
}

}  // namespace protocol_file_test
}  // namespace protocols
