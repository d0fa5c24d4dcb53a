// palpate-bench servo: the lateness of the force loop, and the cost of recording in it.
#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <thread>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "haptics/engine/passivity.h"
#include "haptics/engine/realtime_loop.h"
#include "study/app/command_options.h"
#include "study/bench/bench_program.h"
#include "study/bench/print_result.h"
#include "study/bench/recorder.h"

namespace study::bench {
namespace {

using report::Chart;
using report::ChartSeries;

struct ServoOptions {
  std::string out;
  std::string disk = ".";
  std::vector<double> rates{1000.0, 2000.0, 4000.0, 8000.0};
  double seconds = 4.0;
  double recording = 20.0;
};

/// How a loop is scheduled.
struct ServoMode {
  std::string name;
  bool requestsRealtime = false;
  double spinning = 0.0;  ///< share of the period during which the loop spins before a tick
};

struct ServoRun {
  std::string mode;
  double rate = 0.0;        ///< [Hz]
  bool isRealtime = false;  ///< whether the loop had real-time priority
  haptics::engine::RealtimeLoop::Report report;
};

/// Three modes: normal scheduling; real-time priority with locked memory and no timer slack; and
/// the second mode with spinning.
std::vector<ServoMode> servoModes() {
  return {
      {"as any program", false, 0.0},
      {"real-time", true, 0.0},
      {"real-time, spinning", true, 0.05}};
}

/// Runs the loop for @p seconds [s], with 20 µs of work in each tick.
ServoRun runServo(const ServoMode& mode, double rate, double seconds) {
  using Steady = std::chrono::steady_clock;
  constexpr std::chrono::microseconds kWork{20};
  haptics::engine::RealtimeLoop loop(
      {.rate = rate, .spinning = mode.spinning, .requestsRealtime = mode.requestsRealtime},
      [&](double, double) {
        const auto until = Steady::now() + kWork;
        while (Steady::now() < until) {
        }
      });
  std::this_thread::sleep_for(std::chrono::duration<double>(seconds));
  const bool isRealtime = loop.isRealtime();
  return {.mode = mode.name, .rate = rate, .isRealtime = isRealtime, .report = loop.finish()};
}

DataTable runTable(const std::vector<ServoRun>& runs) {
  DataTable table{
      .name = "loop",
      .description = "How late ticks were [µs], each with 20 µs of work",
      .columns = {
          {"rate_hz", "Rate [Hz]"},
          {"mode", "Mode"},
          {"granted", "Granted"},
          {"ticks", "Ticks"},
          {"p50_us", "p50"},
          {"p99_us", "p99"},
          {"p999_us", "p99.9"},
          {"max_us", "Latest"},
          {"own_p50_us", "p50 without host pauses"},
          {"own_p99_us", "p99 without host pauses"},
          {"late_ticks", "A period late"},
          {"late_ticks_own", "… not by a host pause"},
          {"holes", "Host pauses"},
          {"longest_hole_us", "Longest host pause"},
          {"passive_stiffness", "Passive K of the punch [N/unit]"}}};
  for (const auto& run : runs) {
    const auto& r = run.report;
    const haptics::engine::Passivity passivity{
        .period = 1.0 / run.rate, .lateness = 1e-6 * r.lateness.quantile(0.999)};
    constexpr double kPunch = 0.05;  // damping of the simulated punch [N·s/travel unit]
    table.rows.push_back(
        {run.rate,
         run.mode,
         run.isRealtime,
         static_cast<std::int64_t>(r.ticks),
         r.lateness.quantile(0.5),
         r.lateness.quantile(0.99),
         r.lateness.quantile(0.999),
         r.lateness.largest(),
         r.ownLateness.quantile(0.5),
         r.ownLateness.quantile(0.99),
         static_cast<std::int64_t>(r.lateTicks),
         static_cast<std::int64_t>(r.ownLateTicks),
         static_cast<std::int64_t>(r.hostPauses),
         r.longestHostPause,
         passivity.allowedStiffness(kPunch)});
  }
  return table;
}

/// The share of ticks with a lateness above x, at @p rate [Hz].
Chart latenessChart(const std::vector<ServoRun>& runs, double rate) {
  constexpr std::array kQuantiles{0.5, 0.8, 0.9, 0.95, 0.99, 0.995, 0.999, 0.9999};
  Chart chart{
      .x = {.title = "lateness [µs]", .isLogarithmic = true},
      .y = {.title = "share of ticks that are later", .isLogarithmic = true, .most = 1.0}};
  for (const auto& run : runs) {
    if (run.rate != rate) continue;
    ChartSeries all{.title = run.mode, .style = ChartSeries::Style::LineAndMarkers};
    for (const double q : kQuantiles) {
      all.points.push_back({std::max(run.report.lateness.quantile(q), 0.06), 1.0 - q});
    }
    chart.series.push_back(std::move(all));
  }
  return chart;
}

DataTable recorderTable(const std::vector<RecorderRun>& recorders, const RecorderLoop& loop) {
  DataTable table{
      .name = "recorder",
      .description = "Recording: a thousand samples at a time, each time safe on the disk",
      .columns = {
          {"way", "Way"},
          {"samples_per_s", "Samples a second"},
          {"bytes_per_sample", "Bytes a sample"},
          {"worst_ms", "Worst call [ms]"},
          {"push_p50_us", "In the tick, p50 [µs]"},
          {"push_p999_us", "… p99.9 [µs]"},
          {"lost", "Samples lost"}}};
  for (const auto& run : recorders) {
    table.rows.push_back(
        {run.method, run.samplesPerSecond, run.bytesPerSample, run.worstCall, {}, {}, {}});
  }
  table.rows.push_back(
      {fmt::format("in a loop of 1 kHz over {:.0f} s", loop.seconds),
       {},
       {},
       {},
       loop.push.quantile(0.5),
       loop.push.quantile(0.999),
       static_cast<std::int64_t>(loop.ticks - loop.kept)});
  return table;
}

int servo(const ServoOptions& options) {
  std::vector<ServoRun> runs;
  for (const double rate : options.rates) {
    for (const auto& mode : servoModes()) {
      std::fprintf(stderr, "%g Hz, %s\n", rate, mode.name.c_str());
      runs.push_back(runServo(mode, rate, options.seconds));
    }
  }
  std::fprintf(stderr, "recorder, %g s in all\n", options.recording + options.seconds);
  const auto recorders = compareRecorders(options.disk, options.seconds);
  const auto loop = recordInLoop(options.disk, 1000.0, options.recording);
  const double rate = options.rates.front();
  printAndWrite(
      options.out,
      "servo",
      {.title = "Clock and recorder",
       .lead = {"How punctually the force loop ticks on this computer, and what recording costs. "
                "docs/benchmarks.md explains the columns."},
       .parts = {
           {.heading = "The clock",
            .figures =
                {{.name = "lateness",
                  .caption = fmt::format("How late ticks are at {:g} Hz.", rate),
                  .chart = latenessChart(runs, rate)}},
            .tables = {runTable(runs)}},
           {.heading = "The recorder", .tables = {recorderTable(recorders, loop)}}}});
  if (!runs.back().isRealtime) {
    fmt::print(
        "\nReal-time priority was not granted: the loop ran as any program. An administrator "
        "grants it in /etc/security/limits.conf (rtprio 80, memlock unlimited).\n");
  }
  return 0;
}

}  // namespace

void addServoCommand(CLI::App& program, Action& action) {
  auto [command, options] = app::addCommand(
      program,
      action,
      "servo",
      "Measure the timing of the force loop on this computer, and the cost of recording",
      servo);
  addOutFolder(*command, options.out);
  command
      ->add_option(
          "--disk", options.disk, "Folder on the disk to measure, where studies are stored")
      ->check(CLI::ExistingDirectory)
      ->capture_default_str();
  command->add_option("--rates", options.rates, "Rates of the force loop to measure [Hz]")
      ->check(app::finiteRange(1.0, 10'000.0))
      ->capture_default_str();
  command
      ->add_option(
          "--seconds",
          options.seconds,
          "Duration at each rate in each of three modes: normal, real-time, real-time with "
          "spinning [s]")
      ->check(app::finiteRange(0.1, 3600.0))
      ->capture_default_str();
  command->add_option("--recording", options.recording, "Duration of the run that is recorded [s]")
      ->check(app::finiteRange(0.1, 36'000.0))
      ->capture_default_str();
}

}  // namespace study::bench
