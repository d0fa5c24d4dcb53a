#include "study/storage/evidence/schema_check.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <string>
#include <utility>

#include "study/storage/statement.h"

namespace study::storage {
namespace {

/// The SQL text of each table, index and trigger, by type and name.
std::map<std::pair<std::string, std::string>, std::string> objectsOf(const Database& database) {
  Statement select(
      database, "SELECT type, name, tbl_name || ': ' || coalesce(sql, '') FROM sqlite_schema");
  std::map<std::pair<std::string, std::string>, std::string> objects;
  while (select.step()) objects[{select.text(0), select.text(1)}] = select.text(2);
  return objects;
}

std::size_t versionOf(const Database& database) {
  Statement version(database, "PRAGMA user_version");
  return version.step() ? static_cast<std::size_t>(version.number(0)) : 0;
}

}  // namespace

Findings checkSchema(const Database& database, const Schema& schema) {
  Schema ofItsFormat = schema;
  ofItsFormat.steps = schema.steps.first(std::min(versionOf(database), schema.steps.size()));
  const auto wanted = objectsOf(Database::inMemory(ofItsFormat));
  const auto found = objectsOf(database);
  const auto file = std::filesystem::path(database.path()).filename().string();
  Findings findings;
  const auto add = [&](const auto& object, const char* what) {
    findings.problems.push_back(
        file + ": the " + object.first.first + " " + object.first.second + " " + what);
  };
  for (const auto& object : wanted) {
    const auto here = found.find(object.first);
    if (here == found.end()) {
      add(object, "is gone");
    } else if (here->second != object.second) {
      add(object, "was changed");
    }
  }
  for (const auto& object : found) {
    if (wanted.count(object.first) == 0) add(object, "was added");
  }
  return findings;
}

}  // namespace study::storage
