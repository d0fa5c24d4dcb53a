// Layouts, dictionaries and traces of exports; blinded folders reveal no condition.
#include <zlib.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <locale>
#include <map>
#include <memory>
#include <set>
#include <sstream>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "analysis/data/csv_table.h"
#include "study/cohort/simulated_participant.h"
#include "study/export/export.h"
#include "study/storage/records.h"
#include "study/storage/trace_store.h"
#include "tests/study/everything_instrument.h"
#include "tests/study/made_study.h"
#include "tests/study/walk.h"
#include "tests/support/child_process.h"
#include "tests/support/long_form.h"
#include "tests/support/scratch_folder.h"
#include "tests/support/test_data.h"

namespace study {
namespace export_layout_test {

namespace fs = std::filesystem;

using tests::contentOf;

std::set<std::string> filesIn(const fs::path& folder) {
  std::set<std::string> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (entry.is_regular_file()) files.insert(fs::relative(entry.path(), folder).generic_string());
  }
  return files;
}

/// Whether a cell has the type in the dictionary.
bool isA(const std::string& type, const std::string& cell) {
  const auto number = base::decimalNumber(cell);
  if (type == "number") return number.has_value();
  if (type == "integer") return number && cell.find_first_of(".eE") == std::string::npos;
  if (type == "boolean") return cell == "true" || cell == "false";
  if (type == "date_time") return cell.size() >= 20 && cell[10] == 'T' && cell.back() == 'Z';
  return type == "text";
}

/// "data/study-punch_description-trials_data.csv": keys and values of letters and digits.
bool isPsychDsName(const std::string& file) {
  const std::string begin = "data/study-";
  const auto middle = file.find("_description-");
  const auto end = file.rfind("_data.");
  if (!file.starts_with(begin) || middle == std::string::npos || end == std::string::npos)
    return false;
  const auto isValue = [](std::string_view text) {
    return !text.empty() && std::all_of(text.begin(), text.end(), [](unsigned char c) {
      return c < 0x80 && std::isalnum(c) != 0;
    });
  };
  const std::string_view name(file);
  const std::size_t value = middle + std::string_view("_description-").size();
  return isValue(name.substr(begin.size(), middle - begin.size())) &&
         isValue(name.substr(value, end - value));
}

std::string unzipped(const fs::path& file) {
  gzFile stream = gzopen(file.c_str(), "rb");
  std::string text;
  std::array<char, 4096> part{};
  for (int count = gzread(stream, part.data(), part.size()); count > 0;
       count = gzread(stream, part.data(), part.size())) {
    text.append(part.data(), static_cast<std::size_t>(count));
  }
  gzclose(stream);
  return text;
}

/// Two simulated participants in the shipped study.
class ExportLayoutTest : public testing::Test {
 protected:
  void SetUp() override {
    simulateCohorts(*study_, study_.clock, 2, 3, [](const auto&) {});
  }

  /// Options for a complete, unblinded export.
  static ExportOptions open(ExportFormat format) {
    return {
        .format = format, .isBlinded = false, .hasTraces = true, .isExact = true, .hasTexts = true};
  }

  fs::path exported(const std::string& name, ExportOptions options, const std::string& why = {}) {
    const fs::path folder = folder_ / name;
    options.runMode = RunMode::Simulated;
    exportStudy(exportedStudy(), folder.string(), options, why);
    return folder;
  }
  virtual Study& exportedStudy() { return *study_; }

