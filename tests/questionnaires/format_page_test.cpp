// docs/questionnaire-format.md promises that its examples can be used.
#include <algorithm>
#include <set>
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

/// What stands between "```json" and "```".
std::vector<std::string> examples() {
  const std::string opening = "```json\n";
  std::vector<std::string> blocks;
  std::size_t start = kPage.find(opening);
  while (start != std::string::npos) {
    start += opening.size();
    const std::size_t end = kPage.find("```", start);
    blocks.push_back(kPage.substr(start, end - start));
    start = kPage.find(opening, end);
  }
  return blocks;
}

/// An example is a whole instrument, or one item of an instrument that has a scale.
std::string wholeInstrument(const std::string& example) {
  if (example.find("\"$schema\"") != std::string::npos) return example;
  return R"({"$schema": "instrument-1.schema.json", "id": "example", "version": "1",
             "title": "Example", "source": {"citation": "c", "licence": "l"}, "languages": ["en"],
             "scale": {"points": 5, "low_label": "no", "high_label": "yes"}, "items": [)" +
         example + "]}";
}

/// Every key that objects have anywhere in the schema's "properties".
void collectKeys(const Node& node, std::set<std::string>& keys) {
  for (const auto& [key, value] : node.members()) {
    if (key == "properties") {
      for (const auto& member : value.members()) keys.insert(member.first);
    }
    collectKeys(value, keys);
  }
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
  Problems problems;
  const std::string file =
      (tests::repository() / "questionnaires/library/instrument-1.schema.json").string();
  const auto schema = parseJson(readTextFile(file), problems);
  ASSERT_TRUE(schema.has_value());
  std::set<std::string> keys;
  collectKeys(Node(*schema, "$", problems), keys);
  EXPECT_GE(keys.size(), 35U);
  for (const auto& key : keys) {
    EXPECT_NE(kPage.find("`" + key + "`"), std::string::npos) << key;
  }
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

TEST(QuestionnaireFormatPage, ListsTheWholeLibrary) {
  const std::filesystem::path folder = tests::repository() / "questionnaires/library";
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    const std::string name = entry.path().stem().string();
    EXPECT_NE(kPage.find("`" + name), std::string::npos) << name;
  }
}

}  // namespace format_page_test
}  // namespace questionnaires
