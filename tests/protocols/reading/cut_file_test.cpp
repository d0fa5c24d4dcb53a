#include "protocols/reading/cut_file.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "haptics/recordings/cut.h"
#include "haptics/recordings/cut_import.h"
#include "haptics/recordings/recording.h"
#include "tests/haptics/recordings/made_recording.h"
#include "tests/protocols/small_protocol.h"

namespace protocols {
namespace cut_file_test {

using nlohmann::json;

json soundCut() {
  return json::parse(cutAsJson(haptics::recordings::parametricCut(), std::string(64, 'a')));
}

/// All that is said about a cut file, in words; empty where it can be read.
std::string refusalOf(const std::string& text) {
  questionnaires::Problems problems;
  const auto cut = readCut(text, problems);
  EXPECT_EQ(cut.has_value(), !problems.hasErrors());
  return cut ? std::string() : questionnaires::describe(problems.all());
}

void expectRefused(const json& cut, const std::string& place, const std::string& what) {
  const auto words = refusalOf(cut.dump());
  EXPECT_NE(words.find(place), std::string::npos) << words;
  EXPECT_NE(words.find(what), std::string::npos) << words;
}

TEST(CutFile, ReadsBackWhatWasWrittenToTheLastBit) {
  const auto written = haptics::recordings::parametricCut();
  questionnaires::Problems problems;
  const auto read = readCut(cutAsJson(written, ""), problems);
  ASSERT_TRUE(read) << questionnaires::describe(problems.all());
  EXPECT_EQ(read->name, written.name);
  EXPECT_EQ(read->title, written.title);
  EXPECT_EQ(read->isSynthetic, written.isSynthetic);
  EXPECT_EQ(read->provenance.statement, written.provenance.statement);
  ASSERT_EQ(read->curve.nodes().size(), written.curve.nodes().size());
  for (std::size_t i = 0; i < written.curve.nodes().size(); ++i) {
    EXPECT_EQ(read->curve.nodes()[i].travel, written.curve.nodes()[i].travel);
    EXPECT_EQ(read->curve.nodes()[i].force, written.curve.nodes()[i].force);
  }
  EXPECT_EQ(cutAsJson(*read, ""), cutAsJson(written, ""));
}

/// The cut in a file; fails the test where it cannot be read.
haptics::recordings::Cut read(const std::string& text) {
  questionnaires::Problems problems;
  const auto cut = readCut(text, problems);
  EXPECT_TRUE(cut.has_value()) << questionnaires::describe(problems.all());
  return cut.value_or(haptics::recordings::parametricCut());
}

TEST(CutFile, ReadsBackWhatWasImportedFromARecording) {
  using namespace haptics::recordings;
  const auto recording = readRecording(tests::textOf({}), "made.txt");
  const std::vector<ImportOptions> imports{
      {},
      {.closures = {1, 3}, .maxSlope = 1.0},
      {.rows = RowRange{150, 250}, .filter = TravelFilter{TravelFilter::Kind::None}},
      {.closures = {2}, .calibration = recorder2021Calibration()}};
  for (const auto& options : imports) {
    const auto written = importCut(recording, options).cut;
    const auto cut = read(cutAsJson(written, std::string(64, '0')));
    EXPECT_EQ(cut.curve, written.curve);
    EXPECT_EQ(cut.provenance.rows, written.provenance.rows);
    EXPECT_EQ(cut.provenance.closures, written.provenance.closures);
    EXPECT_EQ(cut.provenance.slopeLimit, written.provenance.slopeLimit);
    EXPECT_EQ(cut.provenance.changes, written.provenance.changes);
    EXPECT_EQ(cut.landmarks.opening.has_value(), written.landmarks.opening.has_value());
    EXPECT_EQ(cutAsJson(cut, "ab"), cutAsJson(written, "ab"));  // and everything else
  }
}

TEST(CutFile, KeepsNumbersThatNoDecimalOfAFewDigitsIs) {
  auto cut = haptics::recordings::parametricCut();
  const double least = std::numeric_limits<double>::denorm_min();
  const std::vector<haptics::recordings::CurvePoint> points{
      {-0.1, -1.0 / 3.0}, {0.1, least}, {0.1 + 0x1p-55, 1e4}, {1e6, -1e4}};
  cut.curve = haptics::recordings::ForceCurve(points);
  cut.landmarks.yield = points[0];
  const auto again = read(cutAsJson(cut, ""));
  EXPECT_EQ(again.curve, cut.curve);
  EXPECT_EQ(again.landmarks.yield->force, -1.0 / 3.0);
}

TEST(CutFile, CanBeReadWithAnyNameOfItsRecording) {
  auto cut = haptics::recordings::parametricCut();
  cut.provenance.sourceFile = "M\xfcller \"1\"\n\\.txt";  // Latin-1, quotes, a new line
  const auto name = read(cutAsJson(cut, "")).provenance.sourceFile;
  EXPECT_EQ(name, "M\xef\xbf\xbdller \"1\"\n\\.txt");  // U+FFFD for what is no UTF-8
}

TEST(CutFile, NeedsNeitherLandmarksNorProvenance) {
  const auto cut = read(
      R"({"format": "palpate-cut-1", "name": "a", "title": "A", "unit": "travel_unit",
          "curve": [{"travel": 0, "force_n": 0}, {"travel": 1, "force_n": 2}]})");
  EXPECT_FALSE(cut.isSynthetic);
  EXPECT_FALSE(cut.landmarks.interception);
  EXPECT_TRUE(cut.provenance.statement.empty());
  EXPECT_FALSE(cut.provenance.slopeLimit);
  EXPECT_EQ(nodesOf(cut.curve).at(1).force, 2.0);
}

TEST(CutFile, RefusesWhatIsNoCurve) {
  auto cut = soundCut();
  cut["curve"][3]["travel"] = cut["curve"][2]["travel"];
  expectRefused(cut, "$.curve[3].travel", "does not rise");
  cut = soundCut();
  cut["curve"] = json::array({cut["curve"][0]});
  expectRefused(cut, "$.curve", "one point is no curve");
  cut["curve"] = json::array();
  expectRefused(cut, "$.curve", "this list is empty");
  cut.erase("curve");
  expectRefused(cut, "$", "'curve' is missing");
}

TEST(CutFile, RefusesNumbersThatAreNotFinite) {
  auto cut = soundCut();
  cut["curve"][1]["force_n"] = "4";
  expectRefused(cut, "$.curve[1].force_n", "a number is expected here");
  cut["curve"][1]["force_n"] = 1e300;
  expectRefused(cut, "$.curve[1].force_n", "out of range");
  for (const auto* notJson : {"NaN", "Infinity", "1e999"}) {
    auto text = soundCut().dump();
    const std::string key = "\"force_n\":";
    const auto at = text.find(key, text.find("\"curve\"")) + key.size();
    text.replace(at, text.find_first_of(",}", at) - at, notJson);
    EXPECT_NE(refusalOf(text), "") << notJson;
  }
}

TEST(CutFile, RefusesOtherFormatsUnknownKeysAndBadProvenance) {
  auto cut = soundCut();
  cut["format"] = "palpate-cut-2";
  expectRefused(cut, "$.format", "this is written for");
  cut = soundCut();
  cut["tilte"] = "x";
  expectRefused(cut, "$.tilte", "did you mean 'title'?");
  cut = soundCut();
  cut["provenance"]["source_sha256"] = "123";
  expectRefused(cut, "$.provenance.source_sha256", "no SHA-256");
  cut = soundCut();
  cut["provenance"]["rows"] = json::parse("[[5, 3]]");
  expectRefused(cut, "$.provenance.rows[0]", "a first and a last row");
}

TEST(CutFile, RefusesAnotherUnitThanThePunchs) {
  auto cut = soundCut();
  cut["unit"] = "mm";
  expectRefused(cut, "$.unit", "not in 'mm'; convert every travel");
}

TEST(CutFile, RefusesNumbersThatNoHandCouldFeel) {
  for (const double number : {1e308, -1e308, 1e6 + 1}) {
    auto cut = soundCut();
    cut["curve"].back()["travel"] = number;
    expectRefused(cut, "$.curve[" + std::to_string(cut["curve"].size() - 1) + "].travel", "out of");
  }
  for (const double number : {1e308, -1e4 - 1}) {
    auto cut = soundCut();
    cut["landmarks"]["yield"]["force_n"] = number;
    expectRefused(cut, "$.landmarks.yield.force_n", "out of range");
  }
}

TEST(CutFile, RefusesUnknownKeysAtEveryDepth) {
  for (const auto* place : {"", "/curve/4", "/landmarks", "/landmarks/yield", "/provenance"}) {
    auto cut = soundCut();
    cut[json::json_pointer(place)]["colour"] = 1;
    expectRefused(cut, "colour", "unknown key 'colour'");
  }
}

TEST(CutFile, RefusesEveryPartOfAWrongKind) {
  const std::vector<std::pair<std::string, std::string>> parts{
      {"/format", "a text is expected"},
      {"/name", "a text is expected"},
      {"/title", "a text is expected"},
      {"/unit", "a text is expected"},
      {"/synthetic", "true or false is expected"},
      {"/curve", "a list is expected"},
      {"/curve/0", "an object is expected"},
      {"/landmarks", "an object is expected"},
      {"/landmarks/yield", "an object is expected"},
      {"/provenance", "an object is expected"},
      {"/provenance/statement", "a text is expected"},
      {"/provenance/source_file", "a text is expected"},
      {"/provenance/calibration", "a text is expected"},
      {"/provenance/filter", "a text is expected"},
      {"/provenance/filter_parameters", "a text is expected"},
      {"/provenance/changes", "a list is expected"},
      {"/provenance/rows", "a list is expected"},
      {"/provenance/closures", "a list is expected"}};
  for (const auto& [place, what] : parts) {
    auto cut = soundCut();
    cut[json::json_pointer(place)] = 3.5;
    std::string path = place.substr(1);
    std::replace(path.begin(), path.end(), '/', '.');
    expectRefused(cut, path == "curve.0" ? "$.curve[0]" : "$." + path, what);
  }
}

TEST(CutFile, RefusesAProvenanceThatCannotBe) {
  const std::vector<std::tuple<std::string, std::string, std::string>> wrong{
      {"/provenance/rows", "[[1, 2], [0, 5]]", "$.provenance.rows[1]: a first and a last row"},
      {"/provenance/rows", "[[1, 2, 3]]", "$.provenance.rows[0]: a first and a last row"},
      {"/provenance/rows", "[[1.5, 3]]", "$.provenance.rows[0]: a first and a last row"},
      {"/provenance/rows", "[7]", "$.provenance.rows[0]: a first and a last row"},
      {"/provenance/closures", "[1, 0]", "$.provenance.closures[1]: the number of a closure"},
      {"/provenance/closures", "[\"2\"]", "$.provenance.closures[0]: the number of a closure"},
      {"/provenance/source_sha256", "\"A\"", "$.provenance.source_sha256: this is no SHA-256"},
      {"/provenance/slope_limit_n_per_travel_unit", "-1", "limit_n_per_travel_unit: this number"},
      {"/provenance/changes", "[4]", "$.provenance.changes[0]: a text is expected"}};
  for (const auto& [place, value, what] : wrong) {
    auto cut = soundCut();
    cut[json::json_pointer(place)] = json::parse(value);
    expectRefused(cut, "$.provenance", what);
  }
  auto cut = soundCut();
  cut["provenance"]["source_sha256"] = std::string(64, 'A');
  expectRefused(cut, "$.provenance.source_sha256", "64 of the digits 0-9 and a-f");
}

TEST(CutFile, RefusesWhatIsTooLargeOrTooDeep) {
  EXPECT_NE(refusalOf(std::string(10'000'000, ' ')).find("larger than 5 MB"), std::string::npos);
  EXPECT_NE(refusalOf(std::string(100'000, '[')).find("nested deeper"), std::string::npos);
}

TEST(CutFile, ReportsAProblemOfACurveOnce) {
  auto cut = soundCut();
  cut["curve"] = json::parse(R"([{"travel": 1, "force_n": "x"}])");
  const auto words = refusalOf(cut.dump());
  EXPECT_EQ(std::count(words.begin(), words.end(), '\n'), 2) << words;  // and that it is one point
}

TEST(CutFile, KeepsWhatWasSaidBefore) {
  questionnaires::Problems problems;
  problems.add("$", "something else");
  EXPECT_TRUE(readCut(soundCut().dump(), problems).has_value());
  EXPECT_EQ(problems.all().size(), 1U);
}

TEST(CutFile, ReportsAllProblemsAtOnce) {
  auto cut = soundCut();
  cut["name"] = "a b";
  cut["title"] = "";
  cut["curve"][1]["force_n"] = true;
  const auto words = refusalOf(cut.dump());
  for (const auto* place : {"$.name", "$.title", "$.curve[1].force_n"}) {
    EXPECT_NE(words.find(place), std::string::npos) << place << "\n" << words;
  }
}

TEST(CutFile, RefusesWhatIsNoJson) {
  for (const std::string text : {"", "[", "null", "12", "\"cut\"", "{}"}) {
    EXPECT_NE(refusalOf(text), "") << text;
  }
}

TEST(CutFile, SaysInAProtocolsSourcesWhatItsImportChanged) {
  using namespace haptics::recordings;
  const auto recording = readRecording(tests::textOf({}), "made.txt");
  const auto cut = importCut(recording, {.closures = {2}, .maxSlope = 1.0}).cut;
  const auto find = [&](const std::string& name) {
    return name == "my.json" ? std::optional(cutAsJson(cut, "")) : std::nullopt;
  };
  const auto loading = tests::load(
      R"({
    "$schema": "protocol-1.schema.json",
    "study": {"id": "punch", "title": "Punch", "version": "1"},
    "languages": ["en"], "cohorts": [{"id": "all", "title": "All"}],
    "devices": [{"id": "punch", "kind": "punch", "max_force_n": 8,
                 "max_force_rate_n_per_s": 300}],
    "conditions": [
      {"id": "a", "title": "A", "scene": {"device": "punch", "model": "interpolation",
       "parameters": {"cut": "my.json"}}},
      {"id": "b", "title": "B", "scene": {"device": "punch", "model": "interpolation",
       "parameters": {"cut": "parametric"}}}],
    "labels": {"policy": "random"},
    "phases": [{"id": "consent", "type": "consent", "instrument": "consent-punch"},
               {"id": "felt", "type": "block", "conditions": ["a", "b"],
                "order": {"type": "balancedLatinSquare"}, "minimum_cuts": 1}]})",
      find);
  ASSERT_TRUE(loading.loaded) << loading.describe();
  const auto words = describe(loading.loaded->sources.at(0));
  EXPECT_NE(words.find("changed by the import: peak 4.96 → 4.41 N"), std::string::npos) << words;
  EXPECT_NE(words.find("; slope limited to 1.00 N"), std::string::npos) << words;
}

}  // namespace cut_file_test
}  // namespace protocols