  tests::ScratchFolder folder_;
  tests::MadeStudy study_{tests::libraryProtocol("punch-face-validity.json"), 1};
};

TEST_F(ExportLayoutTest, LeavesNoFolderWhenItIsCancelled) {
  for (const auto format : {ExportFormat::Csv, ExportFormat::PsychDs, ExportFormat::Bids}) {
    auto options = open(format);
    double last = 0.0;
    options.progress = [&](double share, const std::string&) {
      last = share;
      if (share > 0.5) throw Cancelled();
    };
    EXPECT_THROW(exported("out", options, "for a test"), Cancelled);
    EXPECT_LT(last, 1.0);  // in the middle of the traces
    EXPECT_TRUE(fs::is_empty(folder_.path()));
  }
}

TEST_F(ExportLayoutTest, HasADictionaryForEveryColumnOfEveryTable) {
  const auto folder = exported("out", open(ExportFormat::Csv), "for a test");
  const auto codebook = nlohmann::json::parse(contentOf(folder / "codebook.json"));
  int checked = 0;
  for (const auto& [name, table] : codebook["tables"].items()) {
    const auto csv = analysis::readCsv(contentOf(folder / (name + ".csv")));
    ASSERT_EQ(csv.columns.size(), table["columns"].size()) << name;
    for (std::size_t i = 0; i < csv.columns.size(); ++i) {
      const auto& column = table["columns"][i];
      EXPECT_EQ(csv.columns[i], column["name"]);
      EXPECT_FALSE(column["description"].get<std::string>().empty()) << csv.columns[i];
      std::set<std::string> levels;
      if (column.contains("levels")) {
        for (const auto& level : column["levels"]) levels.insert(level["value"]);
      }
      const std::string type = column["type"];
      bool isAllNumbers = true;
      for (const auto& row : csv.rows) {
        if (row.cells[i].empty()) continue;
        isAllNumbers = isAllNumbers && isA("number", row.cells[i]);
        EXPECT_TRUE(isA(type, row.cells[i])) << csv.columns[i] << " " << row.cells[i];
        EXPECT_TRUE(levels.empty() || levels.count(row.cells[i]) == 1) << row.cells[i];
        ++checked;
      }
      const bool isEmpty = std::all_of(
          csv.rows.begin(), csv.rows.end(), [&](const auto& row) { return row.cells[i].empty(); });
      // The version of an instrument is text, also if it is "1".
      const bool mayLookLikeNumbers = csv.columns[i] == "instrument_version";
      EXPECT_FALSE(type == "text" && isAllNumbers && !isEmpty && !mayLookLikeNumbers)
          << name << " " << csv.columns[i];
    }
  }
  EXPECT_GT(checked, 2000);
}

/// The unit that the name of a column of numbers ends with; empty where it ends with none.
std::string unitInNameOf(const std::string& column) {
  for (const auto& [ending, unit] :
       std::map<std::string, std::string>{{"_s", "s"}, {"_hz", "Hz"}, {"_us", "µs"}, {"_n", "N"}}) {
    if (column.ends_with(ending)) return unit;
  }
  return {};
}

TEST_F(ExportLayoutTest, StatesInEveryDictionaryTheUnitThatANameEndsWith) {
  const auto plain = exported("plain", open(ExportFormat::R), "for a test");
  const auto codebook = nlohmann::json::parse(contentOf(plain / "codebook.json"));
  int units = 0;
  for (const auto& [name, table] : codebook["tables"].items()) {
    for (const auto& column : table["columns"]) {
      const auto unit = column.value("unit", "");
      EXPECT_EQ(unit, column["type"] == "number" ? unitInNameOf(column["name"]) : "") << column;
      units += unit.empty() ? 0 : 1;
    }
  }
  EXPECT_GT(units, 15);
  const auto columns = analysis::readCsv(contentOf(plain / "columns.csv"));
  for (const auto& row : columns.rows) {
    const auto cell = [&](const char* column) { return row.cells[columns.columnIndex(column)]; };
    EXPECT_EQ(cell("unit_symbol"), cell("type") == "number" ? unitInNameOf(cell("column")) : "")
        << cell("column");
  }
  const auto psychDs = exported("psych-ds", open(ExportFormat::PsychDs), "for a test");
  const auto all = nlohmann::json::parse(contentOf(psychDs / "dataset_description.json"));
  for (const auto& variable : all["variableMeasured"]) {
    EXPECT_EQ(
        variable.value("unitText", ""),
        variable["valueType"] == "number" ? unitInNameOf(variable["name"]) : "")
        << variable;
  }
}

TEST_F(ExportLayoutTest, GivesEveryNameOneMeaning) {
  const auto folder = exported("out", open(ExportFormat::Csv), "for a test");
  const auto codebook = nlohmann::json::parse(contentOf(folder / "codebook.json"));
  std::map<std::string, std::string> meanings;
  for (const auto& [name, table] : codebook["tables"].items()) {
    for (const auto& column : table["columns"]) {
      const std::string meaning =
          column["type"].get<std::string>() + ": " + column["description"].get<std::string>();
      const auto known = meanings.emplace(column["name"], meaning).first;
      EXPECT_EQ(known->second, meaning) << name << " " << column["name"];
    }
  }
  EXPECT_GT(meanings.size(), 90U);
}

TEST_F(ExportLayoutTest, ListsTheItemsInEveryLanguage) {
  const auto folder = exported("out", {.format = ExportFormat::Csv});
  const auto items = analysis::readCsv(contentOf(folder / "items.csv"));
  std::set<std::string> known;
  for (const auto& row : items.rows) {
    known.insert(
        row.cells[items.columnIndex("instrument")] + " " + row.cells[items.columnIndex("item_id")]);
  }
  const auto responses = analysis::readCsv(contentOf(folder / "responses.csv"));
  for (const auto& row : responses.rows) {
    EXPECT_EQ(
        known.count(
            row.cells[responses.columnIndex("instrument")] + " " +
            row.cells[responses.columnIndex("item_id")]),
        1U);
  }
}

TEST_F(ExportLayoutTest, FollowsThePsychDsLayout) {
  const auto folder = exported("out", open(ExportFormat::PsychDs), "for a test");
  const auto description = nlohmann::json::parse(contentOf(folder / "dataset_description.json"));
  EXPECT_EQ(description["@context"], "https://schema.org/");
  EXPECT_EQ(description["@type"], "Dataset");
  EXPECT_FALSE(description["name"].get<std::string>().empty());
  EXPECT_FALSE(description["description"].get<std::string>().empty());
  std::set<std::string> variables;
  for (const auto& variable : description["variableMeasured"]) variables.insert(variable["name"]);

  int tables = 0;
  for (const auto& file : filesIn(folder)) {
    if (file.rfind("data/", 0) != 0 || file.rfind("data/raw/", 0) == 0) continue;
    EXPECT_TRUE(isPsychDsName(file)) << file;
    if (!file.ends_with(".csv")) continue;
    ++tables;
    EXPECT_TRUE(fs::exists((folder / file).replace_extension(".json")));
    const auto csv = analysis::readCsv(contentOf(folder / file));
    for (const auto& column : csv.columns) EXPECT_EQ(variables.count(column), 1U) << column;
    for (const auto& row : csv.rows) EXPECT_EQ(row.cells.size(), csv.columns.size());
  }
  EXPECT_EQ(tables, 9);
  EXPECT_TRUE(fs::exists(folder / "README.md"));
  EXPECT_TRUE(fs::exists(folder / "CHANGES.md"));
  EXPECT_TRUE(fs::exists(folder / "materials/study-protocol.json"));
}

TEST_F(ExportLayoutTest, HoldsEverySampleOfEveryTrace) {
  const auto folder = exported("out", open(ExportFormat::Csv), "for a test");
  std::size_t traces = 0;
  for (const auto& trial : storage::Records(study_->database()).trials()) {
    if (trial.traceSamples == 0) continue;
    ++traces;
  }
  const auto files = filesIn(folder / "traces");
  EXPECT_EQ(files.size(), traces);
  ASSERT_FALSE(files.empty());
  const auto csv = analysis::readCsv(unzipped(folder / "traces" / *files.begin()));
  const auto visit = study_->traces().visits().front();
  const auto samples = study_->traces().read(visit);
  ASSERT_EQ(csv.rows.size(), samples.size());
  const auto force = csv.columnIndex("force_n");
  for (std::size_t i = 0; i < samples.size(); ++i) {
    EXPECT_EQ(std::stof(csv.rows[i].cells[force]), samples[i].force);
  }
}

TEST_F(ExportLayoutTest, GivesTheSameBytesTwice) {
  const auto first = exported("first", open(ExportFormat::PsychDs), "for a test");
  const auto second = exported("second", open(ExportFormat::PsychDs), "for a test");
  ASSERT_EQ(filesIn(first), filesIn(second));
  for (const auto& file : filesIn(first))
    EXPECT_EQ(contentOf(first / file), contentOf(second / file));
}

/// Sets the locale as the desktop does that starts the program.
class OtherLocale {
 public:
  explicit OtherLocale(const std::string& name) : before_(std::locale()) {
    std::locale::global(std::locale(name));
  }
  ~OtherLocale() { std::locale::global(before_); }
  OtherLocale(const OtherLocale&) = delete;
  OtherLocale& operator=(const OtherLocale&) = delete;

