// What `palpate bench servo` makes of its runs.
#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "haptics/engine/passivity.h"
#include "study/bench/bench_report.h"

namespace study::app {
namespace {

using haptics::bench::ServoRun;
using report::Chart;
using report::ChartSeries;

constexpr std::array kQuantiles{
    0.5, 0.6, 0.7, 0.8, 0.9, 0.95, 0.98, 0.99, 0.995, 0.998, 0.999, 0.9995, 0.9999};

DataTable runTable(const ServoMeasurement& measured) {
  DataTable table{
      .name = "loop",
      .description = "How late ticks were [µs], each with 20 µs of work",
      .columns = {
          {"rate_hz", "Rate [Hz]"},
          {"mode", "Mode"},
          {"granted", "Real time granted"},
          {"ticks", "Ticks"},
          {"p50_us", "p50"},
          {"p99_us", "p99"},
          {"p999_us", "p99.9"},
          {"max_us", "Latest"},
          {"own_p50_us", "p50 without holes"},
          {"own_p99_us", "p99 without holes"},
          {"late_ticks", "Ticks a period late"},
          {"late_ticks_own", "… not by a hole"},
          {"holes", "Holes"},
          {"longest_hole_us", "Longest hole"},
          {"compute_p99_us", "Tick itself, p99"},
          {"passive_stiffness", "Passive K of the punch [N/unit]"}}};
  for (const auto& run : measured.runs) {
    const auto& r = run.report;
    const haptics::engine::Passivity passivity{
        .period = 1.0 / run.rate, .lateness = 1e-6 * r.lateness.quantile(0.999)};
    constexpr double kPunch = 0.05;  // damping of the simulated punch
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
         static_cast<std::int64_t>(r.lateTicksOfOurs),
         static_cast<std::int64_t>(r.holes),
         r.longestHole,
         r.compute.quantile(0.99),
         passivity.allowedStiffness(kPunch)});
  }
  return table;
}

/// The share of ticks that is later than so much.
Chart latenessChart(const ServoMeasurement& measured, double rate) {
  Chart chart{
      .x = {.title = "lateness [µs]", .isLogarithmic = true},
      .y = {.title = "share of ticks that are later", .isLogarithmic = true, .most = 1.0}};
  for (const auto& run : measured.runs) {
    if (run.rate != rate) continue;
    ChartSeries all{.title = run.mode, .style = ChartSeries::Style::LineAndMarkers};
    for (const double q : kQuantiles) {
      all.points.push_back({std::max(run.report.lateness.quantile(q), 0.06), 1.0 - q});
    }
    chart.series.push_back(std::move(all));
  }
  return chart;
}

DataTable recorderTable(const ServoMeasurement& measured) {
  DataTable table{
      .name = "recorder",
      .description = "Keeping a thousand samples at a time, safe on the disk each time",
      .columns = {
          {"way", "Way"},
          {"samples_per_s", "Samples a second"},
          {"bytes_per_sample", "Bytes a sample"},
          {"worst_ms", "Worst call [ms]"}}};
  for (const auto& run : measured.recorders) {
    table.rows.push_back({run.way, run.samplesPerSecond, run.bytesPerSample, run.worstCall});
  }
  return table;
}

}  // namespace

std::vector<Target> servoTargets(const ServoMeasurement& measured) {
  std::vector<Target> targets;
  for (const auto& run : measured.runs) {
    const bool isJudged = run.mode == "real-time" && run.rate <= 4000.0;
    if (!isJudged) continue;
    const auto& r = run.report;
    const auto at = fmt::format("{:g} Hz, real-time, without holes", run.rate);
    targets.push_back({"lateness", at + ": p50 [µs]", r.ownLateness.quantile(0.5), 30.0, true});
    targets.push_back({"lateness", at + ": p99 [µs]", r.ownLateness.quantile(0.99), 65.0, true});
    targets.push_back(
        {"lateness", at + ": ticks missed", static_cast<double>(r.lateTicksOfOurs), 0.0, true});
  }
  if (measured.recorders.empty()) return targets;
  const auto& ours = measured.recorders.front();
  const auto& raw = measured.recorders.back();
  targets.push_back(
      {"recorder", "samples a second, in millions", ours.samplesPerSecond / 1e6, 1.0});
  targets.push_back({"recorder", "bytes a sample", ours.bytesPerSample, 66.0, true});
  targets.push_back(
      {"recorder",
       "of a raw file's samples a second",
       ours.samplesPerSecond / raw.samplesPerSecond,
       0.35});
  const auto& loop = measured.loop;
  targets.push_back({"recorder", "in the loop, p99.9 [µs]", loop.push.quantile(0.999), 2.0, true});
  targets.push_back(
      {"recorder",
       fmt::format("samples lost in {:.0f} s", loop.seconds),
       static_cast<double>(loop.ticks - loop.kept),
       0.0,
       true});
  return targets;
}

report::Document servoReport(const ServoMeasurement& measured) {
  report::DocumentPart clock{
      .heading = "The clock",
      .paragraphs =
          {"The loop sleeps to absolute times. Real-time means SCHED_FIFO 80, locked memory and a "
           "timer slack of 1 ns where they are granted; spinning means that the last twentieth of "
           "a "
           "period is spun. A hole is lateness that our thread did not spend waiting for a "
           "processor (/proc/thread-self/schedstat): the machine below us stood still. Missed "
           "ticks are those a whole period late.",
           "This is soft real time: so many ticks within so many microseconds, on this machine, "
           "today."},
      .tables = {runTable(measured)}};
  for (const double rate : {1000.0, 4000.0}) {
    const bool isThere = std::any_of(
        measured.runs.begin(), measured.runs.end(), [&](const auto& r) { return r.rate == rate; });
    if (!isThere) continue;
    clock.figures.push_back(
        {.name = fmt::format("lateness-{:g}", rate),
         .caption = fmt::format("How late ticks are at {:g} Hz.", rate),
         .chart = latenessChart(measured, rate)});
  }
  const auto& loop = measured.loop;
  return {
      .title = "Clock and recorder",
      .lead = {"How punctually the force loop ticks on this computer, and what recording costs."},
      .parts = {
          {.heading = "Machine and targets",
           .tables = {machineTable(), targetTable(servoTargets(measured))}},
          std::move(clock),
          {.heading = "The recorder",
           .paragraphs =
               {"A sample is 28 bytes: tick, travel, velocity, force asked for and commanded, "
                "lateness, four flags. Chunks of a second go into SQLite with "
                "synchronous=FULL, in turn with their peers on the same disk.",
                fmt::format(
                    "In a loop of 1 kHz over {:.0f} s, handing a sample to the recorder took "
                    "{:.2f} "
                    "µs (median), {:.2f} (p99.9), {:.1f} at most; of {} samples {} were kept and "
                    "{} "
                    "lost in the ring.",
                    loop.seconds,
                    loop.push.quantile(0.5),
                    loop.push.quantile(0.999),
                    loop.push.largest(),
                    loop.ticks,
                    loop.kept,
                    loop.lost)},
           .tables = {recorderTable(measured)}}}};
}

}  // namespace study::app
