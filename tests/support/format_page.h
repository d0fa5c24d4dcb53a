#pragma once

#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "questionnaires/json/document.h"

namespace tests {

/// The examples of a manual page that begin with "```json" and @p kind.
inline std::vector<std::string> jsonExamples(const std::string& page, const std::string& kind) {
  const std::string begin = "```json" + kind + "\n";
  std::vector<std::string> found;
  for (auto at = page.find(begin); at != std::string::npos; at = page.find(begin, at + 1)) {
    const auto start = at + begin.size();
    found.push_back(page.substr(start, page.find("```", start) - start));
  }
  return found;
}

/// Adds every name under a "properties" of a schema.
inline void collectKeys(const questionnaires::Node& schema, std::set<std::string>& keys) {
  for (const auto& [name, part] : schema.members()) {
    if (name == "properties") {
      for (const auto& member : part.members()) keys.insert(member.first);
    }
    collectKeys(part, keys);
  }
}

/// Adds a failure for every key of the schema in @p file that @p page does not name.
inline void expectEveryKey(
    const std::string& page, const std::string& file, std::size_t leastKeys) {
  questionnaires::Problems problems;
  const auto schema = questionnaires::parseJson(questionnaires::readTextFile(file), problems);
  ASSERT_TRUE(schema.has_value());
  std::set<std::string> keys;
  collectKeys(questionnaires::Node(*schema, "$", problems), keys);
  EXPECT_GE(keys.size(), leastKeys);
  for (const auto& key : keys) EXPECT_NE(page.find("`" + key + "`"), std::string::npos) << key;
}

}  // namespace tests