 private:
  std::locale before_;
};

/// Compiles the locales of this test into its own folder, since few systems have all of them
/// installed.
bool areMade(const fs::path& folder, const std::vector<std::string>& names) {
  for (const auto& name : names) {
    try {
      const std::string made = (folder / (name + ".UTF-8")).string();
      const auto call = {
          std::string("localedef"),
          std::string("-i"),
          name,
          std::string("-f"),
          std::string("UTF-8"),
          made};
      if (tests::run(call).status != 0) return false;
    } catch (const std::exception&) {
      return false;
    }
  }
  return setenv("LOCPATH", folder.c_str(), 1) == 0;  // NOLINT(concurrency-mt-unsafe): one thread
}

TEST_F(ExportLayoutTest, GivesTheSameBytesInEveryLocale) {
  const std::vector<std::string> names{"de_DE", "tr_TR", "ar_EG"};
  if (!areMade(folder_.path(), names)) GTEST_SKIP() << "needs Debian's locales: ./setup --check";
  const std::array formats{
      ExportFormat::Csv,
      ExportFormat::Json,
      ExportFormat::PsychDs,
      ExportFormat::Bids,
      ExportFormat::R,
      ExportFormat::Python};
  for (const auto format : formats) {
    const auto number = std::to_string(static_cast<int>(format));
    const auto here = exported("here" + number, open(format), "for a test");
    for (std::size_t i = 0; i < names.size(); ++i) {
      // The short form: tables in every locale, each other format in one.
      const bool isOthers = static_cast<std::size_t>(format) % names.size() != i;
      if (isOthers && format != ExportFormat::Csv && !tests::isLong()) continue;
      const auto& name = names[i];
      const OtherLocale other(name + ".UTF-8");
      const auto there = exported(name + number, open(format), "for a test");
      ASSERT_EQ(filesIn(here), filesIn(there)) << name;
      for (const auto& file : filesIn(here)) {
        EXPECT_EQ(contentOf(here / file), contentOf(there / file)) << name << " " << file;
      }
    }
  }
}

TEST_F(ExportLayoutTest, RevealsConditionsOnlyIfUnblinded) {
  const auto blinded = exported("blinded", {.format = ExportFormat::PsychDs});
  for (const auto& file : filesIn(blinded)) {
    const auto text = file.ends_with(".gz") ? unzipped(blinded / file) : contentOf(blinded / file);
    for (const auto& condition : study_->protocol().protocol.conditions) {
      EXPECT_EQ(text.find(condition.id), std::string::npos) << file << ": " << condition.id;
      EXPECT_EQ(text.find(condition.title), std::string::npos) << file << ": " << condition.title;
      EXPECT_EQ(file.find(condition.id), std::string::npos);
    }
  }
  const auto unblinded = exported("open", open(ExportFormat::PsychDs), "for a test");
  EXPECT_TRUE(fs::exists(unblinded / "materials/study-protocol.json"));
  EXPECT_THROW(
      exported("traces", {.format = ExportFormat::Csv, .hasTraces = true}), storage::StorageError);
}

/// "sub-SIM001/ses-1/beh/sub-SIM001_ses-1_task-punchfacevalidity_acq-trials_beh.tsv" begins with
/// the names of its folders and ends with a suffix that BIDS allows in beh/.
bool isBidsName(const fs::path& file) {
  std::vector<std::string> parts;
  for (const auto& part : file) parts.push_back(part.string());
  if (parts.size() == 2) return parts[1] == parts[0] + "_sessions.tsv";
  const auto& name = parts.back();
  return parts.size() == 4 && parts[0].starts_with("sub-") && parts[1].starts_with("ses-") &&
         parts[2] == "beh" && name.starts_with(parts[0] + "_" + parts[1] + "_task-") &&
         (name.ends_with("_beh.tsv") || name.ends_with("_events.tsv"));
}

std::vector<std::vector<std::string>> linesOf(const fs::path& tsv) {
  std::vector<std::vector<std::string>> lines;
  std::istringstream stream(contentOf(tsv));
  for (std::string line; std::getline(stream, line);) {
    auto& cells = lines.emplace_back();
    std::istringstream parts(line);
    for (std::string cell; std::getline(parts, cell, '\t');) cells.push_back(cell);
  }
  return lines;
}

TEST_F(ExportLayoutTest, FollowsTheBidsLayout) {
  const auto folder = exported("out", open(ExportFormat::Bids), "for a test");
  const auto description = nlohmann::json::parse(contentOf(folder / "dataset_description.json"));
  EXPECT_EQ(description["BIDSVersion"], "1.8.0");
  EXPECT_EQ(description["DatasetType"], "raw");
  EXPECT_FALSE(description["Name"].get<std::string>().empty());
  EXPECT_TRUE(fs::exists(folder / "README.md"));
  const auto people = linesOf(folder / "participants.tsv");
  EXPECT_EQ(people.size(), 3U);
  EXPECT_EQ(people[0][0], "participant_id");
  for (std::size_t i = 1; i < people.size(); ++i) EXPECT_TRUE(fs::exists(folder / people[i][0]));

  std::size_t answers = 0;
  for (const auto& file : filesIn(folder)) {
    if (!file.ends_with(".tsv") || file.starts_with("sourcedata/")) continue;
    EXPECT_TRUE(file == "participants.tsv" || isBidsName(file)) << file;
    const auto lines = linesOf(folder / file);
    const auto sidecar =
        nlohmann::json::parse(contentOf((folder / file).replace_extension(".json")));
    for (const auto& column : lines[0]) EXPECT_TRUE(sidecar.contains(column)) << file << column;
    for (const auto& line : lines) {
      EXPECT_EQ(line.size(), lines[0].size()) << file;
      for (const auto& cell : line) EXPECT_FALSE(cell.empty()) << file;
    }
    EXPECT_EQ(sidecar.contains("TaskName"), file.ends_with("_beh.tsv")) << file;
    if (file.ends_with("_events.tsv")) {
      EXPECT_EQ(lines[0][0], "onset");
      EXPECT_EQ(lines[0][1], "duration");
    }
    if (file.ends_with("responses_beh.tsv") || file.ends_with("texts_beh.tsv")) {
      answers += lines.size() - 1;
    }
  }
  EXPECT_EQ(answers, storage::Records(study_->database()).answers().size());
}

TEST(BidsExport, HasNoFreeTextThatASpreadsheetTakesForAFormula) {
  tests::MadeStudy study(tests::protocolFrom(
      tests::protocolWithEverything(), {{"everything.json", tests::everythingInstrument()}}));
  auto session = Session::enrol(*study, {.cohort = "surgeons"});
  tests::walkTo(session, StepKind::Form);
  const std::string words = "=HYPERLINK(\"http://x\")";
  session.record({.item = "line", .response = words, .itemOrder = 1, .language = "en"});
  const fs::path folder = study.scratch() / "bids";
  exportStudy(
      *study,
      folder.string(),
      {.format = ExportFormat::Bids, .runMode = RunMode::Live, .hasTexts = true});
  std::size_t found = 0;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (entry.path().extension() != ".tsv") continue;
    const auto text = tests::contentOf(entry.path());
    EXPECT_EQ(text.find("\t" + words), std::string::npos) << entry.path();
    if (text.find("\t'" + words + "\t") != std::string::npos) ++found;
  }
  EXPECT_EQ(found, 1U);
}

