#include "protocols/cut_file.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "haptics/recordings/parametric_cut.h"

namespace protocols {
namespace {

using nlohmann::json;

json soundCut() {
  return json::parse(cutAsJson(haptics::recordings::parametricCut(), std::string(64, 'a')));
}

/// All that is said about a cut file, in words; empty where it can be read.
std::string refusalOf(const std::string& text) {
  questionnaires::Problems problems;
  const auto cut = readCut(text, problems);
  EXPECT_EQ(cut.has_value(), !problems.hasErrors());
  return cut ? std::string() : questionnaires::inWords(problems.all());
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
  ASSERT_TRUE(read) << questionnaires::inWords(problems.all());
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

TEST(CutFile, RefusesNumbersThatAreNone) {
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
  expectRefused(cut, "$.format", "no cut file of the kind");
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

TEST(CutFile, TellsEverythingAtOnce) {
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

}  // namespace
}  // namespace protocols
