// What the README of an exported folder says about its files.
#include <algorithm>
#include <filesystem>
#include <map>
#include <memory>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <tuple>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "study/cohort/simulated_participant.h"
#include "study/export/export.h"
#include "tests/study/made_study.h"
#include "tests/support/scratch_folder.h"

namespace study {
namespace readme_test {

namespace fs = std::filesystem;

using Names = std::vector<std::string>;

const std::set<std::string> kKeys{
    "participant_id", "session_num", "session_id", "step_num", "attempt"};

enum class For { Blinded, Unblinded, Public };

/// A format, and who reads the folder.
using Asked = std::tuple<ExportFormat, For>;

/// The parts of @p text between @p separator.
Names split(const std::string& text, char separator) {
  Names parts;
  std::istringstream stream(text);
  for (std::string part; std::getline(stream, part, separator);) parts.push_back(part);
  return parts;
}

/// Everything in @p text that stands between backticks.
Names quotedIn(const std::string& text) {
  Names quoted;
  static const std::regex kQuoted("`([^`]*)`");
  for (std::sregex_iterator it(text.begin(), text.end(), kQuoted), end; it != end; ++it) {
    quoted.push_back((*it)[1]);
  }
  return quoted;
}

/// Whether @p file has the name @p written, in which "…" is any part of a name.
bool isNamed(const std::string& written, const std::string& file) {
  static const std::regex kSpecial(R"([.+()\[\]{}^$|\\])");
  auto pattern = std::regex_replace(written, kSpecial, R"(\$&)");
  pattern = std::regex_replace(pattern, std::regex("…"), "[^/]*");
  return std::regex_match(file, std::regex(pattern));
}

class ExportReadme : public testing::TestWithParam<Asked> {
 protected:
  /// Enough people for a public folder. They are simulated once, which takes longest.
  static void SetUpTestSuite() {
    made = std::make_unique<tests::MadeStudy>(tests::protocolFrom(tests::shortProtocol(
        {.conditions = {"interpolation", "finite-elements"}, .form = "background-knee"})));
    simulateCohorts(**made, made->clock, 6, 3, [](const auto&) {});
  }
  static void TearDownTestSuite() { made.reset(); }

  ExportReadme() {
    ExportOptions options{
        .format = format(),
        .runMode = RunMode::Simulated,
        .isBlinded = reader() != For::Unblinded,
        .hasTexts = reader() != For::Public};
    if (reader() == For::Public) options.publicClassSize = kSmallestPublicClassSize;
    exportStudy(**made, folder_.string(), options, "for a test");
    readme_ = tests::contentOf(folder_ / "README.md");
    for (const auto& entry : fs::recursive_directory_iterator(folder_)) {
      if (entry.is_regular_file()) files_.insert(fs::relative(entry.path(), folder_).string());
    }
  }

  static ExportFormat format() { return std::get<ExportFormat>(GetParam()); }
  static For reader() { return std::get<For>(GetParam()); }

  /// The columns of a table, by what the README calls it.
  std::set<std::string> columnsOf(const std::string& table) const {
    if (format() == ExportFormat::Json) {
      const auto json = nlohmann::json::parse(tests::contentOf(folder_ / "study.json"));
      std::set<std::string> columns;
      for (const auto& row : json.at(table)) {
        for (const auto& [name, value] : row.items()) columns.insert(name);
      }
      return columns;
    }
    for (const auto& file : files_) {
      if (!isNamed(table, file)) continue;
      const auto text = tests::contentOf(folder_ / file);
      const auto names =
          split(text.substr(0, text.find('\n')), file.ends_with(".tsv") ? '\t' : ',');
      return {names.begin(), names.end()};
    }
    ADD_FAILURE() << "there is no " << table;
    return {};
  }

  /// The rows of the README's table of tables: their keys by their names.
  std::map<std::string, std::set<std::string>> listed() const {
    std::map<std::string, std::set<std::string>> rows;
    for (const auto& line : split(readme_, '\n')) {
      if (!line.starts_with("| `")) continue;
      const auto cells = split(line, '|');
      const auto keys = quotedIn(cells.at(2));
      rows[quotedIn(cells.at(1)).at(0)] = {keys.begin(), keys.end()};
    }
    return rows;
  }