TEST_F(ExportLayoutTest, HasNoPublicBidsFolder) {
  EXPECT_THROW(
      exported("out", {.format = ExportFormat::Bids, .publicClassSize = kSmallestPublicClassSize}),
      storage::StorageError);
}

/// Runs a script of the export with @p program. @return  its output.
std::string expectToComputeAgain(
    const std::vector<std::string>& program, const fs::path& script, const fs::path& folder) {
  auto call = program;
  call.insert(call.end(), {script.string(), folder.string()});
  const auto finished = tests::run(call);
  EXPECT_EQ(finished.status, 0) << finished.out << finished.error;
  EXPECT_NE(finished.out.find("welch p "), std::string::npos) << finished.out;
  EXPECT_NE(finished.out.find("signed_rank p_adj"), std::string::npos);
  EXPECT_NE(finished.out.find("mann_whitney effect"), std::string::npos);
  EXPECT_NE(finished.out.find("votes p_exact"), std::string::npos);
  EXPECT_NE(finished.out.find("tost p "), std::string::npos);
  EXPECT_NE(finished.out.find("bayes_factor effect"), std::string::npos);
  EXPECT_NE(finished.out.find("rm_anova p_epsilon"), std::string::npos);
  EXPECT_NE(finished.out.find("signed_rank estimate"), std::string::npos);
  EXPECT_NE(finished.out.find("votes share_high_exact"), std::string::npos);
  return finished.out;
}

