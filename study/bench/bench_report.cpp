#include "study/bench/bench_report.h"

#include <filesystem>

#include <fmt/format.h>

#include "haptics/bench/machine.h"
#include "study/app/paint_figures.h"
#include "study/model/new_file.h"

namespace study::app {

DataTable machineTable() {
  DataTable table{
      .name = "machine",
      .description = "What this was measured with",
      .columns = {{"what", "What"}, {"value", "Here"}}};
  for (auto& [what, value] : haptics::bench::machineInWords()) table.rows.push_back({what, value});
  return table;
}

DataTable targetTable(const std::vector<Target>& targets) {
  DataTable table{
      .name = "targets",
      .description = "Targets",
      .columns = {
          {"target", "Target"},
          {"what", "What"},
          {"measured", "Measured"},
          {"wanted", "Wanted"},
          {"reached", "Reached"}}};
  for (const auto& target : targets) {
    std::string wanted = target.isAtMost ? "≤ " : "≥ ";
    char text[32];
    std::snprintf(text, sizeof text, "%g", target.wanted);
    table.rows.push_back(
        {target.id, target.what, target.measured, wanted + text, target.isReached()});
  }
  return table;
}

void printTargets(const std::vector<Target>& targets) {
  fmt::print("\n  {:<15} {:<58} {:>10}   {}\n", "", "", "measured", "wanted");
  for (const auto& target : targets) {
    fmt::print(
        "  {:<15} {:<58} {:>10.3g}   {} {:<8g} {}\n",
        target.id,
        target.what,
        target.measured,
        target.isAtMost ? "≤" : "≥",
        target.wanted,
        target.isReached() ? "" : "not reached here");
  }
}

void writeDocument(const std::string& folder, const std::string& name, report::Document document) {
  paintFigures(document);
  std::filesystem::create_directories(folder);
  const std::filesystem::path base(folder);
  for (const auto& part : document.parts) {
    for (const auto& table : part.tables) {
      writeNewFile((base / (name + "-" + table.name + ".csv")).string(), asCsv(table));
    }
    for (const auto& figure : part.figures) {
      if (figure.svg.empty()) continue;
      writeNewFile((base / (name + "-" + figure.name + ".svg")).string(), figure.svg);
    }
  }
  writeNewFile((base / (name + ".html")).string(), report::asHtml(document));
}

}  // namespace study::app
