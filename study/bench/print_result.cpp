#include "study/bench/print_result.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "base/text_table.h"
#include "haptics/bench/measurement.h"
#include "study/app/write_report.h"

namespace study::bench {
namespace {

DataTable machineTable() {
  DataTable table{
      .name = "machine",
      .description = "The computer",
      .columns = {{"what", "What"}, {"value", "Value"}}};
  for (auto& [what, value] : haptics::bench::describeMachine()) table.rows.push_back({what, value});
  return table;
}

}  // namespace

void addOutFolder(CLI::App& command, std::string& folder, const std::string& contents) {
  command
      .add_option(
          "--out",
          folder,
          "Folder for " + contents + " and an HTML page (default: only print the tables)")
      ->type_name("FOLDER");
}

Cell numberCell(const std::optional<double>& value) {
  if (value && !std::isfinite(*value)) return std::string("no number");
  return cellOf(value);
}

double quantile(std::vector<double> values, double q) {
  std::ranges::sort(values);
  const auto place = static_cast<std::size_t>(q * static_cast<double>(values.size()));
  return values.at(std::min(place, values.size() - 1));
}

std::string asPlainText(const DataTable& table) {
  std::vector<std::vector<std::string>> lines(1);
  for (const auto& column : table.columns) lines.front().push_back(column.description);
  for (const auto& row : table.rows) {
    lines.emplace_back();
    for (const auto& cell : row) lines.back().push_back(textOfCell(cell));
  }
  std::vector<std::size_t> widths(table.columns.size());
  for (const auto& line : lines) {
    for (std::size_t i = 0; i < line.size(); ++i)
      widths[i] = std::max(widths[i], base::characterCount(line[i]));
  }
  std::string text;
  for (const auto& line : lines) {
    std::string padded;
    for (std::size_t i = 0; i < line.size(); ++i) {
      padded += "  " + line[i] + std::string(widths[i] - base::characterCount(line[i]), ' ');
    }
    text += padded.substr(0, padded.find_last_not_of(' ') + 1) + "\n";
  }
  return text;
}

void printAndWrite(const std::string& folder, const std::string& name, report::Document document) {
  for (const auto& part : document.parts) {
    for (const auto& table : part.tables) {
      if (table.description.empty()) continue;
      fmt::print("\n{}\n{}", table.description, asPlainText(table));
    }
  }
  std::fflush(stdout);  // so that the table is printed even if a file cannot be written
  if (folder.empty()) {
    fmt::print("\nNothing was written. Add --out FOLDER for tables, figures and a page.\n");
    return;
  }
  document.parts.push_back({.heading = "The computer", .tables = {machineTable()}});
  app::writeDocument(folder, name, std::move(document));
  fmt::print("\n{}/{}.html holds tables and figures.\n", folder, name);
}

}  // namespace study::bench