/// Checks the output of the script that reads @p folder; skips the test if @p program is not
/// installed.
void expectToRead(
    const std::vector<std::string>& program, const fs::path& script, const fs::path& folder) {
  auto call = program;
  call.insert(call.end(), {script.string(), folder.string()});
  const auto finished = tests::run(call);
  EXPECT_EQ(finished.status, 0) << finished.out << finished.error;
  const auto rows = analysis::readCsv(contentOf(folder / "responses.csv")).rows.size();
  EXPECT_NE(finished.out.find("responses : " + std::to_string(rows) + " rows"), std::string::npos)
      << finished.out;
  EXPECT_NE(finished.out.find("punch-face-validity.C3: n = "), std::string::npos) << finished.out;
}

TEST_F(ExportLayoutTest, IsReadByItsScriptInR) {
  if (!tests::isInstalled({"Rscript", "-e", "0"})) GTEST_SKIP() << "needs R: ./setup --check";
  const auto blinded = exported("blinded", {.format = ExportFormat::R});
  EXPECT_FALSE(fs::exists(blinded / "analysis.R"));
  EXPECT_FALSE(fs::exists(blinded / "read_tables.py"));
  expectToRead({"Rscript"}, blinded / "read_tables.R", blinded);
  const auto unblinded =
      exported("open", {.format = ExportFormat::R, .isBlinded = false}, "for a test");
  EXPECT_TRUE(fs::exists(unblinded / "analysis.R"));
  expectToRead({"Rscript"}, unblinded / "read_tables.R", unblinded);
}

