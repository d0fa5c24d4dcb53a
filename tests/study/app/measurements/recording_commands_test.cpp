// Recordings of another laboratory: import by a columns file, calibration of a sensor, reports.
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <numbers>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "haptics/recordings/cut.h"
#include "haptics/recordings/recording.h"
#include "tests/support/child_process.h"
#include "tests/support/programs.h"
#include "tests/support/scratch_folder.h"
#include "tests/support/test_data.h"

namespace recording_commands_test {

using haptics::recordings::decimal;
using nlohmann::json;
using Words = std::vector<std::string>;

tests::Finished palpate(Words arguments) {
  arguments.insert(arguments.begin(), tests::program());
  return tests::run(arguments);
}

/// The forces and travels of three cuts at 1 kHz, as another laboratory might write them: a handle
/// in degrees, from 12 (open) to 52 (closed), with a 40 Hz tremor of 0.2 degrees, and a load cell
/// of 0.5 V/N that reads 0.1 V at rest.
std::string foreignCuts(bool inVolts) {
  const auto curve = haptics::recordings::parametricCut().curve;
  std::string text = inVolts ? "t/ms;Winkel;U\n" : "t/ms;Winkel;Kraft\n";
  int row = 0;
  const auto write = [&](double travel, double force) {
    const double tremor = 0.2 * std::sin(2.0 * std::numbers::pi * 0.04 * row);
    std::string line = std::to_string(row++) + ";" + decimal(12.0 + 4.0 * travel + tremor, 4) +
                       ";" + decimal(inVolts ? 0.1 + 0.5 * force : force, 5) + "\n";
    for (char& c : line) c = c == '.' ? ',' : c;
    text += line;
  };
  for (int cut = 0; cut < 3; ++cut) {
    for (int i = 0; i < 400; ++i) write(0.0, 0.0);
    for (int i = 0; i <= 600; ++i) {
      const double travel = 11.0 * (0.5 - 0.5 * std::cos(std::numbers::pi * i / 600.0));
      write(travel, curve.forceAt(travel));
    }
    for (int i = 0; i <= 600; ++i) write(11.0 * (1.0 - i / 600.0), 0.0);
  }
  return text;
}

const char* const kColumns = R"({
  "format": "palpate-columns-1",
  "time": {"column": "t/ms", "unit": "ms"},
  "travel": {"column": "Winkel", "open": 12, "closed": 52},
  "force": {"column": "Kraft", "unit": "N"}
})";

const char* const kColumnsInVolts = R"({
  "format": "palpate-columns-1",
  "time": {"column": 1, "unit": "ms"},
  "travel": {"column": 2, "open": 12, "closed": 52},
  "force": {"column": 3, "unit": "V"},
  "calibration": "cell.json"
})";

class RecordingCommands : public testing::Test {
 protected:
  std::string file(const std::string& name, const std::string& content) {
    return folder_.write(name, content);
  }

  tests::ScratchFolder folder_;
};

TEST_F(RecordingCommands, ImportsATableInNewtonsAndDesignsTheFilterForItsRate) {
  const auto table = file("cuts.csv", foreignCuts(false));
  const auto columns = file("columns.json", kColumns);
  const std::string cut = folder_ / "cut.json";
  const auto finished =
      palpate({"recording", "import", table, "--columns", columns, "--out", cut, "--json"});
  ASSERT_EQ(finished.status, 0) << finished.error;
  const auto report = json::parse(finished.out);
  EXPECT_NEAR(report["sample_rate_hz"].get<double>(), 1000.0, 1e-6);
  ASSERT_EQ(report["cuts"].size(), 3U);
  for (const auto& found : report["cuts"]) {
    EXPECT_NEAR(found["yield"]["travel"].get<double>(), 7.2, 0.1);
    EXPECT_NEAR(found["yield"]["force_n"].get<double>(), 4.4, 0.01);
    EXPECT_NEAR(found["bottom_out"]["travel"].get<double>(), 10.3, 0.1);
  }
  const auto provenance = json::parse(tests::contentOf(cut))["provenance"];
  EXPECT_EQ(provenance["calibration"], "newtons");
  const auto words = provenance["filter_parameters"].get<std::string>();
  EXPECT_NE(
      words.find("-6 dB at 17.69075 Hz, designed for the recording's own 1000.0 Hz"),
      std::string::npos)
      << words;
}

TEST_F(RecordingCommands, ListsTheRowsThatACutIsMadeOf) {
  const auto table = file("cuts.csv", foreignCuts(false));
  const auto columns = file("columns.json", kColumns);
  const Words import{"recording", "import", table, "--columns", columns, "--cut", "2"};
  auto asJson = import;
  asJson.push_back("--json");
  const auto report = json::parse(palpate(asJson).out);
  ASSERT_EQ(report["chosen"]["rows"].size(), 1U) << report["chosen"];
  const auto& rows = report["chosen"]["rows"][0];
  EXPECT_EQ(report["cuts"][1]["closing_rows"], rows);
  const auto range = std::to_string(rows[0].get<int>()) + "–" + std::to_string(rows[1].get<int>());
  const auto text = palpate(import).out;
  EXPECT_NE(text.find("  2 "), std::string::npos) << text;
  EXPECT_NE(text.find(range + " "), std::string::npos) << range << "\n" << text;
}

