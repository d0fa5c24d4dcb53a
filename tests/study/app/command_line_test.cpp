// The program as a whole: help on every command, mistakes in a call, files that are there or not.
#include <filesystem>
#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/study/app/palpate_command.h"
#include "tests/support/programs.h"
#include "tests/support/test_data.h"

namespace command_line_test {

using nlohmann::json;
using tests::describe;
using tests::expectRefused;
using tests::kTheCallIsWrong;
using tests::kTheWorldSaidNo;
using tests::linesOf;
using tests::palpate;
using tests::Words;

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

TEST(CommandLine, ReportsMistakesInACall) {
  expectRefused({}, kTheCallIsWrong, {"palpate --help"});
  expectRefused({"frobnicate"}, kTheCallIsWrong, {"'frobnicate'", "There are: demo, protocol"});
  expectRefused({"study", "frob"}, kTheCallIsWrong, {"'frob'", "create, run, simulate"});
  expectRefused({"study", "status", "--jso"}, kTheCallIsWrong, {"'--jso'"});
  expectRefused({"study", "create"}, kTheCallIsWrong, {"FOLDER is required"});
  expectRefused(
      {"protocol", "orders", "punch-face-validity", "--participants", "0"},
      kTheCallIsWrong,
      {"1 to 100000"});
  expectRefused(
      {"stats", "test", "welch", "x.csv", "--group", "g", "--value", "x", "--level", "nan"},
      kTheCallIsWrong,
      {"--level"});
}

class CommandLineTest : public tests::StudyOfCommands {};

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

TEST_F(CommandLineTest, ReportsThatOutputWasNotWritten) {
  const std::string call = tests::program() + " protocol check punch-face-validity";
  EXPECT_EQ(tests::run({"sh", "-c", call}).status, 0);
  const auto finished = tests::run({"sh", "-c", call + " > /dev/full"});
  EXPECT_EQ(finished.status, kTheWorldSaidNo);
  EXPECT_NE(finished.error.find("could not be written"), std::string::npos) << finished.error;
}

}  // namespace command_line_test
