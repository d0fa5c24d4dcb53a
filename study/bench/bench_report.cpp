#include "study/bench/bench_report.h"

#include <fmt/format.h>

#include "haptics/bench/machine.h"

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

}  // namespace study::app
