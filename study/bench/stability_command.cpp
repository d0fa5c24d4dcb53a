// palpate-bench stability: stiff and extreme cases, each checked against a bound.
#include <algorithm>
#include <cstdio>
#include <map>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "haptics/bench/stability.h"
#include "haptics/engine/passivity.h"
#include "study/app/command_options.h"
#include "study/bench/bench_program.h"
#include "study/bench/print_result.h"

namespace study::bench {
namespace {

using haptics::bench::StabilityResult;
using haptics::bench::VirtualWall;
using report::Chart;
using report::ChartSeries;

DataTable summaryTable(const StabilityResult& result) {
  struct Count {
    std::string sweep;
    std::int64_t cases = 0;
    std::int64_t failed = 0;
  };
  std::vector<Count> counts;
  for (const auto& check : result.checks) {
    auto count =
        std::ranges::find_if(counts, [&](const auto& c) { return c.sweep == check.sweep; });
    if (count == counts.end()) count = counts.insert(counts.end(), {.sweep = check.sweep});
    ++count->cases;
    count->failed += check.isPassed() ? 0 : 1;
  }
  DataTable table{
      .name = "summary",
      .description = "Cases by sweep",
      .columns = {{"sweep", "Sweep"}, {"cases", "Cases"}, {"failed", "Failed"}}};
  for (const auto& count : counts) table.rows.push_back({count.sweep, count.cases, count.failed});
  return table;
}

/// All cases, for the CSV file.
DataTable checkTable(const StabilityResult& result) {
  DataTable table{
      .name = "checks",
      .columns = {
          {"sweep"}, {"what"}, {"arithmetic"}, {"parameter"}, {"measured"}, {"bound"}, {"passed"}}};
  for (const auto& check : result.checks) {
    table.rows.push_back(
        {check.sweep,
         check.what,
         check.build,
         check.parameter,
         numberCell(check.measured),
         check.bound,
         check.isPassed()});
  }
  return table;
}

/// All virtual walls, for the CSV file.
DataTable wallTable(const StabilityResult& result) {
  DataTable table{
      .name = "walls",
      .columns = {
          {"rate_hz"},
          {"stiffness"},
          {"damping"},
          {"encoder_quantum"},
          {"delay_ticks"},
          {"controlled"},
          {"stable"},
          {"foreseen_by_eq_25"},
          {"noticed_by_observer"},
          {"amplitude"}}};
  for (const auto& wall : result.walls) {
    table.rows.push_back(
        {wall.rate,
         wall.stiffness,
         wall.damping,
         wall.quantum,
         std::int64_t{wall.delay},
         wall.hasPassivityController,
         wall.isStable,
         wall.isPassivityUnproven,
         wall.isDetectedByObserver,
         finiteCell(wall.amplitude)});
  }
  return table;
}

/// How many walls vibrate, for each rate, encoder, delay and kind of control.
DataTable wallSummary(const StabilityResult& result) {
  DataTable table{
      .name = "walls-summary",
      .description = "Virtual walls: how many vibrate, by how they are rendered",
      .columns = {
          {"rate_hz", "Rate [Hz]"},
          {"encoder_quantum", "Encoder"},
          {"delay_ticks", "Delay [ticks]"},
          {"controlled", "Passivity control"},
          {"walls", "Walls"},
          {"vibrate", "Vibrate"},
          {"foreseen", "… foreseen by eq. (25)"},
          {"noticed", "… noticed by the observer"}}};
  using Rendering = std::tuple<double, double, int, bool>;
  std::map<Rendering, std::array<std::int64_t, 4>> counts;
  for (const auto& wall : result.walls) {
    auto& of = counts[{wall.rate, wall.quantum, wall.delay, wall.hasPassivityController}];
    ++of[0];
    if (wall.isStable) continue;
    ++of[1];
    of[2] += wall.isPassivityUnproven ? 1 : 0;
    of[3] += wall.isDetectedByObserver ? 1 : 0;
  }
  for (const auto& [rendering, of] : counts) {
    const auto& [rate, quantum, delay, hasPassivityController] = rendering;
    table.rows.push_back(
        {rate, quantum, std::int64_t{delay}, hasPassivityController, of[0], of[1], of[2], of[3]});
  }
  return table;
}

/// Stable walls at 1 kHz with an ideal encoder and no delay, and the bound of eq. (25).
Chart wallChart(const StabilityResult& result) {
  constexpr double kRate = 1000.0;
  Chart chart{
      .x = {.title = "K, stiffness of the wall [N/travel unit]", .isLogarithmic = true},
      .y = {.title = "b, damping of mechanism and hand [N·s/travel unit]", .isLogarithmic = true}};
  ChartSeries stable{.title = "stable", .style = ChartSeries::Style::Markers, .colour = 2};
  ChartSeries vibrates{.title = "vibrates", .style = ChartSeries::Style::Markers, .colour = 1};
  ChartSeries limit{
      .title = "b = K T / 2 (eq. 25)", .style = ChartSeries::Style::Dashed, .colour = 6};
  for (const auto& wall : result.walls) {
    const bool isShown = wall.rate == kRate && wall.quantum == 0.0 && wall.delay == 0 &&
                         !wall.hasPassivityController;
    if (!isShown) continue;
    (wall.isStable ? stable : vibrates).points.push_back({wall.stiffness, wall.damping});
  }
  for (const double damping : {0.01, 0.02, 0.05, 0.1, 0.2}) {
    const haptics::engine::Passivity passivity{.period = 1.0 / kRate};
    limit.points.push_back({passivity.allowedStiffness(damping), damping});
  }
  chart.series = {std::move(stable), std::move(vibrates), std::move(limit)};
  return chart;
}

/// The largest errors of chains of finite elements over their contrast.
Chart contrastChart(const StabilityResult& result) {
  Chart chart{
      .x = {.title = "d: stiffnesses log-uniform over 10^±d"},
      .y = {.title = "largest relative error of the stiffness", .isLogarithmic = true}};
  std::map<std::string, ChartSeries> series;
  for (const auto& check : result.checks) {
    if (check.elements != 5 && check.elements != 1000) continue;
    auto& line = series[check.what + ", " + check.build];
    line.style = ChartSeries::Style::LineAndMarkers;
    line.points.push_back({check.parameter, std::max(check.measured, 1e-17)});
  }
  for (auto& [title, line] : series) {
    line.title = title;
    chart.series.push_back(std::move(line));
  }
  return chart;
}

report::Document reportOf(const StabilityResult& result) {
  return {
      .title = "Stability in extreme cases",
      .lead = {"Each case has a bound that was stated before. All sweeps are seeded: the same "
               "program gives the same table. docs/benchmarks.md explains the sweeps."},
      .parts = {
          {.heading = "Sweeps", .tables = {summaryTable(result), checkTable(result)}},
          {.heading = "Finite elements of very different stiffness",
           .figures =
               {{.name = "contrast",
                 .caption = "Largest relative error over the contrast.",
                 .chart = contrastChart(result)}}},
          {.heading = "A hand on a virtual wall (Z-width)",
           .figures =
               {{.name = "walls",
                 .caption = "1 kHz. Left of the dashed line every wall is stable.",
                 .chart = wallChart(result)}},
           .tables = {wallSummary(result), wallTable(result)}}}};
}

struct StabilityOptions {
  std::string out;
  double effort = 1.0;
};

int stability(const StabilityOptions& options) {
  const auto result = haptics::bench::runStability(options.effort, [](const std::string& sweep) {
    std::fprintf(stderr, "%s\n", sweep.c_str());
  });
  printAndWrite(options.out, "stability", reportOf(result));
  int failed = 0;
  for (const auto& check : result.checks) {
    if (check.isPassed()) continue;
    ++failed;
    fmt::print(
        "FAIL  {}: {} ({}, at {:g}): {:g}, at most {:g}\n",
        check.sweep,
        check.what,
        check.build.empty() ? "engine" : check.build,
        check.parameter,
        check.measured,
        check.bound);
  }
  if (haptics::bench::fusedKernels() == nullptr) {
    fmt::print("This processor has no fused multiply-add: the cases with it were left out.\n");
  }
  fmt::print("{} cases, {} failed.\n", result.checks.size(), failed);
  return failed == 0 ? 0 : 1;
}

}  // namespace

void addStabilityCommand(CLI::App& program, Action& action) {
  auto [command, options] = app::addCommand(
      program,
      action,
      "stability",
      "Check the stability of stiff and extreme cases, each against a bound",
      stability);
  addOutFolder(*command, options.out);
  command
      ->add_option(
          "--effort",
          options.effort,
          "Number of random cases relative to the usual number; less than 1 is faster")
      ->check(app::finiteRange(0.001, 100.0))
      ->capture_default_str();
}

}  // namespace study::bench