TEST_F(ExportLayoutTest, IsReadByItsScriptInPython) {
  const std::string python = "/usr/bin/python3";
  if (!tests::isInstalled({python, "-c", "0"})) GTEST_SKIP() << "needs Python: ./setup --check";
  const auto blinded = exported("blinded", {.format = ExportFormat::Python});
  EXPECT_FALSE(fs::exists(blinded / "read_tables.R"));
  expectToRead({python}, blinded / "read_tables.py", blinded);
  const auto unblinded =
      exported("open", {.format = ExportFormat::Python, .isBlinded = false}, "for a test");
  EXPECT_TRUE(fs::exists(unblinded / "analysis.py"));
  expectToRead({python}, unblinded / "read_tables.py", unblinded);
}

/// Eleven participants, as in the published study, and an equivalence bound.
class ComputedAgainTest : public ExportLayoutTest {
 protected:
  static void SetUpTestSuite() {
    auto json = tests::libraryProtocol("punch-face-validity.json").text;
    const std::string alpha = R"("alpha": 0.05)";
    json.insert(json.find(alpha), R"("equivalence_bound": 0.5, )");
    made = std::make_unique<tests::MadeStudy>(tests::protocolFrom(json));
    simulateCohorts(**made, made->clock, 11, 3, [](const auto&) {});
  }
  static void TearDownTestSuite() { made.reset(); }
  void SetUp() override {}

