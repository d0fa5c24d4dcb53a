// A question about a benchmark needs one; a question about vibration, removal or full forces needs
// a scene that renders them.
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "protocols/load_protocol.h"
#include "protocols/model/messages.h"
#include "protocols/validation/validation.h"
#include "questionnaires/json/document.h"
#include "questionnaires/reading/instrument_file.h"
#include "tests/protocols/small_protocol.h"
#include "tests/support/test_data.h"

namespace protocols {
namespace referents_test {

using haptics::engine::MaterialSpec;
using haptics::engine::PackingSpec;

/// An instrument of two sets; the statement of the second is about a benchmark.
const std::string kTwoSets =
    R"({"$schema": "instrument-1.schema.json", "id": "mine", "version": "1",
  "title": "T", "source": {"citation": "c", "licence": "l"}, "languages": ["en"],
  "scale": {"points": 5, "low_label": "no", "high_label": "yes"},
  "items": [{"id": "a", "type": "likert", "text": "Real.", "set": "alone"},
            {"id": "b", "type": "likert", "text": "Alike.", "set": "compared",
             "refers_to": "benchmark"}]})";

tests::Loading loadAsking(const std::string& sets) {
  auto text = tests::with(tests::usualProtocol(), "realism-cuts", "mine");
  text = tests::with(
      text, "\"conditions\": [\n", "\"instrument_files\": [\"mine.json\"],\n  \"conditions\": [\n");
  text = tests::with(
      text,
      R"("questionnaires": [{ "instrument": "mine" }])",
      R"("questionnaires": [{"instrument": "mine", "set_by_condition": )" + sets + "}]");
  return tests::load(text, [](const std::string& name) {
    return name == "mine.json" ? std::optional(kTwoSets) : std::nullopt;
  });
}

TEST(Referents, NeedABenchmarkOnlyWhereAStatementAboutOneIsAsked) {
  EXPECT_TRUE(loadAsking(R"({"soft": "alone", "firm": "alone"})").loaded);
  for (const auto* sets : {R"({"soft": "alone", "firm": "compared"})", R"({"soft": "alone"})"}) {
    const auto loading = loadAsking(sets);
    EXPECT_FALSE(loading.loaded);
    ASSERT_EQ(loading.problems.size(), 1U) << loading.describe();
    EXPECT_EQ(loading.problems[0].path, "$.phases[1].questionnaires[0].instrument");
  }
}

TEST(Referents, AreSatisfiedByABenchmarkBefore) {
  const auto text =
      tests::with(tests::withBenchmark(tests::usualProtocol()), "realism-cuts", "realism-common");
  EXPECT_TRUE(tests::load(text).loaded) << tests::load(text).describe();
}

TEST(Referents, AreNotAskedForInAStudyOfRelease01) {
  auto text = tests::with(tests::usualProtocol(), "realism-cuts", "realism-common");
  text = tests::with(text, "paired_t", "welch");
  questionnaires::Problems problems;
  const auto nothing = [](const std::string&) { return std::nullopt; };
  EXPECT_TRUE(loadProtocol(text, nothing, problems, Defaults::Release01));
  for (const auto& problem : problems.all()) {
    EXPECT_FALSE(problem.path.starts_with("$")) << base::describe(problem.what);
  }
}

/// What is said about a block that asks 'reaming-realism' about one condition.
std::vector<base::Message> saidOf(haptics::engine::ModelSpec model) {
  LoadedProtocol loaded;
  loaded.protocol.conditions.push_back({.id = "bone", .model = std::move(model)});
  Phase block{.id = "reaming", .type = PhaseType::Block};
  block.trials.conditions = {"bone"};
  block.trials.questionnaires.push_back({.instrument = "reaming-realism"});
  loaded.protocol.phases.push_back(block);
  loaded.instruments.push_back(questionnaires::readValidInstrument(
      questionnaires::readTextFile(
          (tests::repository() / "questionnaires/library/reaming-realism.json").string()),
      "reaming-realism"));
  questionnaires::Problems problems;
  addReferentWarnings(loaded, problems);
  std::vector<base::Message> said;
  for (const auto& problem : problems.all()) {
    EXPECT_EQ(problem.path, "$.phases[0].questionnaires[0]");
    said.push_back(problem.what);
  }
  return said;
}

TEST(Referents, OfAScaledBoneThatStaysAreNotRendered) {
  EXPECT_EQ(
      saidOf(MaterialSpec{.forceScale = 0.15}),
      (std::vector{
          message("no_vibration", "vibration", "bone"),
          message("no_removal", "progress", "bone"),
          message("scaled_force", "force-level", "bone", 15)}));
}

TEST(Referents, AreRenderedByJitterByRemovalAndByForcesOfFullSize) {
  EXPECT_EQ(
      saidOf(MaterialSpec{.forceScale = 1.0, .jitter = {.rms = 2.0, .rate = 100.0}}),
      std::vector{message("no_removal", "progress", "bone")});
  EXPECT_TRUE(saidOf(MaterialSpec{.isRemoved = true, .jitter = {.rms = 2.0}}).empty());
  EXPECT_EQ(
      saidOf(PackingSpec{.forceScale = 1.0, .isRemoved = true}),
      std::vector{message("no_vibration", "vibration", "bone")});
}

}  // namespace referents_test
}  // namespace protocols
