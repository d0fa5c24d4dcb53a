// All commands of the program, called as a user does.
#include <algorithm>
#include <filesystem>
#include <map>
#include <sstream>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "study/session/session.h"
#include "tests/study/made_study.h"
#include "tests/support/child_process.h"
#include "tests/support/programs.h"
#include "tests/support/scratch_folder.h"
#include "tests/support/test_data.h"

namespace command_line_test {

using nlohmann::json;
using tests::Finished;
using Words = std::vector<std::string>;

constexpr int kTheWorldSaidNo = 1;
constexpr int kTheCallIsWrong = 2;

Finished palpate(Words arguments) {
  arguments.insert(arguments.begin(), tests::program());
  return tests::run(arguments);
}

std::string describe(const Words& arguments) {
  std::string text = "palpate";
  for (const auto& argument : arguments) text += " " + argument;
  return text;
}

Words linesOf(const std::string& text) {
  Words lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

/// The verbs that a help text lists.
Words subcommandsIn(const std::string& help) {
  Words verbs;
  bool isListed = false;
  for (const auto& line : linesOf(help)) {
    if (isListed && line.rfind("  ", 0) == 0 && line[2] != ' ') {
      verbs.push_back(line.substr(2, line.find(' ', 2) - 2));
    }
    isListed = isListed || line == "Subcommands:";
  }
  return verbs;
}

/// Checks that @p help has all parts of a help text.
void expectHelpful(const std::string& help, const std::string& command) {
  constexpr std::size_t kWhereWordsBegin = 34;
  const auto lines = linesOf(help);
  ASSERT_GE(lines.size(), 3U);
  EXPECT_FALSE(lines[0].empty());
  EXPECT_NE(help.find("Usage: " + command), std::string::npos);
  for (std::size_t i = 0; i < lines.size(); ++i) {
    EXPECT_LE(lines[i].size(), 130U) << lines[i];
    const bool isOption = lines[i].rfind("  --", 0) == 0;
    const bool isExplainedBelow = i + 1 < lines.size() && lines[i + 1].rfind("      ", 0) == 0;
    const bool isExplainedHere = lines[i].size() > kWhereWordsBegin;
    if (isOption) {
      EXPECT_TRUE(isExplainedHere || isExplainedBelow) << lines[i];
    }
  }
}

/// Without libpq there is no program for 'palpate collect' to start.
bool isBuilt(const std::string& verb) {
  const auto folder = std::filesystem::path(tests::program()).parent_path();
  return verb != "collect" || std::filesystem::exists(folder / "palpate-collect");
}

void expectEveryVerbToBeHelpful(const Words& path, int& leaves) {
  auto call = path;
  call.emplace_back("--help");
  SCOPED_TRACE(describe(call));
  const auto finished = palpate(call);
  EXPECT_EQ(finished.status, 0);
  EXPECT_EQ(finished.error, "");
  // 'palpate bench' starts another program, which prints its own name.
  const bool isBench = !path.empty() && path[0] == "bench";
  auto command = describe(path);
  if (isBench) command.replace(0, std::string("palpate bench").size(), "palpate-bench");
  expectHelpful(finished.out, command);
  const auto verbs = subcommandsIn(finished.out);
  if (verbs.empty()) ++leaves;
  for (const auto& verb : verbs) {
    if (path.empty() && !isBuilt(verb)) continue;
    auto below = path;
    below.push_back(verb);
    expectEveryVerbToBeHelpful(below, leaves);
  }
}

TEST(CommandLine, ExplainsEveryCommand) {
  int leaves = 0;
  expectEveryVerbToBeHelpful({}, leaves);
  EXPECT_GE(leaves, 15);
}

void expectRefused(const Words& arguments, int status, const Words& phrases) {
  SCOPED_TRACE(describe(arguments));
  const auto finished = palpate(arguments);
  EXPECT_EQ(finished.status, status) << finished.error;
  EXPECT_EQ(finished.out, "");
  EXPECT_EQ(finished.error.rfind("palpate: ", 0), 0U) << finished.error;
  for (const auto& phrase : phrases) {
    EXPECT_NE(finished.error.find(phrase), std::string::npos) << finished.error;
  }
}

TEST(CommandLine, ReportsMistakesInACall) {
  expectRefused({}, kTheCallIsWrong, {"palpate --help"});
  expectRefused({"frobnicate"}, kTheCallIsWrong, {"'frobnicate'", "There are: demo, protocol"});
  expectRefused({"study", "frob"}, kTheCallIsWrong, {"'frob'", "create, run, simulate"});
  expectRefused({"study", "status", "--jso"}, kTheCallIsWrong, {"'--jso'"});
  expectRefused({"study", "create"}, kTheCallIsWrong, {"DIR is required"});
  expectRefused(
      {"protocol", "orders", "punch-face-validity", "--participants", "0"},
      kTheCallIsWrong,
      {"1 to 100000"});
  expectRefused(
      {"stats", "test", "welch", "x.csv", "--group", "g", "--value", "x", "--level", "nan"},
      kTheCallIsWrong,
      {"--level"});
}

class CommandLineTest : public testing::Test {
 protected:
  std::string made(const std::string& protocol, int participants = 0) {
    const std::string folder = folder_ / "study";
    EXPECT_EQ(
        palpate({"study", "create", folder, "--protocol", protocol, "--seed", "7"}).status, 0);
    if (participants > 0) {
      EXPECT_EQ(
          palpate({"study", "simulate", folder, "--participants", std::to_string(participants)})
              .status,
          0);
    }
    return folder;
  }

  Words welchOf(const std::string& table, bool isJson = true) {
    const auto file = folder_.write("table.csv", table);
    Words call{"stats", "test", "welch", file, "--group", "g", "--value", "x"};
    if (isJson) call.emplace_back("--json");
    return call;
  }

  tests::ScratchFolder folder_;
};

TEST_F(CommandLineTest, ReportsMissingAndUnusableFiles) {
  const std::string nowhere = folder_ / "nowhere";
  for (const Words& call :
       {Words{"study", "status", nowhere},
        Words{"study", "verify", nowhere},
        Words{"study", "simulate", nowhere},
        Words{"stats", "run", nowhere},
        Words{"report", nowhere, "--out", folder_ / "r.html"},
        Words{"export", nowhere, "--out", folder_ / "x"}}) {
    expectRefused(call, kTheWorldSaidNo, {nowhere, "palpate study create"});
  }
  expectRefused({"protocol", "check", nowhere}, kTheWorldSaidNo, {nowhere});
  expectRefused({"recording", "import", nowhere}, kTheWorldSaidNo, {nowhere});
  expectRefused(
      {"scene", "explain", "punch-face-validity", "--condition", "z"},
      kTheWorldSaidNo,
      {"'z'", "interpolation, finite-elements, kalman"});
}

TEST_F(CommandLineTest, ReportsAllProblemsOfAProtocolWithTheirPlaces) {
  const auto file = folder_.write("bad.json", R"({"$schema": "protocol-1.schema.json",
      "study": {"id": "a b", "title": "", "versoin": "1"}})");
  const auto finished = palpate({"protocol", "check", file});
  EXPECT_EQ(finished.status, kTheWorldSaidNo);
  for (const auto* place : {"$.study.id", "$.study.title", "$.study.versoin", "'conditions'"}) {
    EXPECT_NE((finished.out + finished.error).find(place), std::string::npos) << place;
  }
}

TEST_F(CommandLineTest, ExportsOnlyTheRequestedRunMode) {
  const auto study = made("punch-face-validity", 2);
  const std::string out = folder_ / "data";
  expectRefused(
      {"export", study, "--out", out},
      kTheWorldSaidNo,
      {"No participant has taken part", "2 simulated sessions", "--run-mode simulated"});
  EXPECT_FALSE(std::filesystem::exists(out));

  const auto simulated = palpate({"export", study, "--run-mode", "simulated", "--out", out});
  EXPECT_EQ(simulated.status, 0) << simulated.error;
  EXPECT_NE(simulated.out.find("2 simulated sessions, with codes"), std::string::npos);
  const auto readme = tests::contentOf(out + "/README.md");
  EXPECT_NE(readme.find("2 simulated sessions, and no others. Nobody took part"), std::string::npos)
      << readme;
  EXPECT_NE(readme.find("SYNTHETIC"), std::string::npos) << readme;
  EXPECT_EQ(json::parse(tests::contentOf(out + "/codebook.json"))["run_mode"], "simulated");

  const std::string none = folder_ / "none";
  const auto empty = palpate({"export", study, "--run-mode", "pilot", "--out", none});
  EXPECT_NE(empty.out.find("no pilot sessions"), std::string::npos) << empty.out;
  EXPECT_NE(
      tests::contentOf(none + "/README.md").find("No pilot session is in this folder"),
      std::string::npos);
}

TEST_F(CommandLineTest, ReportsEarlierSimulatedParticipants) {
  const auto study = made("punch-face-validity", 2);
  const Words fewer{"study", "simulate", study, "--participants", "1"};
  EXPECT_NE(
      palpate(fewer).out.find("2 simulated participants have finished, all of them begun before"),
      std::string::npos);
  const Words more{"study", "simulate", study, "--participants", "11"};
  const auto finished = palpate(more);
  EXPECT_NE(
      finished.out.find("11 simulated participants have finished, 2 of them"), std::string::npos);
  EXPECT_NE(finished.error.find("10 of 11 simulated participants"), std::string::npos);
}

TEST_F(CommandLineTest, ReportsAnAmendmentWithoutChanges) {
  const auto study = made("punch-face-validity");
  const auto same = palpate({"study", "amend", study, "--protocol", "punch-face-validity"});
  EXPECT_EQ(same.status, 0) << same.error;
  EXPECT_NE(same.out.find("nothing has changed"), std::string::npos) << same.out;
  const auto other = palpate({"study", "amend", study, "--protocol", "punch-counterbalanced"});
  EXPECT_NE(other.error.find("not another version"), std::string::npos) << other.error;
}

TEST_F(CommandLineTest, NeverOverwrites) {
  const auto study = made("punch-face-validity", 1);
  expectRefused(
      {"study", "create", study, "--protocol", "punch-face-validity"},
      kTheWorldSaidNo,
      {"is there already"});
  const auto page = folder_.write("page.html", "mine");
  expectRefused(
      {"report", study, "--run-mode", "simulated", "--out", page},
      kTheWorldSaidNo,
      {page, "there already"});
  EXPECT_EQ(tests::contentOf(page), "mine");
  const std::string tables = folder_ / "tables";
  std::filesystem::create_directory(tables);
  expectRefused(
      {"export", study, "--run-mode", "simulated", "--out", tables},
      kTheWorldSaidNo,
      {"is there already"});
  EXPECT_TRUE(std::filesystem::is_empty(tables));
}

TEST_F(CommandLineTest, KeepsTheColumnsOfStatusApartWhereACodeIsLong) {
  tests::MadeStudy study;
  const std::string code = "a-code-that-is-longer-than-its-column";
  study::Session::enrol(*study, {.cohort = "surgeons", .code = code});
  study.close();
  const auto said = palpate({"study", "status", study.folder()}).out;
  const auto row = said.find(code);
  const auto head = said.find("participant ");
  ASSERT_NE(row, said.npos) << said;
  const auto columnOf = [&](std::size_t from, const std::string& word) {
    return said.find(word, from) - from;
  };
  EXPECT_EQ(columnOf(head, "cohort"), columnOf(row, "surgeons")) << said;
}

TEST_F(CommandLineTest, BacksUpAStudyThatVerifiesAfterwards) {
  const auto study = made("punch-face-validity", 2);
  const std::string copy = folder_ / "copy";
  const auto finished = palpate({"study", "backup", study, "--out", copy});
  EXPECT_EQ(finished.status, 0) << finished.error;
  EXPECT_NE(finished.out.find("everything is what was written"), std::string::npos);
  EXPECT_EQ(palpate({"study", "verify", copy}).status, 0);
  EXPECT_EQ(
      palpate({"study", "status", copy, "--json"}).out,
      palpate({"study", "status", study, "--json"}).out);
  expectRefused({"study", "backup", study, "--out", copy}, kTheWorldSaidNo, {"is there already"});
}

TEST_F(CommandLineTest, PrintsOneJsonDocumentWithTheOptionJson) {
  const auto study = made("punch-face-validity", 2);
  for (const Words& call :
       {Words{"study", "status", study, "--json"},
        Words{"stats", "run", study, "--run-mode", "simulated", "--json"},
        Words{"scene", "explain", "punch-face-validity", "--condition", "kalman", "--json"}}) {
    const auto finished = palpate(call);
    EXPECT_EQ(finished.status, 0) << finished.error;
    EXPECT_TRUE(json::accept(finished.out)) << describe(call);
  }
}

TEST_F(CommandLineTest, PrintsEveryTestOfAStudyAsJson) {
  const auto study = made("punch-face-validity", 12);
  const auto finished = palpate({"stats", "run", study, "--run-mode", "simulated", "--json"});
  const auto results = json::parse(finished.out);
  const auto& family = results["families"].at(0);
  const auto& within = family["cohorts"].at(0)["within"];
  EXPECT_TRUE(within["anova"]["f"].is_number());
  EXPECT_TRUE(within["anova"]["p_greenhouse_geisser"].is_number());
  ASSERT_FALSE(family["between"].empty());
  for (const auto* test : {"mann_whitney", "brunner_munzel", "cliff_delta"}) {
    const auto& result = family["between"].at(0)[test];
    EXPECT_TRUE(result.contains("reason")) << test;
  }
  EXPECT_TRUE(family["between"].at(0)["mann_whitney"]["p"].is_number());
  EXPECT_TRUE(results["votes"].at(0)["p_exact"].is_number());
  std::map<std::string, std::map<std::string, int>> sums;
  for (const auto& vote : results["votes"]) {
    for (const auto& [condition, votes] : vote["votes"].items()) {
      sums[vote["cohort"]][condition] += votes.get<int>();
      sums["all"][condition] += votes.get<int>();
    }
  }
  ASSERT_EQ(results["vote_sums"].size(), sums.size());
  for (const auto& sum : results["vote_sums"]) {
    const auto cohort = sum["cohort"].is_null() ? "all" : sum["cohort"].get<std::string>();
    EXPECT_EQ(sum["votes"], json(sums.at(cohort)));
  }
}

TEST_F(CommandLineTest, ReportsThatOutputWasNotWritten) {
  const std::string call = tests::program() + " protocol check punch-face-validity";
  EXPECT_EQ(tests::run({"sh", "-c", call}).status, 0);
  const auto finished = tests::run({"sh", "-c", call + " > /dev/full"});
  EXPECT_EQ(finished.status, kTheWorldSaidNo);
  EXPECT_NE(finished.error.find("could not be written"), std::string::npos) << finished.error;
}

TEST_F(CommandLineTest, TestsAnyTableOfTwoGroups) {
  const auto finished = palpate(welchOf("g,x\na,1\na,2\nb,5\nb,3\n"));
  ASSERT_EQ(finished.status, 0) << finished.error;
  const auto result = json::parse(finished.out);
  // R: t.test(c(1, 2), c(5, 3))
  EXPECT_EQ(result["n1"], 2);
  EXPECT_EQ(result["n2"], 2);
  EXPECT_DOUBLE_EQ(result["mean1"], 1.5);
  EXPECT_DOUBLE_EQ(result["mean2"], 4.0);
  EXPECT_DOUBLE_EQ(result["variance1"], 0.5);
  EXPECT_DOUBLE_EQ(result["variance2"], 2.0);
  EXPECT_DOUBLE_EQ(result["difference"], -2.5);
  EXPECT_NEAR(result["t"], -2.23606797749979, 1e-14);
  EXPECT_NEAR(result["df"], 1.470588235294118, 1e-14);
  EXPECT_NEAR(result["p"], 0.1987273889345261, 1e-14);
  EXPECT_NEAR(result["log10_p"], -0.7017422735876812, 1e-13);
  EXPECT_NEAR(result["conf_low"], -9.418522830071065, 1e-11);
  EXPECT_NEAR(result["conf_high"], 4.418522830071065, 1e-11);
  EXPECT_TRUE(result["reason"].is_null());
}

TEST_F(CommandLineTest, ReportsWhyATestIsUndefined) {
  const auto finished = palpate(welchOf("g,x\na,1\na,2\nb,5\n"));
  ASSERT_EQ(finished.status, 0) << finished.error;
  const auto result = json::parse(finished.out);
  for (const auto* key : {"variance2", "t", "df", "p", "log10_p", "conf_low", "conf_high"}) {
    ASSERT_TRUE(result.contains(key)) << key;
    EXPECT_TRUE(result[key].is_null()) << key;
  }
  EXPECT_NE(result["reason"].get<std::string>().find("one value only"), std::string::npos);
}

TEST_F(CommandLineTest, ReadsTablesAsSpreadsheetsWriteThem) {
  const auto plain = palpate(welchOf("g,x\na,1.5\na,2\nb,5\nb,3\n")).out;
  EXPECT_EQ(
      palpate(welchOf("\xEF\xBB\xBF\"g\",\"x\"\r\na,1.5\r\na,2\r\nb,5\r\nb,3\r\n")).out, plain);
  EXPECT_EQ(palpate(welchOf("g;x\na;1,5\na;2\nb;5\nb;3\n")).out, plain);
}

TEST_F(CommandLineTest, ReportsMistakesInATable) {
  expectRefused(
      welchOf("g,x\na,1\na,2\nb,zwei\nb,3\n"), kTheWorldSaidNo, {"table.csv", "line 4", "'zwei'"});
  expectRefused(welchOf("g,x\na,1\nb,2\nc,3\n"), kTheWorldSaidNo, {"3 groups", "two are compared"});
  expectRefused(welchOf("g,y\na,1\nb,2\n"), kTheWorldSaidNo, {"'x'", "'y'"});
  expectRefused(welchOf(""), kTheWorldSaidNo, {"table.csv"});
}

TEST_F(CommandLineTest, ImportsARealRecording) {
  constexpr const char* kRecording = "punch/matlab/11_meniscus_fast_1826 - Copy.txt";
  SKIP_WITHOUT_FETCHED_DATA(kRecording);
  const std::string cut = folder_ / "cut.json";
  const auto finished = palpate(
      {"recording", "import", tests::fetchedData(kRecording).string(), "--out", cut, "--json"});
  ASSERT_EQ(finished.status, 0) << finished.error;
  const auto report = json::parse(finished.out);
  for (const auto* key : {"rows", "sample_rate_hz", "saturated_rows", "max_force_n", "cuts"}) {
    EXPECT_TRUE(report.contains(key)) << key;
  }
  ASSERT_FALSE(report["cuts"].empty());
  for (const auto* key :
       {"first_row",
        "last_row",
        "peak_force_n",
        "interception",
        "yield",
        "bottom_out",
        "opening"}) {
    EXPECT_TRUE(report["cuts"][0].contains(key)) << key;
  }
  EXPECT_TRUE(json::accept(tests::contentOf(cut)));
}

TEST_F(CommandLineTest, PlaysASceneToTheEndOfItsData) {
  // The parametric cut ends at 11 travel units; its force fades over another 1.5.
  const std::string cut = folder_ / "cut";
  palpate({"scene", "play", "punch-counterbalanced", "--condition", "interpolation", "--out", cut});
  // Finite elements have no end of their own: the device's stop is at 11.
  const std::string elements = folder_ / "elements";
  palpate(
      {"scene",
       "play",
       "punch-counterbalanced",
       "--condition",
       "finite-elements",
       "--out",
       elements});
  const auto lastTravelOf = [](const std::string& out) {
    std::istringstream cells(linesOf(tests::contentOf(out + ".csv")).back());
    std::string cell;
    for (int i = 0; i < 4; ++i) std::getline(cells, cell, ',');
    return std::stod(cell);
  };
  EXPECT_DOUBLE_EQ(lastTravelOf(cut), 12.5);
  EXPECT_DOUBLE_EQ(lastTravelOf(elements), 11.0);
  const auto backwards = palpate(
      {"scene",
       "play",
       "punch-counterbalanced",
       "--condition",
       "kalman",
       "--from",
       "5",
       "--to",
       "4",
       "--out",
       folder_ / "backwards"});
  EXPECT_EQ(backwards.status, kTheWorldSaidNo);
  EXPECT_NE(backwards.error.find("from 5 to 4"), std::string::npos) << backwards.error;
}

TEST_F(CommandLineTest, DrawsForceCurvesOfConditions) {
  const std::string out = folder_ / "fused";
  const Words call{
      "scene",
      "play",
      "punch-face-validity",
      "--condition",
      "kalman",
      "--interpolation-noise",
      "0.1",
      "50",
      "--to",
      "11",
      "--out",
      out};
  const auto played = palpate(call);
  ASSERT_EQ(played.status, 0) << played.error;
  const auto lines = linesOf(tests::contentOf(out + ".csv"));
  EXPECT_EQ(lines.front(), "condition,curve,time_s,travel,force_n,stiffness");
  // The two forces that are combined, and two filters; 11 travel units at 57 units/s and 1 kHz.
  constexpr std::size_t kSteps = 194;
  ASSERT_EQ(lines.size(), 1 + 4 * kSteps);
  const auto lastForceOf = [&](std::size_t curve) {
    std::istringstream cells(lines[(curve + 1) * kSteps]);
    std::string cell;
    for (int i = 0; i < 5; ++i) std::getline(cells, cell, ',');
    return std::stod(cell);
  };
  EXPECT_NEAR(lastForceOf(0), 4.29, 1e-9);           // the recording, after the authors' filter
  EXPECT_NEAR(lastForceOf(1), 7.0, 1e-9);            // the finite elements, yielding
  EXPECT_NEAR(lastForceOf(2), 4.29, 0.1);            // the filter that trusts the recording
  EXPECT_NEAR(lastForceOf(3), 7.0, 0.4);             // the filter that does not
  EXPECT_EQ(palpate(call).status, kTheWorldSaidNo);  // nothing is overwritten
}

TEST_F(CommandLineTest, PassesAllOptionsOnToTheBenchmarks) {
  const auto help = palpate({"bench", "accuracy", "--help"});
  EXPECT_EQ(help.status, 0) << help.error;
  EXPECT_NE(help.out.find("--family"), std::string::npos) << help.out;
  const auto wrong = palpate({"bench", "accuracy", "--processes=0"});
  EXPECT_EQ(wrong.status, kTheCallIsWrong);
  EXPECT_NE(wrong.error.find("palpate-bench: --processes"), std::string::npos) << wrong.error;
  const auto unknown = palpate({"bench", "study"});
  EXPECT_EQ(unknown.status, kTheCallIsWrong);
  EXPECT_NE(unknown.error.find("There are: accuracy, stability"), std::string::npos)
      << unknown.error;
}

TEST_F(CommandLineTest, WritesBenchmarksAsAPageTablesAndFigures) {
  const std::string folder = folder_ / "bench";
  const auto accuracy =
      palpate({"bench", "accuracy", "--processes", "1", "--family", "encoders", "--out", folder});
  ASSERT_EQ(accuracy.status, 0) << accuracy.error;
  EXPECT_NE(accuracy.error.find("process 1 of 1: encoder"), std::string::npos);
  const auto stability = palpate({"bench", "stability", "--effort", "0.01", "--out", folder});
  ASSERT_EQ(stability.status, 0) << stability.out << stability.error;
  EXPECT_NE(stability.out.find(", 0 failed."), std::string::npos) << stability.out;
  for (const char* name : {"accuracy.html", "stability.html"}) {
    const auto page = tests::contentOf(std::filesystem::path(folder) / name);
    EXPECT_NE(page.find("processor"), std::string::npos) << name;
    EXPECT_NE(page.find("<table>"), std::string::npos) << name;
  }
  const auto encoders =
      linesOf(tests::contentOf(std::filesystem::path(folder) / "accuracy-encoders.csv"));
  EXPECT_EQ(encoders.size(), 1U + 6U * 3U * 3U * 2U);  // scenes, speeds, resolutions, two errors
  const auto walls =
      linesOf(tests::contentOf(std::filesystem::path(folder) / "stability-walls.csv"));
  EXPECT_GT(walls.size(), 100U);
}

TEST_F(CommandLineTest, MeasuresTheClockAndTheRecorder) {
  const auto servo = palpate(
      {"bench",
       "servo",
       "--rates",
       "1000",
       "--seconds",
       "0.2",
       "--recording",
       "0.3",
       "--disk",
       folder_.path().string()});
  ASSERT_EQ(servo.status, 0) << servo.error;
  EXPECT_NE(servo.out.find("palpate: chunks of a second"), std::string::npos) << servo.out;
  EXPECT_TRUE(std::filesystem::is_empty(folder_.path()));  // no file is left
}

TEST_F(CommandLineTest, TimesAConditionWithAdditionalParts) {
  const auto explained = palpate(
      {"scene",
       "explain",
       "punch-face-validity",
       "--condition",
       "interpolation",
       "--cost",
       "--json"});
  const auto costs = json::parse(explained.out)["costs"];
  ASSERT_GE(costs.size(), 4U);
  EXPECT_EQ(costs[0]["what"], "as it is");
  for (const auto& cost : costs) EXPECT_GT(cost["median_ns"].get<double>(), 0.0);
}

TEST_F(CommandLineTest, EstimatesTheProcessNoiseOfARecording) {
  constexpr const char* kRecording = "punch/matlab/11_meniscus_fast_1826 - Copy.txt";
  SKIP_WITHOUT_FETCHED_DATA(kRecording);
  const std::string path = tests::fetchedData(kRecording).string();
  const Words call{
      "recording",
      "noise",
      path,
      "--rows",
      "90:170,870:910,1440:1480,2300:2400,3000:3050,3700:3800,4300:4370,5100:5150,5900:5970,"
      "6800:6840",
      "--least-step",
      "0",
      "--filter",
      "authors-fir-333",
      "--json"};
  const auto found = json::parse(palpate(call).out);
  EXPECT_NEAR(found["process_force"].get<double>(), 6.1024, 5e-5);  // eq. (22)
  EXPECT_NEAR(found["process_stiffness"].get<double>(), 7.0275, 5e-5);
  EXPECT_NEAR(found["process_covariance"].get<double>(), 0.2772, 5e-5);
  EXPECT_EQ(palpate({"recording", "noise", path, "--rows", "1:999999"}).status, kTheWorldSaidNo);
}

TEST_F(CommandLineTest, ShowsTheOrderOfEveryParticipant) {
  const auto finished =
      palpate({"protocol", "orders", "reaming-hardness", "--participants", "4", "--csv"});
  EXPECT_EQ(finished.status, 0);
  EXPECT_GE(linesOf(finished.out).size(), 1U + 3U * 4U * 4U);  // cohorts, people, levels
  const auto fixed = palpate({"protocol", "orders", "punch-face-validity", "--participants", "12"});
  const auto lines = linesOf(fixed.out);
  const auto isOrder = [](const std::string& line) {
    return line.find("  12 ×  round-") != std::string::npos;
  };
  EXPECT_EQ(std::count_if(lines.begin(), lines.end(), isOrder), 2 * 2) << fixed.out;
  EXPECT_NE(fixed.out.find("[1, 2, 3, 4, 5, 6, 7, 8, …]"), std::string::npos);
  EXPECT_LT(lines.size(), 20U) << fixed.out;
  const auto words = palpate({"protocol", "orders", "reaming-hardness", "--participants", "5"});
  EXPECT_NE(words.out.find("do NOT balance it"), std::string::npos);
}

TEST_F(CommandLineTest, WritesASelfContainedReport) {
  const auto study = made("punch-face-validity", 3);
  const std::string page = folder_ / "page.html";
  const auto finished = palpate({"report", study, "--run-mode", "simulated", "--out", page});
  ASSERT_EQ(finished.status, 0) << finished.error;
  const auto html = tests::contentOf(page);
  for (const auto* loads : {"src=\"http", "href=\"http", "<script", "@import", "url("}) {
    EXPECT_EQ(html.find(loads), std::string::npos) << loads;
  }
  EXPECT_NE(html.find("Simulated"), std::string::npos);
}

}  // namespace command_line_test
