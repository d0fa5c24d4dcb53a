// docs/protocol-format.md promises that its examples work and that every key is explained.
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "protocols/cut_file.h"
#include "tests/protocols/small_protocol.h"
#include "tests/support/scratch_folder.h"

namespace protocols {
namespace {

std::string page() {
  return tests::contentOf(std::string(PALPATE_SOURCE_DIR) + "/docs/protocol-format.md");
}

/// The examples after "```json" and @p kind.
std::vector<std::string> examples(const std::string& kind) {
  const std::string text = page();
  const std::string begin = "```json" + kind + "\n";
  std::vector<std::string> found;
  for (auto at = text.find(begin); at != std::string::npos; at = text.find(begin, at + 1)) {
    const auto start = at + begin.size();
    found.push_back(text.substr(start, text.find("```", start) - start));
  }
  return found;
}

/// Every name under a "properties" of the schema.
void collectKeys(const nlohmann::json& schema, std::set<std::string>& keys) {
  if (!schema.is_structured()) return;
  for (const auto& [name, part] : schema.items()) {
    if (name == "properties" && part.is_object()) {
      for (const auto& [key, value] : part.items()) keys.insert(key);
    }
    collectKeys(part, keys);
  }
}

TEST(ProtocolFormatPage, HasAWholeProtocolThatIsSound) {
  const auto whole = examples("");
  ASSERT_EQ(whole.size(), 1U);
  const auto loading = tests::load(whole[0]);
  EXPECT_TRUE(loading.loaded) << loading.inWords();
}

TEST(ProtocolFormatPage, HasConditionsThatFitIntoIt) {
  const auto conditions = examples(" fragment");
  ASSERT_FALSE(conditions.empty());
  auto whole = nlohmann::json::parse(examples("").at(0));
  for (const auto& condition : conditions) {
    whole["conditions"].push_back(nlohmann::json::parse(condition));
  }
  const auto loading = tests::load(whole.dump());
  EXPECT_TRUE(loading.loaded) << loading.inWords();
}

TEST(ProtocolFormatPage, HasCutsThatCanBeRead) {
  const auto cuts = examples(" cut");
  ASSERT_FALSE(cuts.empty());
  for (const auto& cut : cuts) {
    questionnaires::Problems problems;
    EXPECT_TRUE(readCut(cut, problems)) << questionnaires::inWords(problems.all());
  }
}

TEST(ProtocolFormatPage, ExplainsEveryKey) {
  const auto schema = nlohmann::json::parse(tests::contentOf(
      std::string(PALPATE_SOURCE_DIR) + "/protocols/library/protocol-1.schema.json"));
  std::set<std::string> keys;
  collectKeys(schema, keys);
  EXPECT_GE(keys.size(), 60U);
  const std::string text = page();
  for (const auto& key : keys) {
    EXPECT_NE(text.find("`" + key + "`"), std::string::npos) << key;
  }
}

TEST(ProtocolFormatPage, ExplainsEveryWord) {
  const auto schema = nlohmann::json::parse(tests::contentOf(
      std::string(PALPATE_SOURCE_DIR) + "/protocols/library/protocol-1.schema.json"));
  const std::string text = page();
  const auto parts = schema.flatten();  // outlives what items() looks at
  for (const auto& part : parts.items()) {
    const bool isWord = part.key().find("/enum/") != std::string::npos;
    if (!isWord) continue;
    const auto word = part.value().get<std::string>();
    EXPECT_NE(text.find("`" + word + "`"), std::string::npos) << word;
  }
}

}  // namespace
}  // namespace protocols
