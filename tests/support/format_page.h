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

/// The values of @p key that the definition @p name of a schema lists, and those that one of its
/// rules ("if") is about.
struct SchemaValues {
  std::set<std::string> listed;
  std::set<std::string> withRule;
};

inline SchemaValues valuesInSchema(
    const std::string& file, std::string_view name, std::string_view key) {
  questionnaires::Problems problems;
  SchemaValues values;
  const auto schema = questionnaires::parseJson(questionnaires::readTextFile(file), problems);
  const auto put = [](const questionnaires::Node& property, std::set<std::string>& into) {
    if (property.has("const")) into.insert(property.text("const"));
    for (const auto& each : property.texts("enum")) into.insert(each);
  };
  const auto propertyOf = [&](const questionnaires::Node& owner) {
    return owner.object("properties").value().object(key).value();
  };
  const questionnaires::Node root(schema.value(), "$", problems);
  const auto definition = root.object("$defs").value().object(name).value();
  put(propertyOf(definition), values.listed);
  for (const auto& rule : definition.list("allOf")) {
    if (const auto condition = rule.object("if")) put(propertyOf(*condition), values.withRule);
  }
  return values;
}

}  // namespace tests
