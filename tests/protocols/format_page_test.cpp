// docs/protocol-format.md promises that its examples work and that every key is explained.
#include "tests/support/format_page.h"

#include <optional>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "haptics/engine/model_names.h"
#include "protocols/load_protocol.h"
#include "protocols/reading/cut_file.h"
#include "protocols/reading/recording_file.h"
#include "tests/protocols/small_protocol.h"
#include "tests/support/scratch_folder.h"
#include "tests/support/test_data.h"

namespace protocols {
namespace format_page_test {

namespace engine = haptics::engine;

std::string page() {
  return tests::contentOf((tests::repository() / "docs/protocol-format.md").string());
}

std::vector<std::string> examples(const std::string& kind) {
  return tests::jsonExamples(page(), kind);
}

TEST(ProtocolFormatPage, HasAWholeProtocolThatIsSound) {
  const auto whole = examples("");
  ASSERT_EQ(whole.size(), 1U);
  const auto loading = tests::load(whole[0]);
  EXPECT_TRUE(loading.loaded) << loading.describe();
}

/// The page's whole protocol, with a reamer besides.
nlohmann::json wholeWithReamer() {
  auto whole = nlohmann::json::parse(examples("").at(0));
  whole["devices"].push_back(
      {{"id", "reamer"},
       {"kind", "reamer"},
       {"max_force_n", 140},
       {"max_force_rate_n_per_s", 5000}});
  return whole;
}

/// Loads @p protocol with the page's cut beside it, under the name that the cut bears.
tests::Loading loadWithCut(const nlohmann::json& protocol) {
  const auto cut = examples(" cut").at(0);
  const auto name = nlohmann::json::parse(cut)["name"].get<std::string>() + ".json";
  return tests::load(protocol.dump(), [&](const std::string& file) {
    return file == name ? std::optional(cut) : std::nullopt;
  });
}

/// The models of the conditions in @p protocol.
std::set<std::string> modelsIn(const nlohmann::json& protocol) {
  std::set<std::string> models;
  for (const auto& condition : protocol["conditions"]) {
    models.insert(condition["scene"]["model"].get<std::string>());
  }
  return models;
}

const std::set<std::string> kModels(engine::kModelNames.begin(), engine::kModelNames.end());

TEST(ProtocolFormatPage, HasConditionsThatFitIntoItAndShowsEveryModel) {
  const auto conditions = examples(" fragment");
  std::set<std::string> models;
  for (const auto& condition : conditions) {
    auto whole = wholeWithReamer();
    whole["conditions"].push_back(nlohmann::json::parse(condition));
    models.merge(modelsIn(whole));
    const auto loading = loadWithCut(whole);
    EXPECT_TRUE(loading.loaded) << condition << loading.describe();
  }
  EXPECT_EQ(models, kModels);
}

TEST(ProtocolSchema, HasARuleForEveryModel) {
  const auto schema = tests::repository() / "protocols/library/protocol-1.schema.json";
  const auto values = tests::valuesInSchema(schema.string(), "scene", "model");
  EXPECT_EQ(values.listed, kModels);
  EXPECT_EQ(values.withRule, kModels);
}

TEST(ProtocolFormatPage, HasPhasesThatFitIntoIt) {
  const auto phases = examples(" phase");
  EXPECT_GE(phases.size(), 4U);
  auto whole = nlohmann::json::parse(examples("").at(0));
  for (const auto& phase : phases) whole["phases"].push_back(nlohmann::json::parse(phase));
  const auto loading = tests::load(whole.dump());
  EXPECT_TRUE(loading.loaded) << loading.describe();
}

TEST(ProtocolFormatPage, HasTextsThatFitIntoItAndNamesEveryBlank) {
  auto whole = nlohmann::json::parse(examples("").at(0));
  whole["texts"] = nlohmann::json::parse(examples(" texts").at(0));
  const auto loading = tests::load(whole.dump());
  ASSERT_TRUE(loading.loaded) << loading.describe();
  EXPECT_EQ(loading.loaded->protocol.texts.size(), whole["texts"].size());
  questionnaires::Problems problems;
  const auto shipped = loadProtocolFile("punch-face-validity", problems);
  ASSERT_TRUE(shipped);
  for (const auto& key : shipped->blanks) {
    EXPECT_NE(page().find("`" + key + "`"), std::string::npos) << key;
  }
}

TEST(ProtocolFormatPage, HasNoExampleThatIsNotRead) {
  const std::string text = page();
  std::size_t all = 0;
  for (auto at = text.find("```json"); at != std::string::npos; at = text.find("```json", at + 1)) {
    ++all;
  }
  std::size_t read = 0;
  for (const auto* kind :
       {"", " fragment", " phase", " cut", " columns", " calibration", " texts"}) {
    read += examples(kind).size();
  }
  EXPECT_EQ(read, all);
}

TEST(ProtocolFormatPage, HasCutsThatCanBeRead) {
  const auto cuts = examples(" cut");
  ASSERT_FALSE(cuts.empty());
  for (const auto& cut : cuts) {
    questionnaires::Problems problems;
    EXPECT_TRUE(readCut(cut, problems)) << questionnaires::describe(problems.all());
  }
}

TEST(ProtocolFormatPage, ExplainsEveryKey) {
  const auto schema = tests::repository() / "protocols/library/protocol-1.schema.json";
  tests::expectEveryKey(page(), schema.string(), 60);
}

TEST(ProtocolFormatPage, ExplainsEveryKeyOfACut) {
  // A key of each kind that the reader knows is named where another one is refused.
  const std::string text = page();
  auto cut = nlohmann::json::parse(examples(" cut").at(0));
  for (const auto* place : {"", "/curve/0", "/landmarks", "/provenance"}) {
    auto wrong = cut;
    wrong[nlohmann::json::json_pointer(place)]["zzzzzzzzzzzzzzzz"] = 1;
    questionnaires::Problems problems;
    readCut(wrong.dump(), problems);
    ASSERT_EQ(problems.all().size(), 1U) << questionnaires::describe(problems.all());
    const std::string opening = "known here: ";
    std::string known = base::describe(problems.all()[0].fix);
    ASSERT_TRUE(known.starts_with(opening)) << known;
    known = known.substr(opening.size()) + ", ";
    for (auto end = known.find(", "); end != std::string::npos; end = known.find(", ")) {
      const auto key = known.substr(0, end);
      EXPECT_NE(text.find("`" + key + "`"), std::string::npos) << key;
      known.erase(0, end + 2);
    }
  }
}

TEST(ProtocolFormatPage, HasTheSectionsThatMessagesReferTo) {
  for (const auto* heading : {"\n## Scenes\n", "\n## Cut files\n"}) {
    EXPECT_NE(page().find(heading), std::string::npos) << heading;
  }
}

TEST(ProtocolFormatPage, ExplainsEveryWord) {
  const auto schema = nlohmann::json::parse(tests::contentOf(
      (tests::repository() / "protocols/library/protocol-1.schema.json").string()));
  const std::string text = page();
  const auto parts = schema.flatten();  // outlives what items() looks at
  for (const auto& part : parts.items()) {
    const bool isWord = part.key().find("/enum/") != std::string::npos;
    if (!isWord) continue;
    const auto word = part.value().get<std::string>();
    EXPECT_NE(text.find("`" + word + "`"), std::string::npos) << word;
  }
}

TEST(ProtocolFormatPage, HasAColumnsFileAndACalibrationFileThatAreSound) {
  const auto columns = examples(" columns");
  ASSERT_EQ(columns.size(), 1U);
  questionnaires::Problems problems;
  EXPECT_TRUE(readColumns(columns[0], problems)) << questionnaires::describe(problems.all());
  const auto calibrations = examples(" calibration");
  ASSERT_EQ(calibrations.size(), 1U);
  EXPECT_TRUE(readCalibration(calibrations[0], problems))
      << questionnaires::describe(problems.all());
}

}  // namespace format_page_test
}  // namespace protocols
