#include "study/app/measurements/recording_report.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "haptics/filters/spectrum.h"
#include "study/app/measurements/figure_lines.h"

namespace study::app {
namespace {

namespace recordings = haptics::recordings;
using haptics::filters::CutoffRule;
using report::Chart;
using report::ChartSeries;

constexpr double kPaperFrequency = 5.0;  // [Hz]; section II-B of the punch paper: "typically below
                                         // 5 Hz"

std::vector<double> travelOf(const recordings::Recording& recording) {
  std::vector<double> travel;
  travel.reserve(recording.rows.size());
  for (const auto& row : recording.rows) travel.push_back(row.travel);
  return travel;
}

report::DocumentPart spectrumPart(
    const recordings::Recording& recording,
    const recordings::Trace& trace,
    double rate,
    const std::string& filterParameters) {
  const auto before = travelOf(recording);
  const auto spectrumBefore = haptics::filters::spectrumOf(before, rate, CutoffRule::Floor);
  const auto spectrumAfter = haptics::filters::spectrumOf(trace.travel, rate, CutoffRule::Floor);
  report::DocumentPart part{
      .heading = "Spectrum of the travel",
      .paragraphs = {
          fmt::format("Filter: {}.", filterParameters),
          fmt::format(
              "Up to {:g} Hz lie {:.1f} % of the variance of the unfiltered travel.",
              kPaperFrequency,
              100.0 * shareBelow(before, rate, kPaperFrequency))}};
  Chart chart{
      .x = {.title = "frequency [Hz]", .isLogarithmic = true},
      .y = {.title = "amplitude [travel units]", .isLogarithmic = true}};
  const double highest = *std::ranges::max_element(spectrumBefore.amplitude);
  const double least = 1e-7 * highest;
  chart.y.least = least;
  chart.series = {
      spectrumLine("before", spectrumBefore, least), spectrumLine("after", spectrumAfter, least)};
  part.figures.push_back(
      {.name = "spectrum",
       .caption = "Amplitude spectrum of the whole recording's travel, before and after the filter "
                  "(straight line from end to end taken away, Hann window).",
       .chart = std::move(chart)});
  DataTable table{
      .name = "spectrum", .columns = {{"frequency_hz", ""}, {"before", ""}, {"after", ""}}};
  for (std::size_t i = 0; i < spectrumBefore.amplitude.size(); ++i) {
    table.rows.push_back(
        {spectrumBefore.step * static_cast<double>(i),
         spectrumBefore.amplitude[i],
         spectrumAfter.amplitude[i]});
  }
  part.tables.push_back(std::move(table));
  return part;
}

void addLandmarks(
    Chart& chart,
    const recordings::RecordingSurvey& survey,
    const char* title,
    std::optional<recordings::CurvePoint> recordings::CutLandmarks::*landmark) {
  ChartSeries markers{.title = title, .style = ChartSeries::Style::Markers};
  for (const auto& closure : survey.closures) {
    if (const auto& point = closure.landmarks.*landmark) {
      markers.points.push_back({point->travel, point->force});
    }
  }
  if (!markers.points.empty()) chart.series.push_back(std::move(markers));
}

ChartSeries rowsAsLine(
    const std::string& title, const recordings::Trace& trace, const recordings::RowRange& rows) {
  return thinnedSeries(
      title,
      rows.last - rows.first + 1,
      [&](std::size_t i) { return trace.travel[rows.first - 1 + i]; },
      [&](std::size_t i) { return trace.force[rows.first - 1 + i]; },
      700);
}

Cell forceOf(const std::optional<recordings::CurvePoint>& point) {
  return point ? Cell(point->force) : Cell();
}

Cell travelOf(const std::optional<recordings::CurvePoint>& point) {
  return point ? Cell(point->travel) : Cell();
}

report::DocumentPart closuresPart(
    const recordings::Trace& trace, const recordings::RecordingSurvey& survey) {
  Chart chart{.x = {.title = "travel [travel units]"}, .y = {.title = "force [N]"}};
  ChartSeries closing{.title = "closing"};
  for (const auto& closure : survey.closures) {
    const auto line = rowsAsLine("", trace, closure.closing);
    closing.points.insert(closing.points.end(), line.points.begin(), line.points.end());
    closing.points.push_back({std::nan(""), std::nan("")});  // NaN ends the line
  }
  chart.series.push_back(std::move(closing));
  using Landmarks = recordings::CutLandmarks;
  addLandmarks(chart, survey, "interception", &Landmarks::interception);
  addLandmarks(chart, survey, "yield", &Landmarks::yield);
  addLandmarks(chart, survey, "bottom-out", &Landmarks::bottomOut);
  addLandmarks(chart, survey, "opening", &Landmarks::opening);
  DataTable table{
      .name = "closures",
      .description = "Closures, in the order of time.",
      .columns = {
          {"closure", "closure"},
          {"first_row", "first row"},
          {"last_row", "last row"},
          {"first_closing_row", "closing from"},
          {"last_closing_row", "to"},
          {"seconds", "s"},
          {"peak_n", "peak [N]"},
          {"interception_travel", "interception at"},
          {"yield_travel", "yield at"},
          {"yield_n", "yield [N]"},
          {"bottom_out_travel", "bottom-out at"},
          {"bottom_out_n", "bottom-out [N]"},
          {"complete", "complete"}}};
  std::int64_t number = 0;
  for (const auto& closure : survey.closures) {
    const auto& found = closure.landmarks;
    table.rows.push_back(
        {++number,
         static_cast<std::int64_t>(closure.rows.first),
         static_cast<std::int64_t>(closure.rows.last),
         static_cast<std::int64_t>(closure.closing.first),
         static_cast<std::int64_t>(closure.closing.last),
         closure.duration,
         closure.peakForce,
         travelOf(found.interception),
         travelOf(found.yield),
         forceOf(found.yield),
         travelOf(found.bottomOut),
         forceOf(found.bottomOut),
         closure.isComplete});
  }
  return {
      .heading = "Closures",
      .paragraphs = {},
      .figures =
          {{.name = "closures",
            .caption = "Force over travel while the tool closed, all closures, with the landmarks "
                       "that were found.",
            .chart = std::move(chart)}},
      .tables = {std::move(table)}};
}

Chart travelOverTime(
    const recordings::Recording& recording,
    const recordings::Trace& trace,
    const recordings::RowRange& rows) {
  constexpr double kSecondsPerMillisecond = 1e-3;
  const std::size_t first = rows.first - 1;
  const std::size_t count = rows.last - first;
  const auto time = [&](std::size_t i) {
    return kSecondsPerMillisecond * (recording.rows[first + i].time - recording.rows[first].time);
  };
  Chart chart{.x = {.title = "time [s]"}, .y = {.title = "travel [travel units]"}};
  chart.series.push_back(thinnedSeries(
      "recorded", count, time, [&](std::size_t i) { return recording.rows[first + i].travel; }));
  chart.series.push_back(thinnedSeries(
      "filtered", count, time, [&](std::size_t i) { return trace.travel[first + i]; }));
  return chart;
}

report::DocumentPart cutPart(
    const recordings::Recording& recording,
    const recordings::Trace& trace,
    const recordings::ImportedCut& imported) {
  report::DocumentPart part{
      .heading = "The cut", .paragraphs = {imported.cut.provenance.statement + "."}};
  for (const auto& change : imported.report.changes)
    part.paragraphs.push_back(describe(change) + ".");
  Chart chart{.x = {.title = "travel [travel units]"}, .y = {.title = "force [N]"}};
  ChartSeries samples{.title = "recorded", .style = ChartSeries::Style::Markers};
  for (const auto& rows : imported.report.rows) {
    const auto line = rowsAsLine("", trace, rows);
    samples.points.insert(samples.points.end(), line.points.begin(), line.points.end());
  }
  chart.series.push_back(std::move(samples));
  const auto& nodes = imported.cut.curve.nodes();
  chart.series.push_back(thinnedSeries(
      "as rendered",
      nodes.size(),
      [&](std::size_t i) { return nodes[i].travel; },
      [&](std::size_t i) { return nodes[i].force; }));
  part.figures.push_back(
      {.name = "cut", .caption = "The cut: samples and curve.", .chart = std::move(chart)});
  part.figures.push_back(
      {.name = "travel",
       .caption = "Travel over time, before and after the filter.",
       .chart = travelOverTime(recording, trace, imported.report.rows.front())});
  return part;
}

}  // namespace

double shareBelow(const std::vector<double>& samples, double rate, double frequency) {
  const auto spectrum = haptics::filters::spectrumOf(samples, rate, CutoffRule::Floor);
  double below = 0.0;
  double all = 0.0;
  for (std::size_t i = 1; i < spectrum.amplitude.size(); ++i) {
    const double power = spectrum.amplitude[i] * spectrum.amplitude[i];
    all += power;
    if (spectrum.step * static_cast<double>(i) <= frequency) below += power;
  }
  return all > 0.0 ? below / all : 1.0;
}

report::Document recordingReport(
    const recordings::Recording& recording,
    const recordings::Trace& trace,
    const recordings::RecordingSurvey& survey,
    const std::string& filterParameters,
    const std::optional<recordings::ImportedCut>& imported) {
  report::Document document{.title = "Recording " + recording.source};
  document.lead.push_back(fmt::format(
      "{} rows at {:.1f} Hz; forces of {:.2f} to {:.2f} N by the calibration '{}'.",
      survey.rows,
      survey.sampling.rate,
      survey.minForce,
      survey.maxForce,
      trace.calibration.name));
  if (survey.sampling.rate > 0.0) {
    document.parts.push_back(
        spectrumPart(recording, trace, survey.sampling.rate, filterParameters));
  }
  if (!survey.closures.empty()) document.parts.push_back(closuresPart(trace, survey));
  if (imported) document.parts.push_back(cutPart(recording, trace, *imported));
  return document;
}

report::Document calibrationReport(
    const recordings::CalibrationTable& table,
    const recordings::CalibrationFit& fit,
    const DataTable& orders) {
  const auto& calibration = fit.calibration;
  Chart curve{
      .x = {.title = fmt::format("reading [{}]", calibration.unit)}, .y = {.title = "force [N]"}};
  Chart residuals{.x = {.title = "force [N]"}, .y = {.title = "residual [N]"}};
  ChartSeries loads{.title = "known loads", .style = ChartSeries::Style::Markers};
  ChartSeries left{.style = ChartSeries::Style::Markers};
  DataTable points{
      .name = "points",
      .description = "Every known load.",
      .columns = {
          {"reading", fmt::format("reading [{}]", calibration.unit)},
          {"force_n", "force [N]"},
          {"fitted_n", "fitted [N]"},
          {"residual_n", "residual [N]"}}};
  double least = table.points.front().force;
  double most = least;
  for (std::size_t i = 0; i < table.points.size(); ++i) {
    const auto& point = table.points[i];
    loads.points.push_back({point.reading, point.force});
    left.points.push_back({point.force, fit.residuals[i]});
    points.rows.push_back(
        {point.reading, point.force, point.force + fit.residuals[i], fit.residuals[i]});
    least = std::min(least, point.force);
    most = std::max(most, point.force);
  }
  constexpr std::size_t kSteps = 200;
  const double step = (calibration.highest - calibration.lowest) / kSteps;
  const auto at = [&](std::size_t i) { return calibration.lowest + step * static_cast<double>(i); };
  curve.series = {
      std::move(loads), thinnedSeries("calibration", kSteps + 1, at, [&](std::size_t i) {
        return recordings::forceOf(at(i), calibration);
      })};
  residuals.series = {
      std::move(left),
      {.title = "RMS",
       .style = ChartSeries::Style::Dashed,
       .points = {{least, fit.rms}, {most, fit.rms}},
       .colour = 1},
      {.title = "",
       .style = ChartSeries::Style::Dashed,
       .points = {{least, -fit.rms}, {most, -fit.rms}},
       .colour = 1}};
  return {
      .title = "Calibration of a force sensor: " + table.source,
      .lead = {},
      .parts = {
          {.heading = "Calibration",
           .paragraphs = {fmt::format(
               "{} loads from {:.3g} to {:.3g} N. RMS of the residuals {:.3g} N, largest {:.3g} N.",
               table.points.size(),
               least,
               most,
               fit.rms,
               fit.largest)},
           .figures =
               {{.name = "curve", .caption = "Known loads and the calibration.", .chart = curve},
                {.name = "residuals",
                 .caption = "Residuals: fitted force less known load.",
                 .chart = residuals}},
           .tables = {orders, points}}}};
}

}  // namespace study::app
