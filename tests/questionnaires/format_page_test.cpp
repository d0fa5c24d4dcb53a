// docs/questionnaire-format.md promises that its examples can be used.
#include "tests/support/format_page.h"

#include <algorithm>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "questionnaires/json/document.h"
#include "questionnaires/reading/instrument_file.h"
#include "questionnaires/reading/wording.h"
#include "tests/support/scratch_folder.h"
#include "tests/support/test_data.h"

namespace questionnaires {
namespace format_page_test {

const std::string kPage =
    tests::contentOf((tests::repository() / "docs/questionnaire-format.md").string());

std::vector<std::string> examples() {
  return tests::jsonExamples(kPage, "");
}

/// An example is a whole instrument, or one item of an instrument that has a scale.
std::string wholeInstrument(const std::string& example) {
  if (example.find("\"$schema\"") != std::string::npos) return example;
  return R"({"$schema": "instrument-1.schema.json", "id": "example", "version": "1",
             "title": "Example", "source": {"citation": "c", "licence": "l"}, "languages": ["en"],
             "scale": {"points": 5, "low_label": "no", "high_label": "yes"}, "items": [)" +
         example + "]}";
}

TEST(QuestionnaireFormatPage, HasExamplesThatCanBeUsed) {
  const auto blocks = examples();
  EXPECT_GE(blocks.size(), 10U);
  for (const auto& block : blocks) {
    Problems problems;
    EXPECT_TRUE(readInstrument(wholeInstrument(block), problems).has_value())
        << block << describe(problems.all());
  }
}

TEST(QuestionnaireFormatPage, ExplainsEveryKey) {
  const auto schema = tests::repository() / "questionnaires/library/instrument-1.schema.json";
  tests::expectEveryKey(kPage, schema.string(), 35);
}

TEST(QuestionnaireFormatPage, ExplainsEveryKeyOfAWordingFile) {
  Problems problems;
  const std::string json = wordingTemplate({.id = "any", .version = "1"}, "en");
  const auto file = parseJson(json, problems);
  ASSERT_TRUE(file.has_value());
  const auto keys = Node(*file, "$", problems).members();
  EXPECT_EQ(keys.size(), 8U);
  for (const auto& member : keys) {
    EXPECT_NE(kPage.find("`" + member.first + "`"), std::string::npos) << member.first;
  }
}

TEST(QuestionnaireFormatPage, ShowsEveryTypeOfItem) {
  const auto blocks = examples();
  for (const auto& type : kItemTypes) {
    EXPECT_TRUE(std::any_of(blocks.begin(), blocks.end(), [&](const std::string& block) {
      return block.find("\"type\": \"" + std::string(type.name) + "\"") != std::string::npos;
    })) << type.name;
  }
}

TEST(InstrumentSchema, HasARuleForEveryTypeOfItem) {
  std::set<std::string> types;
  for (const auto& type : kItemTypes) types.emplace(type.name);
  const auto schema = tests::repository() / "questionnaires/library/instrument-1.schema.json";
  const auto values = tests::valuesInSchema(schema.string(), "item", "type");
  EXPECT_EQ(values.listed, types);
  EXPECT_EQ(values.withRule, types);
}

TEST(QuestionnaireFormatPage, ListsTheWholeLibrary) {
  const std::filesystem::path folder = tests::repository() / "questionnaires/library";
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    const std::string name = entry.path().stem().string();
    EXPECT_NE(kPage.find("`" + name), std::string::npos) << name;
  }
}

}  // namespace format_page_test
}  // namespace questionnaires