TEST_F(RecordingCommands, WarnsWhereTheCutIsNotWhatWasRecorded) {
  const auto table = file("cuts.csv", foreignCuts(false));
  const auto columns = file("columns.json", kColumns);
  const auto take = [&](const char* slope) {
    return palpate(
        {"recording", "import", table, "--columns", columns, "--cut", "2", "--max-slope", slope});
  };
  const auto altered = take("1").out;
  EXPECT_NE(altered.find("WARNING: the cut is not what was recorded"), std::string::npos)
      << altered;
  EXPECT_LT(altered.find("  peak "), altered.find("  slope limited to 1.00 N")) << altered;
  const auto kept = take("50").out;
  EXPECT_EQ(kept.find("WARNING"), std::string::npos) << kept;
}

TEST_F(RecordingCommands, CalibratesASensorAndImportsWhatItRead) {
  const auto loads = file("loads.csv", "U [V],load [N]\n0.1,0\n0.6,1\n1.1,2\n2.6,5\n5.1,10\n");
  const std::string sensor = folder_ / "cell.json";
  const auto calibrated = palpate(
      {"recording",
       "calibrate",
       loads,
       "--order",
       "1",
       "--out",
       sensor,
       "--report",
       folder_ / "calibration"});
  ASSERT_EQ(calibrated.status, 0) << calibrated.error;
  EXPECT_NE(calibrated.out.find("f = -0.2 + 2 r N"), std::string::npos) << calibrated.out;
  EXPECT_TRUE(std::filesystem::exists(folder_ / "calibration/calibration.html"));
  const auto points = tests::contentOf(folder_ / "calibration/calibration-points.csv");
  EXPECT_EQ(points.substr(0, points.find('\n')), "reading,force_n,fitted_n,residual_n");

  const auto table = file("volts.csv", foreignCuts(true));
  const auto columns = file("columns.json", kColumnsInVolts);
  const auto imported = palpate({"recording", "import", table, "--columns", columns, "--json"});
  ASSERT_EQ(imported.status, 0) << imported.error;
  const auto report = json::parse(imported.out);
  EXPECT_NEAR(report["max_force_n"].get<double>(), 5.0, 1e-3);
  EXPECT_EQ(report["chosen"]["calibration"], "own-sensor");
  EXPECT_EQ(report["refused_line_count"], 1);  // the head, since columns have numbers here
}

TEST_F(RecordingCommands, DrawsTheSpectrumBeforeAndAfterTheFilter) {
  const auto table = file("cuts.csv", foreignCuts(false));
  const auto columns = file("columns.json", kColumns);
  const std::string report = folder_ / "report";
  const auto finished = palpate(
      {"recording",
       "import",
       table,
       "--columns",
       columns,
       "--filter",
       "butterworth-zero-phase",
       "--cutoff",
       "5",
       "--report",
       report});
  ASSERT_EQ(finished.status, 0) << finished.error;
  EXPECT_NE(finished.out.find("-6 dB at 5.000 Hz"), std::string::npos) << finished.out;
  const auto page = tests::contentOf(report + "/recording.html");
  EXPECT_NE(page.find("Amplitude spectrum"), std::string::npos);

  // The tremor is a line of 0.05 travel units at 40 Hz; (40/5)^8 is taken away from it.
  std::istringstream rows(tests::contentOf(report + "/recording-spectrum.csv"));
  std::string line;
  std::getline(rows, line);
  EXPECT_EQ(line, "frequency_hz,before,after");
  double before = 0.0;
  double after = 0.0;
  while (std::getline(rows, line)) {
    double values[3] = {};
    ASSERT_EQ(std::sscanf(line.c_str(), "%lf,%lf,%lf", &values[0], &values[1], &values[2]), 3);
    if (std::abs(values[0] - 40.0) > 1.0) continue;
    before = std::max(before, values[1]);
    after = std::max(after, values[2]);
  }
  EXPECT_NEAR(before, 0.05, 0.01);
  EXPECT_LT(after, 1e-5);
}

TEST_F(RecordingCommands, RefusesWhatDoesNotGoTogether) {
  const auto table = file("volts.csv", foreignCuts(true));
  const auto columns = file("columns.json", kColumnsInVolts);
  const auto refusal = [&](Words more) {
    Words call{"recording", "import", table, "--columns", columns};
    call.insert(call.end(), more.begin(), more.end());
    const auto finished = palpate(call);
    EXPECT_EQ(finished.status, 1);
    return finished.error;
  };
  EXPECT_NE(refusal({}).find("cell.json"), std::string::npos);
  file("cell.json", R"({"format": "palpate-calibration-1", "name": "a", "unit": "mV",
                        "coefficients_n": [0, 1]})");
  EXPECT_NE(refusal({}).find("is for readings in mV"), std::string::npos);
  EXPECT_NE(refusal({"--calibration", "mine"}).find("no calibration 'mine'"), std::string::npos);
  EXPECT_NE(
      refusal({"--calibration", "paper-eq1"}).find("is for readings in counts"), std::string::npos);
  EXPECT_NE(refusal({"--cutoff", "5"}).find("butterworth-zero-phase"), std::string::npos);
}

}  // namespace recording_commands_test
