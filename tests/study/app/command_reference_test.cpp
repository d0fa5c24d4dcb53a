// Manual pages and completions against the command lines that they describe.
#include "study/app/command_reference.h"

#include <algorithm>
#include <fstream>
#include <sstream>

#include <CLI/CLI.hpp>
#include <gtest/gtest.h>

#include "study/app/program.h"
#include "study/app/studio_options.h"
#include "study/bench/bench_program.h"
#include "tests/support/child_process.h"
#include "tests/support/scratch_folder.h"

namespace command_reference_test {

using study::app::CommandDescription;

const CLI::App& program() {
  static study::app::Action action;
  static const auto made = study::app::makeProgram(action);
  return *made;
}

const CommandDescription& palpate() {
  static const auto described = study::app::describe(program());
  return described;
}

CommandDescription benchmarks() {
  study::app::Action action;
  return study::app::describe(*study::bench::makeBenchProgram(action));
}

/// The page as a reader sees it, without requests and escapes of troff.
std::string readable(std::string page) {
  const std::pair<std::string, std::string> escapes[]{
      {"\\fB", ""},
      {"\\fI", ""},
      {"\\fR", ""},
      {"\\-", "-"},
      {"\\(aq", "'"},
      {"\\e", "\\"},
      {"\\(ga", "`"},
      {"\\(ha", "^"},
      {"\\(ti", "~"}};
  for (const auto& [escape, text] : escapes) {
    for (auto at = page.find(escape); at != std::string::npos; at = page.find(escape, at)) {
      page.replace(at, escape.size(), text);
    }
  }
  return page;
}

std::string palpatePage() {
  return study::app::manPage(
      palpate(),
      {.version = "palpate 1", .summary = "studies", .files = ".dot\n'quote", .seeAlso = {"a(1)"}});
}

/// Calls @p visit for every command on help pages, with its full name.
template <typename Visit>
void forEachCommand(const CLI::App& command, const std::string& above, const Visit& visit) {
  const auto name = above + command.get_name();
  visit(command, name);
  for (const auto* below : command.get_subcommands({})) {
    if (!below->get_group().empty()) forEachCommand(*below, name + " ", visit);
  }
}

/// The part of the page about one command: from its heading to the next.
std::string partOf(const std::string& page, const std::string& heading) {
  const auto begin = page.find("\n" + heading + "\n");
  if (begin == std::string::npos) return "";
  return page.substr(begin + 1, page.find("\n.S", begin + 1) - begin);
}

TEST(CommandReference, ManualPageHasEveryCommandAndOption) {
  const auto page = readable(palpatePage());
  int options = 0;
  forEachCommand(program(), "", [&](const CLI::App& command, const std::string& name) {
    SCOPED_TRACE(name);
    const auto part = partOf(page, name == "palpate" ? ".SH OPTIONS" : ".SS " + name);
    ASSERT_NE(part, "");
    for (const auto* option : command.get_options({})) {
      const bool isShown = !option->get_group().empty();
      const auto optionName =
          option->get_positional() ? option->get_name(true) : "--" + option->get_lnames().front();
      EXPECT_EQ(part.find(optionName) != std::string::npos, isShown) << optionName;
      if (isShown) {
        EXPECT_NE(part.find(option->get_description()), std::string::npos) << optionName;
        ++options;
      }
    }
  });
  EXPECT_GT(options, 100);
}

TEST(CommandReference, ListsTheValuesOfAnOption) {
  const auto page = readable(palpatePage());
  const auto part = partOf(page, ".SS palpate export");
  EXPECT_NE(
      part.find("one of: csv, json, psych-ds, bids, r, python; default: csv"), std::string::npos)
      << part;
}

TEST(CommandReference, ShowsTheValuesOfAnOptionInHelp) {
  const auto help = program().get_subcommand("export")->help();
  EXPECT_NE(help.find("--out FOLDER REQUIRED"), std::string::npos) << help;
  EXPECT_NE(
      help.find("--format {csv,json,psych-ds,bids,r,python} (default: csv)"), std::string::npos)
      << help;
  const auto orders = program().get_subcommand("protocol")->get_subcommand("orders")->help();
  EXPECT_NE(orders.find("--participants NUMBER (1 to 100000"), std::string::npos) << orders;
  forEachCommand(program(), "", [&](const CLI::App& command, const std::string& name) {
    for (const char* raw : {"TEXT:", "INT:", "UINT", "INT in", "FLOAT", "POSITIVE"}) {
      EXPECT_EQ(command.help().find(raw), std::string::npos) << name << ": " << raw;
    }
  });
}

TEST(CommandReference, EscapesTroffRequests) {
  const auto page = palpatePage();
  EXPECT_NE(page.find("\n\\&.dot\n"), std::string::npos);
  EXPECT_NE(page.find("\n\\&\\(aqquote\n"), std::string::npos);
}

TEST(CommandReference, ManualPagesHaveNoWarnings) {
  if (tests::run({"sh", "-c", "command -v groff"}).status != 0)
    GTEST_SKIP() << "needs groff: ./setup --check";
  const tests::ScratchFolder folder;
  const auto file = (folder.path() / "page.1").string();
  for (const auto& page :
       {palpatePage(),
        study::app::manPage(benchmarks(), {.version = "1", .summary = "s"}),
        study::app::manPage(study::app::describeStudio(), {.version = "1", .summary = "s"})}) {
    std::ofstream(file) << page;
    const auto finished = tests::run({"groff", "-man", "-ww", "-Kutf8", "-Tutf8", "-z", file});
    EXPECT_EQ(finished.status, 0);
    EXPECT_EQ(finished.error, "");
  }
}

/// The completions that bash offers for the last word of a command line.
std::vector<std::string> offered(
    const CommandDescription& described, const std::vector<std::string>& words) {
  const tests::ScratchFolder folder;
  const auto file = (folder.path() / "completion").string();
  std::ofstream(file) << study::app::bashCompletion(described);
  std::string script = "source '" + file + "'; COMP_WORDS=(";
  for (const auto& word : words) script += " '" + word + "'";
  std::string function = "_" + described.name;
  std::replace(function.begin(), function.end(), '-', '_');
  script += "); COMP_CWORD=" + std::to_string(words.size() - 1) + "; " + function +
            "; printf '%s\\n' \"${COMPREPLY[@]}\"";
  const auto finished = tests::run({"bash", "-uc", script});
  EXPECT_EQ(finished.error, "");
  std::vector<std::string> offers;
  std::istringstream lines(finished.out);
  for (std::string line; std::getline(lines, line);) {
    if (!line.empty()) offers.push_back(line);
  }
  return offers;
}

void expectOffersOf(const CommandDescription& described, std::vector<std::string> words) {
  SCOPED_TRACE(described.name);
  words.emplace_back("");
  const auto verbs = offered(palpate(), words);
  for (const auto& command : described.commands) {
    const auto verb = command.name.substr(command.name.rfind(' ') + 1);
    EXPECT_EQ(std::count(verbs.begin(), verbs.end(), verb), 1) << verb;
  }
  words.back() = "--";
  const auto options = offered(palpate(), words);
  for (const auto& option : described.options) {
    if (option.isPositional) continue;
    EXPECT_EQ(std::count(options.begin(), options.end(), option.names.back()), 1)
        << option.names.back();
  }
  words.pop_back();
  for (const auto& command : described.commands) {
    auto below = words;
    below.push_back(command.name.substr(command.name.rfind(' ') + 1));
    expectOffersOf(command, below);
  }
}

TEST(CommandReference, CompletionOffersEveryCommandAndOption) {
  expectOffersOf(palpate(), {"palpate"});
}

TEST(CommandReference, CompletionOffersTheCommandsOfAProgramThatItStarts) {
  auto starter = palpate();
  study::app::addCommandsOf(benchmarks(), "bench", starter);
  study::app::addCommandsOf(benchmarks(), "nosuch", starter);
  EXPECT_EQ(starter.commands.size(), palpate().commands.size());
  const auto offers = offered(starter, {"palpate", "bench", ""});
  EXPECT_EQ(std::count(offers.begin(), offers.end(), "stats"), 1);
}

TEST(CommandReference, CompletionOffersTheValuesOfAnOption) {
  const std::vector<std::string> formats{"psych-ds", "python"};
  auto offers = offered(palpate(), {"palpate", "export", "my-study", "--format", "p"});
  std::sort(offers.begin(), offers.end());
  EXPECT_EQ(offers, formats);
}

TEST(CommandReference, CompletionLeavesOtherWordsToFileNames) {
  EXPECT_TRUE(offered(palpate(), {"palpate", "export", ""}).empty());
  EXPECT_TRUE(offered(palpate(), {"palpate", "export", "my-study", "--out", ""}).empty());
}

TEST(CommandReference, CompletesTheOtherPrograms) {
  const std::vector<std::string> kalman{"kalman"};
  EXPECT_EQ(offered(benchmarks(), {"palpate-bench", "accuracy", "--family", "k"}), kalman);
  const std::vector<std::string> devices{"--devices"};
  EXPECT_EQ(offered(study::app::describeStudio(), {"palpate-studio", "--d"}), devices);
}

}  // namespace command_reference_test