  std::set<std::string> tablesInTheFolder() const {
    std::set<std::string> tables;
    if (format() == ExportFormat::Json) {
      const auto json = nlohmann::json::parse(tests::contentOf(folder_ / "study.json"));
      for (const auto& [name, value] : json.items()) {
        if (value.is_array() && name != "felt_from") tables.insert(name);
      }
    }
    for (const auto& file : files_) {
      if (file.ends_with(".csv") || file.ends_with(".tsv")) tables.insert(file);
    }
    return tables;
  }

  inline static std::unique_ptr<tests::MadeStudy> made;
  tests::ScratchFolder scratch_;
  fs::path folder_ = scratch_ / "out";
  std::string readme_;
  std::set<std::string> files_;
};

TEST_P(ExportReadme, NamesOnlyFilesThatAreInTheFolder) {
  static const std::regex kFile(R"([^ ]*\.(csv|tsv|json|R|py|md))");
  for (const auto& quoted : quotedIn(readme_)) {
    if (!std::regex_match(quoted, kFile)) continue;
    const bool isThere = std::any_of(
        files_.begin(), files_.end(), [&](const auto& file) { return isNamed(quoted, file); });
    EXPECT_TRUE(isThere) << quoted;
  }
}

TEST_P(ExportReadme, NamesEveryTableAndScriptOfTheFolder) {
  const auto tables = listed();
  for (const auto& table : tablesInTheFolder()) {
    EXPECT_TRUE(std::any_of(tables.begin(), tables.end(), [&](const auto& row) {
      return isNamed(row.first, table);
    })) << table;
  }
  for (const auto& file : files_) {
    if (!file.ends_with(".R") && !file.ends_with(".py")) continue;
    EXPECT_NE(readme_.find("`" + file + "`"), std::string::npos) << file;
  }
}

TEST_P(ExportReadme, GivesEachTableTheKeysThatItHas) {
  const auto tables = listed();
  EXPECT_FALSE(tables.empty());
  for (const auto& [table, keys] : tables) {
    const auto columns = columnsOf(table);
    // A table without rows has no columns in JSON.
    if (columns.empty() && format() == ExportFormat::Json) continue;
    std::set<std::string> expected;
    for (const auto& column : columns) {
      if (kKeys.contains(column)) expected.insert(column);
    }
    EXPECT_EQ(keys, expected) << table;
  }
}

TEST_P(ExportReadme, SaysHowAMissingValueIsWritten) {
  EXPECT_EQ(readme_.find("`n/a`") != std::string::npos, format() == ExportFormat::Bids);
  EXPECT_EQ(readme_.find("`null`") != std::string::npos, format() == ExportFormat::Json);
  const bool hasEmptyCells = format() != ExportFormat::Bids && format() != ExportFormat::Json;
  EXPECT_EQ(readme_.find("an empty cell") != std::string::npos, hasEmptyCells);
}

TEST_P(ExportReadme, SaysWhereTheTestsAreIfTheFormatHasNone) {
  const auto tables = listed();
  const bool hasTests = std::any_of(tables.begin(), tables.end(), [](const auto& row) {
    return row.first.find("statistics") != std::string::npos;
  });
  const bool lacksTests = reader() == For::Unblinded && !hasTests;
  EXPECT_EQ(readme_.find("Not in this format: tests, votes") != std::string::npos, lacksTests);
}

INSTANTIATE_TEST_SUITE_P(
    OfTables,
    ExportReadme,
    testing::Combine(
        testing::Values(
            ExportFormat::Csv,
            ExportFormat::Json,
            ExportFormat::PsychDs,
            ExportFormat::R,
            ExportFormat::Python),
        testing::Values(For::Blinded, For::Unblinded, For::Public)));
// BIDS has no public folders.
INSTANTIATE_TEST_SUITE_P(
    OfBids,
    ExportReadme,
    testing::Combine(
        testing::Values(ExportFormat::Bids), testing::Values(For::Blinded, For::Unblinded)));

}  // namespace readme_test
}  // namespace study
