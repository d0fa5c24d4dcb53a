// A study with the emulated paddle, and its own words and units.
#include <filesystem>
#include <fstream>
#include <sstream>

#include <gtest/gtest.h>

#include "protocols/load_protocol.h"
#include "tests/support/child_process.h"
#include "tests/support/programs.h"
#include "tests/support/says.h"
#include "tests/support/scratch_folder.h"
#include "tests/support/test_data.h"

namespace paddle_test {

using tests::says;

std::string textIn(const std::filesystem::path& file) {
  std::ifstream stream(file);
  std::stringstream text;
  text << stream.rdbuf();
  return text.str();
}

std::filesystem::path protocol() {
  return tests::repository() / "tests/study/app/devices/paddle.json";
}

std::string palpate(std::vector<std::string> call) {
  call.insert(call.begin(), tests::program());
  const auto finished = tests::run(call);
  EXPECT_EQ(finished.status, 0) << finished.out << finished.error;
  return finished.out;
}

TEST(DevicePaddle, RunsOnItsWireAndIsReportedInItsWordsAndUnits) {
  tests::ScratchFolder folder;
  const std::string out = folder / "rehearsal";
  const auto rehearsed =
      palpate({"device", "rehearse", "--protocol", protocol().string(), "--out", out});
  EXPECT_TRUE(says(rehearsed, "Emulating 'paddle': "));
  EXPECT_TRUE(says(rehearsed, " degrees"));
  EXPECT_TRUE(says(rehearsed, "force at most"));
  EXPECT_TRUE(says(textIn(out + "/devices.json"), "\"paddle-serial\""));

  const std::string study = out + "/study";
  palpate(
      {"export",
       study,
       "--run-mode",
       "simulated",
       "--unblind",
       "--reason",
       "a test",
       "--out",
       folder / "export"});
  const auto trials = textIn(folder / "export/trials.csv");
  EXPECT_TRUE(says(trials, "paddle on "));
  const auto codebook = textIn(folder / "export/codebook.json");
  EXPECT_TRUE(says(codebook, "Presses that were made"));
  EXPECT_TRUE(says(codebook, "Where the load began to rise [deg]"));

  const auto reported = [&](const std::string& language) {
    const std::string file = folder / ("report-" + language + ".html");
    palpate(
        {"report",
         study,
         "--run-mode",
         "simulated",
         "--reason",
         "a test",
         "--language",
         language,
         "--out",
         file});
    return textIn(file);
  };
  const auto english = reported("en");
  EXPECT_TRUE(says(english, "at least 2 presses"));
  EXPECT_TRUE(says(english, "4 presses"));
  EXPECT_EQ(english.find("cuts or strokes"), std::string::npos);
  EXPECT_TRUE(says(reported("de"), "mindestens 2 Druckbewegungen"));
  EXPECT_TRUE(says(reported("nb"), "minst 2 trykk"));
}

TEST(DevicePaddle, RefusesACutRecordedInAnotherUnit) {
  auto text = textIn(protocol());
  const std::string model = "\"finite-elements\"";
  text.replace(text.find(model), model.size(), "\"interpolation\"");
  const auto from = text.find("\"parameters\"");
  text.replace(from, text.find('}', from) + 1 - from, "\"parameters\": {}");
  questionnaires::Problems problems;
  EXPECT_FALSE(protocols::loadProtocol(
      text, [](const std::string&) { return std::nullopt; }, problems));
  EXPECT_TRUE(says(
      questionnaires::describe(problems.all()),
      "the travel of interpolation is in 'travel_unit', and that of a paddle in 'deg'"));
}

TEST(DevicePaddle, IsRefusedWithAVisualisation) {
  auto text = textIn(protocol());
  const std::string device = "\"device\": \"paddle\",";
  text.replace(text.find(device), device.size(), device + " \"visualisation\": true,");
  questionnaires::Problems problems;
  EXPECT_FALSE(protocols::loadProtocol(
      text, [](const std::string&) { return std::nullopt; }, problems));
  EXPECT_TRUE(says(questionnaires::describe(problems.all()), "nothing can be seen with a paddle"));
}

}  // namespace paddle_test
