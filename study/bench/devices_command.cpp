// palpate-bench devices: both devices, emulated, on their links.
#include <algorithm>
#include <array>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "study/app/command_options.h"
#include "study/bench/bench_program.h"
#include "study/bench/devices.h"
#include "study/bench/print_result.h"

namespace study::bench {
namespace {

using haptics::devices::LinkReport;
using haptics::timing::LatenessHistogram;
using report::Chart;
using report::ChartSeries;

std::int64_t integer(std::uint64_t number) {
  return static_cast<std::int64_t>(number);
}

std::string nameOf(const LinkSeries& series) {
  return fmt::format("{}, {:.4g} Hz", series.device, series.rate);
}

std::uint64_t ticksOf(const LinkSeries& series) {
  std::uint64_t all = 0;
  for (const auto& run : series.runs) all += run.ticks;
  return all;
}

/// The processor time of this process in the longest run, with all loops that ran then, as a share
/// of one processor.
double processorShare(const LinkSeries& series) {
  const auto& run = series.longest();
  return run.processor / std::max(run.seconds, 1e-9);
}

DataTable timeTable(const std::vector<LinkSeries>& together) {
  DataTable table{
      .name = "times",
      .description = "Both devices at once: how long it took [µs]",
      .columns = {
          {"device", "Device"},
          {"what", "What"},
          {"count", "Count"},
          {"p50_us", "p50"},
          {"p99_us", "p99"},
          {"p999_us", "p99.9"},
          {"max_us", "Most"}}};
  for (const auto& series : together) {
    const auto& run = series.longest();
    const std::pair<const char*, const LatenessHistogram*> times[]{
        {"round trip", &run.link.roundTrip},
        {"tick", &run.loop.compute},
        {"tick, later than due", &run.loop.lateness}};
    for (const auto& [what, time] : times) {
      table.rows.push_back(
          {nameOf(series),
           what,
           integer(time->count()),
           time->quantile(0.5),
           time->quantile(0.99),
           time->quantile(0.999),
           time->largest()});
    }
  }
  return table;
}

/// A table of link statistics for several series.
DataTable sampleTable(
    const std::string& name, const std::string& caption, const std::vector<LinkSeries>& all) {
  DataTable table{
      .name = name,
      .description = caption,
      .columns = {
          {"device", "Device"},
          {"seconds", "For [s]"},
          {"sent", "Sent"},
          {"received", "Received"},
          {"lost", "Lost"},
          {"damaged", "Damaged"},
          {"skipped", "Skipped"},
          {"ticks", "Ticks"},
          {"stale", "… without a sample"},
          {"expired", "Orders expired"},
          {"faults", "Reconnected"},
          {"round_trip_p50_us", "Round trip, p50 [µs]"},
          {"round_trip_p99_us", "… p99"},
          {"processor", "Processor [share]"}}};
  for (const auto& series : all) {
    const auto& trip = series.longest().link.roundTrip;
    table.rows.push_back(
        {nameOf(series),
         series.seconds(),
         integer(series.sent),
         integer(series.sum(&LinkReport::received)),
         integer(series.sum(&LinkReport::lost)),
         integer(series.sum(&LinkReport::damaged)),
         integer(series.sum(&LinkReport::skipped)),
         integer(ticksOf(series)),
         integer(series.sum(&LinkReport::stale)),
         integer(series.sum(&LinkReport::expired)),
         series.faults(),
         trip.quantile(0.5),
         trip.quantile(0.99),
         processorShare(series)});
  }
  return table;
}

Chart timeChart(const std::vector<LinkSeries>& together) {
  constexpr std::array kQuantiles{0.5, 0.8, 0.9, 0.95, 0.99, 0.995, 0.999, 0.9999};
  Chart chart{
      .x = {.title = "time [µs]", .isLogarithmic = true},
      .y = {.title = "share that took longer", .isLogarithmic = true, .most = 1.0}};
  int colour = 0;
  for (const auto& series : together) {
    const auto& run = series.longest();
    for (const bool isTick : {false, true}) {
      ChartSeries line{
          .title = series.device + (isTick ? ", tick" : ", round trip"),
          .style = isTick ? ChartSeries::Style::Dashed : ChartSeries::Style::LineAndMarkers,
          .colour = colour};
      const auto& times = isTick ? run.loop.compute : run.link.roundTrip;
      for (const double q : kQuantiles) {
        line.points.push_back({std::max(times.quantile(q), 0.06), 1.0 - q});
      }
      chart.series.push_back(std::move(line));
    }
    ++colour;
  }
  return chart;
}

Chart roundTripChart(const std::vector<LinkSeries>& sweep) {
  Chart chart{
      .x = {.title = "rate [Hz]", .isLogarithmic = true},
      .y = {.title = "round trip [µs]", .isLogarithmic = true}};
  int colour = 0;
  for (const char* device : {"punch", "arm"}) {
    for (const double q : {0.5, 0.99}) {
      ChartSeries line{
          .title = fmt::format("{}, p{:g}", device, 100.0 * q),
          .style = q == 0.5 ? ChartSeries::Style::LineAndMarkers : ChartSeries::Style::Dashed,
          .colour = colour};
      for (const auto& series : sweep) {
        if (series.device != device) continue;
        line.points.push_back({series.rate, series.longest().link.roundTrip.quantile(q)});
      }
      chart.series.push_back(std::move(line));
    }
    ++colour;
  }
  return chart;
}

Cell medianOf(const std::vector<double>& values) {
  return values.empty() ? Cell() : Cell(quantile(values, 0.5));
}

DataTable stallTable(const std::vector<StallSeries>& stalls) {
  DataTable table{
      .name = "stalls",
      .description = "The loop stood still: what the device did",
      .columns = {
          {"device", "Device"},
          {"stall_ms", "For [ms]"},
          {"stalls", "Times"},
          {"force_n", "Force then [N], median"},
          {"let_go", "No force before its end"},
          {"let_go_ms", "… after [ms], median"},
          {"expired", "Orders expired"},
          {"disarmed", "Took no more forces"},
          {"faults", "Reconnected"}}};
  for (const auto& series : stalls) {
    table.rows.push_back(
        {series.link.device,
         series.duration,
         std::int64_t{series.stalls},
         medianOf(series.forces),
         static_cast<std::int64_t>(series.motorOffAfter.size()),
         medianOf(series.motorOffAfter),
         integer(series.link.sum(&LinkReport::expired)),
         std::int64_t{series.disarmed},
         series.link.faults()});
  }
  return table;
}

DataTable countTable(const std::vector<FaultCounts>& all) {
  DataTable table{
      .name = "counts",
      .description = "Faults on the wire: injected, and found",
      .columns = {
          {"device", "Device"},
          {"fault", "Fault"},
          {"injected", "Injected"},
          {"found", "Found"},
          {"repeated", "Hundreds that were done again"}}};
  for (const auto& counts : all) {
    for (std::size_t i = 0; i < FrameFaults::kNames.size(); ++i) {
      table.rows.push_back(
          {counts.device,
           std::string(FrameFaults::kNames[i]),
           counts.injected.of[i],
           counts.found.of[i],
           std::int64_t{counts.repeated}});
    }
  }
  return table;
}

report::Document reportOf(const DeviceMeasurement& measured) {
  report::Document document{
      .title = "Devices on their wires",
      .lead = {
          "A loop of this program and the emulators of both devices: no laboratory's "
          "hardware, no cable, no robot's controller. docs/benchmarks.md explains the parts."}};
  auto& parts = document.parts;
  if (!measured.together.empty()) {
    parts.push_back(
        {.heading = "Both devices at once",
         .figures =
             {{.name = "times",
               .caption = "Round trip and tick: the share that took longer.",
               .chart = timeChart(measured.together)}},
         .tables = {
             timeTable(measured.together),
             sampleTable("samples", "Both devices at once: samples", measured.together)}});
  }
  if (!measured.stalls.empty()) {
    parts.push_back(
        {.heading = "When the loop stands still", .tables = {stallTable(measured.stalls)}});
  }
  if (!measured.sweep.empty()) {
    parts.push_back(
        {.heading = "Rates",
         .figures =
             {{.name = "round-trip",
               .caption = "Round trip over rate.",
               .chart = roundTripChart(measured.sweep)}},
         .tables = {
             sampleTable("rates", "One device at a time, at several rates", measured.sweep)}});
  }
  if (!measured.counts.empty()) {
    parts.push_back({.heading = "Exact counts", .tables = {countTable(measured.counts)}});
  }
  return document;
}

struct DevicesOptions {
  std::string out;
  DeviceBenchOptions bench;
};

int benchDevices(const DevicesOptions& options) {
  const auto measured = measureDevices(options.bench);
  printAndWrite(options.out, "devices", reportOf(measured));
  if (!measured.isExact()) fmt::print("FAIL  not every fault was found, or too many were.\n");
  return measured.isExact() ? 0 : 1;
}

}  // namespace

void addDevicesCommand(CLI::App& program, Action& action) {
  auto [command, options] = app::addCommand(
      program,
      action,
      "devices",
      "Measure round trips, lost cycles and stalls of the emulated punch and arm on their "
      "interfaces",
      benchDevices);
  addOutFolder(*command, options.out);
  command->add_option("--seconds", options.bench.seconds, "Duration with both devices at once [s]")
      ->check(app::finiteRange(0.5, 36'000.0))
      ->capture_default_str();
  command
      ->add_option(
          "--faults", options.bench.faults, "Number of faults of each kind to inject and count")
      ->check(CLI::Range(1, 100'000))
      ->capture_default_str();
  const std::vector<std::string> parts(kDeviceBenchParts.begin(), kDeviceBenchParts.end());
  command
      ->add_option(
          "--part",
          options.bench.parts,
          "Parts to measure: both devices, stalls, other rates, counts of faults (default: all)")
      ->check(CLI::IsMember(parts));
}

}  // namespace study::bench
