#include <cstdio>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "analysis/data/csv_table.h"
#include "analysis/data/moments.h"
#include "analysis/registry/registry.h"
#include "base/joined.h"
#include "questionnaires/json/document.h"
#include "study/app/command_options.h"
#include "study/app/json_file.h"
#include "study/words/counted.h"

namespace study::app {
namespace {

struct TestArguments {
  std::string test;
  std::string file;
  analysis::ChosenColumns columns;
  analysis::TestSettings settings;
  bool isListRequested = false;
  bool json = false;
};

std::string orMissing(const std::optional<double>& value) {
  return value ? fmt::format("{:.10g}", *value) : "–";
}

/// A name with spaces for underscores: "log odds ratio" for "log_odds_ratio".
std::string withSpaces(std::string_view name) {
  std::string text(name);
  for (char& c : text) c = c == '_' ? ' ' : c;
  return text;
}

/// The options that name the columns of a test: "--group and --value"; optional ones in brackets.
std::string columnsOf(const analysis::StatisticalTest& test) {
  auto text = base::joined(analysis::columnsOf(test.shape), " ", [](const auto& column) {
    const auto option = "--" + std::string(column.role);
    return column.isRequired ? option : "[" + option + "]";
  });
  if (test.form == analysis::StatisticalTest::Form::NeedsBound) text += " --bound";
  if (test.form == analysis::StatisticalTest::Form::RowOfEachGroup) text += " --from";
  return text;
}

int list() {
  for (const auto& test : analysis::statisticalTests()) {
    fmt::print("{:<20} {:<35} {}\n", test.id, columnsOf(test), test.title);
    fmt::print("{:<20} {:<35} {}\n", "", "", test.question);
  }
  return 0;
}

/// Prints size, mean and variance of each group or column.
void printGroups(const analysis::TestData& data) {
  if (data.values.empty()) return;
  fmt::print("{:<12} {:>8} {:>16} {:>16}\n", "group", "n", "mean", "variance");
  for (const auto& group : data.values) {
    const auto summary = analysis::summarise(group.values);
    fmt::print(
        "{:<12} {:>8} {:>16} {:>16}\n",
        group.name,
        summary.n,
        orMissing(summary.mean),
        orMissing(summary.variance));
  }
  fmt::print("\n");
}

void printRow(const analysis::TestRow& row, double level) {
  std::string line;
  const auto add = [&](const std::string& text) { line += (line.empty() ? "" : ", ") + text; };
  const auto addNumber = [&](const analysis::NamedNumber& number, const char* separator) {
    if (!number.name.empty()) add(withSpaces(number.name) + separator + orMissing(number.value));
  };
  addNumber(row.estimate, " ");
  addNumber(row.statistic, " = ");
  if (row.statistic.name == "F") {
    add(fmt::format("df = {} and {}", orMissing(row.df), orMissing(row.df2)));
  } else if (row.df || row.statistic.name == "t") {
    add("df = " + orMissing(row.df));
  }
  if (row.p || row.effect.name.empty()) add("p = " + orMissing(row.p));
  addNumber(row.effect, " = ");
  fmt::print("{}\n", line);
  const auto interval = [&](const std::optional<analysis::Interval>& limits, std::string_view of) {
    if (!limits) return;
    fmt::print(
        "{:g} % confidence interval of the {}: {:.10g} to {:.10g}\n",
        100.0 * level,
        withSpaces(of),
        limits->low,
        limits->high);
  };
  interval(row.interval, row.estimate.name);
  interval(row.effectInterval, row.effect.name);
  for (const auto& number : row.more) {
    fmt::print("{} = {}\n", withSpaces(number.name), orMissing(number.value));
  }
  if (!row.reason.empty()) fmt::print("{}\n", base::describe(row.reason));
}

void print(
    const analysis::StatisticalTest& test,
    const analysis::TestData& data,
    const std::vector<analysis::TestRow>& rows,
    double level) {
  const bool isListRequested = test.hasSeveralRows();
  const auto names = [](const analysis::TestRow& row) {
    return row.group2.empty() ? row.group1 : row.group1 + " − " + row.group2;
  };
  const bool hasNames = !isListRequested && !rows.front().group1.empty();
  fmt::print("{}{}\n\n", test.title, hasNames ? ", " + names(rows.front()) : "");
  printGroups(data);
  if (data.missing > 0) {
    const bool isGrouped = test.shape == analysis::DataShape::TwoGroups;
    fmt::print(
        "{} left out, {}.\n",
        words::counted(data.missing, "row was", "rows were"),
        isGrouped ? "without a group or a value" : "because a cell is empty or NA");
  }
  for (const auto& row : rows) {
    if (isListRequested && !row.group1.empty()) fmt::print("{}\n", names(row));
    printRow(row, level);
  }
}

int runTest(const TestArguments& options) {
  if (options.isListRequested) return list();
  const auto& test = analysis::statisticalTest(options.test);
  const auto text = questionnaires::readTextFile(options.file);
  try {
    const auto data = analysis::readTestData(text, test.shape, options.columns);
    const auto rows = analysis::computeTest(test, data, options.settings);
    const double level = options.settings.level;
    if (options.json) {
      std::fputs(testAsJson(test, data, rows, level).c_str(), stdout);
    } else {
      print(test, data, rows, level);
    }
  } catch (const base::UserError& error) {
    throw base::UserError(options.file + " cannot be tested:\n" + error.what());
  }
  return 0;
}

}  // namespace

void addTestCommand(CLI::App& stats, Action& action) {
  auto [command, options] =
      addCommand(stats, action, "test", "Run a statistical test on a table of your own", runTest);
  auto* list = command->add_flag(
      "--list",
      options.isListRequested,
      "List all tests, with the columns that each needs and the question that it answers");
  auto* name =
      command->add_option("TEST", options.test, "Name of a test from --list, for instance welch");
  auto* file = command->add_option("FILE", options.file, "A CSV file with a header line");
  name->excludes(list);
  file->excludes(list);
  const auto column = [&command = *command, &columns = options.columns](
                          const char* role, const char* text) {
    return command.add_option(std::string("--") + role, columns[role], text);
  };
  column(
      "group",
      "Column that names the group (default of this and the next options: the file's columns, "
      "left to right)")
      ->expected(1);
  column("value", "Column of the numbers (in tests of votes: of the names that were voted for)")
      ->expected(1);
  column("first", "Column of the first of two measurements or names")->expected(1);
  column("second", "Column of the second of two measurements or names")->expected(1);
  column("columns", "Columns of numbers, one row per participant (default: all columns)");
  column("count", "Column of the number of cases that a row represents")->expected(1);
  column("cluster", "Column that names the participant")->expected(1);
  column("round", "Column that names the round")->expected(1);
  command
      ->add_option(
          "--bound",
          options.settings.bound,
          "Equivalence margin: differences within ± this bound count as none")
      ->check(finiteRange(1e-300, 1e300));
  command->add_option(
      "--from",
      options.settings.from,
      "For the test answer_probability: lowest answer of interest; gives the probability of this "
      "answer or a higher one");
  command->add_option("--level", options.settings.level, "Level of the confidence interval")
      ->check(finiteRange(0.0001, 0.9999))
      ->capture_default_str();
  command->add_flag("--json", options.json, "Print JSON with full precision");
  command->parse_complete_callback([&options = options] {
    if (!options.isListRequested && options.test.empty()) throw CLI::RequiredError("TEST");
    if (!options.isListRequested && options.file.empty()) throw CLI::RequiredError("FILE");
  });
}

}  // namespace study::app
