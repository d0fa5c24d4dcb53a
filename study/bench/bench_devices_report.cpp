// What `palpate bench devices` makes of its runs.
#include <algorithm>
#include <array>
#include <cstdlib>
#include <set>

#include <fmt/format.h>

#include "study/bench/bench_devices.h"

namespace study::app {
namespace {

using haptics::devices::LinkReport;
using haptics::timing::LatenessHistogram;
using report::Chart;
using report::ChartSeries;

constexpr std::array kQuantiles{
    0.5, 0.6, 0.7, 0.8, 0.9, 0.95, 0.98, 0.99, 0.995, 0.998, 0.999, 0.9995, 0.9999};

std::int64_t integer(std::uint64_t number) {
  return static_cast<std::int64_t>(number);
}

std::uint64_t ticksOf(const LinkSeries& series) {
  std::uint64_t all = 0;
  for (const auto& run : series.runs) all += run.ticks;
  return all;
}

std::uint64_t lostBeatsOf(const LinkSeries& series) {
  std::uint64_t all = 0;
  for (const auto& run : series.runs) all += run.lostBeats;
  return all;
}

double staleShare(const LinkSeries& series) {
  const auto ticks = static_cast<double>(std::max<std::uint64_t>(ticksOf(series), 1));
  return static_cast<double>(series.sum(&LinkReport::stale)) / ticks;
}

double perSecond(std::uint64_t count, const LinkSeries& series) {
  return static_cast<double>(count) / std::max(series.seconds(), 1e-9);
}

double processorShare(const LinkSeries& series) {
  const auto& run = series.longest();
  return run.processor / std::max(run.seconds, 1e-9);
}

std::string nameOf(const LinkSeries& series) {
  return fmt::format("{}, {:.4g} Hz", series.device, series.rate);
}

/// Each once, in a row.
std::string inWords(const std::vector<std::string>& all) {
  std::string words;
  for (const auto& one : std::set<std::string>(all.begin(), all.end())) {
    words += (words.empty() ? "" : "; ") + one;
  }
  return words;
}

DataTable timeTable(const DeviceMeasurement& measured) {
  DataTable table{
      .name = "times",
      .description = "How long it took [µs]",
      .columns = {
          {"device", "Device"},
          {"what", "What"},
          {"count", "Count"},
          {"p50_us", "p50"},
          {"p99_us", "p99"},
          {"p999_us", "p99.9"},
          {"max_us", "Most"}}};
  for (const auto& series : measured.together) {
    const auto& run = series.longest();
    const std::pair<const char*, const LatenessHistogram*> times[]{
        {"round trip", &run.link.roundTrip},
        {"tick", &run.loop.compute},
        {"beat, later than due", &run.loop.lateness}};
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

/// A column for each device.
DataTable cycleTable(const DeviceMeasurement& measured) {
  using Counts = std::uint64_t LinkReport::*;
  constexpr std::pair<const char*, Counts> kCounts[]{
      {"Samples", &LinkReport::received},
      {"… lost on the way", &LinkReport::lost},
      {"… doubled", &LinkReport::doubled},
      {"… overtaken by another (late)", &LinkReport::late},
      {"… damaged", &LinkReport::damaged},
      {"… skipped, since we were late", &LinkReport::skipped},
      {"… over a connection too poor for a force", &LinkReport::poor},
      {"Ticks without a new sample (stale)", &LinkReport::stale},
      {"Answers that found no room", &LinkReport::unsent},
      {"It let go since we were late", &LinkReport::expired}};
  DataTable table{
      .name = "cycles",
      .description = "What has come, and what has not",
      .columns = {{"what", "What"}}};
  for (const auto& series : measured.together) {
    table.columns.push_back({series.device, nameOf(series)});
  }
  const auto add = [&](const char* what, auto valueOf) {
    std::vector<Cell> row{std::string(what)};
    for (const auto& series : measured.together) row.push_back(valueOf(series));
    table.rows.push_back(std::move(row));
  };
  add("Ticked for [s]", [](const LinkSeries& s) { return Cell(s.seconds()); });
  add("Real-time priority for us",
      [](const LinkSeries& s) { return Cell(s.longest().isRealtime); });
  add("Real-time priority for the stand-in",
      [](const LinkSeries& s) { return Cell(s.isDeviceUrgent); });
  add("Ticks", [](const LinkSeries& s) { return Cell(integer(ticksOf(s))); });
  for (const auto& [what, count] : kCounts) {
    add(what, [of = count](const LinkSeries& s) { return Cell(integer(s.sum(of))); });
  }
  add("From arming to the first tick, at most [ms]", [](const LinkSeries& s) {
    double most = 0.0;
    for (const auto& run : s.runs) most = std::max(most, 1e3 * run.begunAfter);
    return Cell(most);
  });
  add("Beats lost", [](const LinkSeries& s) { return Cell(integer(lostBeatsOf(s))); });
  add("Longest hole of the machine [µs]",
      [](const LinkSeries& s) { return Cell(s.longest().loop.longestHole); });
  add("Failed, and connected anew",
      [](const LinkSeries& s) { return Cell(static_cast<std::int64_t>(s.faults().size())); });
  add("Processor time of this program, both loops [share of one]",
      [](const LinkSeries& s) { return Cell(processorShare(s)); });
  return table;
}

ChartSeries distribution(const std::string& title, const LatenessHistogram& times, bool isDashed) {
  ChartSeries series{
      .title = title,
      .style = isDashed ? ChartSeries::Style::Dashed : ChartSeries::Style::LineAndMarkers};
  for (const double q : kQuantiles) {
    series.points.push_back({std::max(times.quantile(q), 0.06), 1.0 - q});
  }
  return series;
}

Chart timeChart(const DeviceMeasurement& measured) {
  Chart chart{
      .x = {.title = "time [µs]", .isLogarithmic = true},
      .y = {.title = "share that took longer", .isLogarithmic = true, .most = 1.0}};
  int colour = 0;
  for (const auto& series : measured.together) {
    const auto& run = series.longest();
    chart.series.push_back(distribution(series.device + ", round trip", run.link.roundTrip, false));
    chart.series.back().colour = colour;
    chart.series.push_back(distribution(series.device + ", tick", run.loop.compute, true));
    chart.series.back().colour = colour++;
  }
  return chart;
}

Cell medianOf(std::vector<double> values) {
  if (values.empty()) return {};
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

DataTable stallTable(const DeviceMeasurement& measured) {
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
          {"expired", "Expiries told"},
          {"disarmed", "Took no more forces"},
          {"faults", "Connected anew"}}};
  for (const auto& series : measured.stalls) {
    table.rows.push_back(
        {series.link.device,
         series.duration,
         std::int64_t{series.stalls},
         medianOf(series.forces),
         static_cast<std::int64_t>(series.letGoAfter.size()),
         medianOf(series.letGoAfter),
         integer(series.link.sum(&LinkReport::expired)),
         std::int64_t{series.disarmed},
         static_cast<std::int64_t>(series.link.faults().size())});
  }
  return table;
}

DataTable stallCountTable(const DeviceMeasurement& measured) {
  DataTable table{
      .name = "stall-counts",
      .description = "The loop stood still: what we counted",
      .columns = {
          {"device", "Device"},
          {"stall_ms", "For [ms]"},
          {"beats_lost", "Beats lost"},
          {"skipped", "Samples skipped"},
          {"injected_drop", "Dropped"},
          {"found_drop", "… found"},
          {"injected_double", "Doubled"},
          {"found_double", "… found"},
          {"injected_reorder", "Reordered"},
          {"found_reorder", "… found"}}};
  for (const auto& series : measured.stalls) {
    std::vector<Cell> row{
        series.link.device,
        series.duration,
        integer(lostBeatsOf(series.link)),
        integer(series.link.sum(&LinkReport::skipped))};
    for (std::size_t i = 0; i < 3; ++i) {
      row.emplace_back(series.injected.of[i]);
      row.emplace_back(series.found.of[i]);
    }
    table.rows.push_back(std::move(row));
  }
  return table;
}

/// In whose words it ended.
DataTable wordTable(const DeviceMeasurement& measured) {
  DataTable table{
      .name = "stall-words",
      .description = "What was said of it",
      .columns = {
          {"device", "Device"},
          {"stall_ms", "For [ms]"},
          {"we", "By us", true},
          {"it", "By the arm's controller", true}}};
  for (const auto& series : measured.stalls) {
    const auto faults = series.link.faults();
    if (faults.empty() && series.ends.empty()) continue;
    table.rows.push_back(
        {series.link.device, series.duration, inWords(faults), inWords(series.ends)});
  }
  return table;
}

DataTable rateTable(const DeviceMeasurement& measured) {
  DataTable table{
      .name = "rates",
      .description = "One device at a time, at several rates",
      .columns = {
          {"device", "Device"},
          {"rate_hz", "Rate [Hz]"},
          {"sent_per_s", "Made [1/s]"},
          {"received_per_s", "Received [1/s]"},
          {"round_trip_p50_us", "Round trip, p50 [µs]"},
          {"round_trip_p99_us", "… p99"},
          {"stale_share", "Stale [share]"},
          {"skipped", "Skipped"},
          {"faults", "Connected anew"},
          {"processor", "Processor [share]"}}};
  for (const auto& series : measured.sweep) {
    const auto& trip = series.longest().link.roundTrip;
    table.rows.push_back(
        {series.device,
         series.rate,
         perSecond(series.sent, series),
         perSecond(series.sum(&LinkReport::received), series),
         trip.quantile(0.5),
         trip.quantile(0.99),
         staleShare(series),
         integer(series.sum(&LinkReport::skipped)),
         static_cast<std::int64_t>(series.faults().size()),
         processorShare(series)});
  }
  return table;
}

/// @p valueOf a series, over its rate; a line for each device.
template <typename ValueOf>
void addOverRate(
    const DeviceMeasurement& measured,
    const std::string& what,
    ChartSeries::Style style,
    ValueOf valueOf,
    Chart& chart) {
  int colour = 0;
  for (const char* device : {"punch", "arm"}) {
    ChartSeries line{.title = device + what, .style = style, .colour = colour++};
    for (const auto& series : measured.sweep) {
      if (series.device == device) line.points.push_back({series.rate, valueOf(series)});
    }
    chart.series.push_back(std::move(line));
  }
}

Chart roundTripChart(const DeviceMeasurement& measured) {
  Chart chart{
      .x = {.title = "rate [Hz]", .isLogarithmic = true},
      .y = {.title = "round trip [µs]", .isLogarithmic = true}};
  const auto quantile = [](double q) {
    return [q](const LinkSeries& s) { return s.longest().link.roundTrip.quantile(q); };
  };
  using Style = ChartSeries::Style;
  addOverRate(measured, ", median", Style::LineAndMarkers, quantile(0.5), chart);
  addOverRate(measured, ", 99 of 100", Style::Dashed, quantile(0.99), chart);
  return chart;
}

Chart processorChart(const DeviceMeasurement& measured) {
  Chart chart{
      .x = {.title = "rate [Hz]", .isLogarithmic = true},
      .y = {.title = "of one processor", .least = 0.0}};
  addOverRate(measured, "", ChartSeries::Style::LineAndMarkers, processorShare, chart);
  return chart;
}

DataTable countTable(const DeviceMeasurement& measured) {
  DataTable table{
      .name = "counts",
      .description = "Faults on the wire: injected, and found",
      .columns = {
          {"device", "Device"},
          {"fault", "Fault"},
          {"injected", "Injected"},
          {"found", "Found"},
          {"repeated", "Hundreds that were done again"}}};
  for (const auto& counts : measured.counts) {
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

report::DocumentPart togetherPart(const DeviceMeasurement& measured) {
  return {
      .heading = "Both devices at once",
      .paragraphs =
          {"Two loops of this program, each at the pace of its device; two stand-ins, each a "
           "process of its own: the punch on a pseudo-terminal, the arm on UDP over loopback. They "
           "have real-time priority above ours where it is granted, since a board does not wait "
           "for a processor. The hand feels springs in a row on the one and bone on the other.",
           "The round trip is from our answer to the arrival of the sample that has seen it: a "
           "period of the device and a little, by design. A tick reads, renders, limits and "
           "answers. Samples that came together with a newer one, after we had been late, are "
           "skipped: received, not acted upon. Quantiles are of the longest stretch without a "
           "fault, counts of all."},
      .figures =
          {{.name = "times",
            .caption = "Round trip and tick: the share that took longer.",
            .chart = timeChart(measured)}},
      .tables = {timeTable(measured), cycleTable(measured)}};
}

report::DocumentPart stallPart(const DeviceMeasurement& measured) {
  return {
      .heading = "When we stand still",
      .paragraphs =
          {"The loop (of the punch at 1000 Hz, of the arm at 200) was made to sleep in a tick, "
           "about once in two seconds, as soon as a force began to fall. Shortly before each stall "
           "one frame was dropped, one doubled, and one changed "
           "places with the next. What the device did was asked of its stand-in, every "
           "millisecond or so; after a fault it was connected anew, as an operator would.",
           "The punch lets go when its last order expires (10 ms), by its slew in another 10 ms "
           "at most; after 40 ms of silence it disarms. The arm keeps the last force until more "
           "than 8 answers in a row are missing (45 ms at 200 Hz), and then ends the motion: a "
           "shorter stall is felt as a force that stands still."},
      .tables = {stallTable(measured), stallCountTable(measured), wordTable(measured)}};
}

report::DocumentPart ratePart(const DeviceMeasurement& measured) {
  return {
      .heading = "Rates",
      .paragraphs =
          {"The punch's own program at other rates than its 1000 Hz, and the arm's send periods. "
           "Stale are ticks for which no sample had come within two periods of the last. The "
           "stand-in "
           "has its rate from a timer of this machine."},
      .figures =
          {{.name = "round-trip",
            .caption = "Round trip over rate.",
            .chart = roundTripChart(measured)},
           {.name = "processor",
            .caption = "What the loop costs: processor time of this program, its thread that "
                       "looks on with it.",
            .chart = processorChart(measured)}},
      .tables = {rateTable(measured)}};
}

report::DocumentPart countPart(const DeviceMeasurement& measured) {
  return {
      .heading = "Exact counts",
      .paragraphs =
          {"While forces flow, the stand-ins spoil frames on order. A frame that is damaged is "
           "lost as well; lost here are those beside. The arm speaks FRI 2.7 here, which has a "
           "checksum: before, a damaged byte may go unnoticed.",
           fmt::format("All are found, and nothing else: {}.", measured.isExact() ? "yes" : "no")},
      .tables = {countTable(measured)}};
}

}  // namespace

std::vector<Target> devicesTargets(const DeviceMeasurement& measured) {
  std::vector<Target> targets;
  const auto add = [&](const std::string& what, double value) {
    targets.push_back({"link", what, value, 0.0, true});
  };
  for (const auto& series : measured.together) {
    const auto lost = series.sum(&LinkReport::lost) + series.sum(&LinkReport::damaged);
    add(fmt::format("{}: lost in {:.0f} s", nameOf(series), series.seconds()),
        static_cast<double>(lost));
    add(fmt::format("{}: faults", nameOf(series)), static_cast<double>(series.faults().size()));
  }
  for (const auto& counts : measured.counts) {
    for (std::size_t i = 0; i < FrameFaults::kNames.size(); ++i) {
      const auto off = std::abs(counts.injected.of[i] - counts.found.of[i]);
      add(fmt::format(
              "{}, {} {}: miscounted",
              counts.device,
              counts.injected.of[i],
              FrameFaults::kNames[i]),
          static_cast<double>(off));
    }
  }
  return targets;
}

report::Document devicesReport(const DeviceMeasurement& measured) {
  report::Document document{
      .title = "Devices on their wires",
      .lead =
          {"What our loop makes of both devices, on stand-ins: no laboratory's hardware, no cable, "
           "no robot's controller. Soft real time: so many cycles within so many microseconds, on "
           "this machine, today."},
      .parts = {
          {.heading = "Machine and targets",
           .tables = {machineTable(), targetTable(devicesTargets(measured))}}}};
  auto& parts = document.parts;
  if (!measured.together.empty()) parts.push_back(togetherPart(measured));
  if (!measured.stalls.empty()) parts.push_back(stallPart(measured));
  if (!measured.sweep.empty()) parts.push_back(ratePart(measured));
  if (!measured.counts.empty()) parts.push_back(countPart(measured));
  return document;
}

}  // namespace study::app