  Study& exportedStudy() override { return **made; }

  inline static std::unique_ptr<tests::MadeStudy> made;
};

TEST_F(ComputedAgainTest, InR) {
  if (!tests::isInstalled({"Rscript", "-e", "0"})) GTEST_SKIP() << "needs R: ./setup --check";
  const auto folder = exported("out", open(ExportFormat::Csv), "for a test");
  const auto said = expectToComputeAgain({"Rscript"}, folder / "analysis.R", folder);
  const bool hasModels =
      tests::isInstalled({"Rscript", "-e", "library(lmerTest); library(ordinal)"});
  for (const auto* number : {"mixed_model df", "mixed_model p_adj", "ordinal_model effect"}) {
    EXPECT_EQ(said.find(number) != std::string::npos, hasModels) << number;
  }
  EXPECT_EQ(said.find("apt install r-cran-lmertest") == std::string::npos, hasModels) << said;
}

TEST_F(ComputedAgainTest, InRDetectsAnOrdinalEstimateThatIsAHundredthOff) {
  if (!tests::isInstalled({"Rscript", "-e", "library(lmerTest); library(ordinal)"})) {
    GTEST_SKIP() << "needs R with ordinal: ./setup --check";
  }
  const auto folder = exported("out", open(ExportFormat::Csv), "for a test");
  const auto table = (folder / "statistics.csv").string();
  const std::string change =
      "f <- '" + table +
      "'; s <- read.csv(f, na.strings = ''); i <- s$method == 'ordinal_model'; "
      "s$estimate[i] <- 1.01 * s$estimate[i]; write.csv(s, f, row.names = FALSE, na = '')";
  ASSERT_EQ(tests::run({"Rscript", "-e", change}).status, 0);
  const auto finished = tests::run({"Rscript", (folder / "analysis.R").string(), folder.string()});
  EXPECT_EQ(finished.status, 1) << finished.out << finished.error;
  EXPECT_NE(finished.out.find("ordinal_model estimate"), std::string::npos) << finished.error;
}

TEST_F(ComputedAgainTest, InPython) {
  const std::string python = "/usr/bin/python3";  // Debian's Python, with Debian's SciPy
  if (!tests::isInstalled({python, "-c", "import scipy"}))
    GTEST_SKIP() << "needs SciPy: ./setup --check";
  const auto folder = exported("out", open(ExportFormat::PsychDs), "for a test");
  expectToComputeAgain({python}, folder / "analysis" / "analysis.py", folder);
}

TEST_F(ComputedAgainTest, ReportsHowToInstallSciPyIfItIsMissing) {
  const std::string python = "/usr/bin/python3";
  if (!tests::isInstalled({python, "-c", "0"})) GTEST_SKIP() << "needs Python: ./setup --check";
  const auto folder =
      exported("out", {.format = ExportFormat::Python, .isBlinded = false}, "for a test");
  EXPECT_NE(contentOf(folder / "README.md").find("NumPy and SciPy"), std::string::npos);
  EXPECT_NE(contentOf(folder / "README.md").find("apt install python3-scipy"), std::string::npos);
  EXPECT_EQ(contentOf(folder / "README.md").find("analysis.R"), std::string::npos);
  std::ofstream(folder_ / "scipy.py") << "raise ImportError('there is none here')\n";
  const auto script = (folder / "analysis.py").string();
  const auto finished =
      tests::run({"env", "PYTHONPATH=" + folder_.path().string(), python, script, folder.string()});
  EXPECT_EQ(finished.status, 2) << finished.out << finished.error;
  EXPECT_NE(finished.error.find("needs NumPy and SciPy"), std::string::npos) << finished.error;
  EXPECT_NE(finished.error.find("apt install python3-scipy"), std::string::npos);
  EXPECT_EQ(finished.error.find("Traceback"), std::string::npos);
}

}  // namespace export_layout_test
}  // namespace study
