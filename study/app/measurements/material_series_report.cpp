// The report on one series of a material: measured, filtered and normalised.
#include <algorithm>

#include <fmt/format.h>

#include "haptics/filters/low_pass.h"
#include "haptics/filters/spectrum.h"
#include "study/app/measurements/figure_lines.h"
#include "study/app/measurements/material_report.h"

namespace study::app {
namespace {

namespace reaming = haptics::reaming;
using report::Chart;
using report::ChartSeries;

// points of a line; a report with 72 series of six figures each must not become too large
constexpr std::size_t kPoints = 700;

/// The force or the torque of a series.
struct Quantity {
  const char* name;
  const char* unit;
  const std::vector<double>& samples;
  const reaming::SampledCurve& curve;
  double cutoff;
};

Chart filteredChart(const reaming::Series& series, const Quantity& of) {
  Chart chart{
      .x = {.title = "displacement [mm]"},
      .y = {.title = fmt::format("{} [{}]", of.name, of.unit)}};
  const auto measured = reaming::curveOver(series.displacement, of.samples);
  chart.series.push_back(lineOf("measured", measured, kMillimetres, kPoints));
  if (of.cutoff > 0.0) {
    chart.series.push_back(lineOf("filtered", of.curve, kMillimetres, kPoints));
  }
  return chart;
}

Chart spectrumChart(
    const reaming::Series& series, const Quantity& of, const reaming::FitOptions& options) {
  const auto spectrum = haptics::filters::spectrumOf(of.samples, series.rate, options.cutoffRule);
  Chart chart{
      .x = {.title = "frequency [Hz]", .isLogarithmic = true},
      .y = {.title = fmt::format("amplitude [{}]", of.unit), .isLogarithmic = true}};
  const auto filtered = haptics::filters::zeroPhaseLowPass(of.samples, series.rate, of.cutoff);
  const auto after = haptics::filters::spectrumOf(filtered, series.rate, options.cutoffRule);
  ChartSeries cutoff{.title = "cut-off", .style = ChartSeries::Style::Dashed};
  const double highest = *std::ranges::max_element(spectrum.amplitude);
  cutoff.points = {{of.cutoff, 1e-6 * highest}, {of.cutoff, highest}};
  const double least = 1e-6 * highest;
  chart.y.least = least;
  chart.series = {
      spectrumLine("before", spectrum, least),
      spectrumLine("after", after, least),
      std::move(cutoff)};
  return chart;
}

Chart normalisedChart(const Quantity& of) {
  Chart chart{
      .x = {.title = "share of the largest displacement"},
      .y = {.title = fmt::format("{} [{}]", of.name, of.unit)}};
  chart.series.push_back(lineOf(of.name, of.curve, 1.0 / of.curve.x.back(), kPoints));
  return chart;
}

void addFigures(
    report::DocumentPart& part,
    const std::string& number,
    const reaming::Series& series,
    const Quantity& of,
    const reaming::FitOptions& options) {
  part.figures.push_back(
      {.name = fmt::format("series-{}-{}", number, of.name),
       .caption = fmt::format("Measured and filtered {}.", of.name),
       .chart = filteredChart(series, of)});
  if (of.cutoff > 0.0) {
    part.figures.push_back(
        {.name = fmt::format("series-{}-{}-spectrum", number, of.name),
         .caption = fmt::format(
             "Amplitude spectrum of the {} before and after the filter, and the cut-off.", of.name),
         .chart = spectrumChart(series, of, options)});
  }
  part.figures.push_back(
      {.name = fmt::format("series-{}-{}-normalised", number, of.name),
       .caption = fmt::format("Normalised {}.", of.name),
       .chart = normalisedChart(of)});
}

DataTable dataTable(
    const reaming::Series& series,
    const reaming::PreparedSeries& prepared,
    const std::string& number,
    double scale) {
  const bool hasTorque = prepared.torque.size() > 0;
  DataTable table{
      .name = "series-" + number,
      .columns = {
          {"depth_mm", ""},
          {"share_of_series", ""},
          {"share_of_test_set", ""},
          {"force_n", ""},
          {"force_filtered_n", ""}}};
  if (hasTorque) {
    table.columns.push_back({"torque_nm", ""});
    table.columns.push_back({"torque_filtered_nm", ""});
  }
  const auto measured = [&](const std::vector<double>& samples) {
    return reaming::normalised(
               reaming::curveOver(series.displacement, samples), prepared.force.size())
        .y;
  };
  const auto force = measured(series.force);
  const auto torque = hasTorque ? measured(series.torque) : std::vector<double>();
  for (std::size_t i = 0; i < prepared.force.size(); ++i) {
    const double depth = prepared.force.x[i];
    std::vector<Cell> row{
        kMillimetres * depth,
        depth / prepared.largestDisplacement,
        depth / scale,
        force[i],
        prepared.force.y[i]};
    if (hasTorque) {
      row.emplace_back(torque[i]);
      row.emplace_back(prepared.torque.y[i]);
    }
    table.rows.push_back(std::move(row));
  }
  return table;
}

std::string describeFilter(const reaming::PreparedSeries& prepared) {
  if (prepared.cutoff == 0.0) return "Not filtered, as in the paper: the reamer was off.";
  auto words = fmt::format("Low-pass of the force at {:.4g} Hz", prepared.cutoff);
  if (prepared.torqueCutoff > 0.0) {
    words += fmt::format(", of the torque at {:.4g} Hz", prepared.torqueCutoff);
  }
  return words + ", forwards and backwards, without delay.";
}

}  // namespace

report::DocumentPart seriesPart(
    const reaming::Series& series,
    const reaming::PreparedSeries& prepared,
    std::size_t number,
    double scale,
    const reaming::FitOptions& options) {
  const auto shown = fmt::format("{:02}", number);
  report::DocumentPart part{
      .heading = fmt::format("Series {}: {}, {}", shown, series.name, nameOf(series.set)),
      .paragraphs = {fmt::format(
          "{} samples at {:.4g} Hz to {:.2f} mm. {}",
          series.force.size(),
          series.rate,
          kMillimetres * prepared.largestDisplacement,
          describeFilter(prepared))}};
  addFigures(
      part, shown, series, {"force", "N", series.force, prepared.force, prepared.cutoff}, options);
  if (prepared.torque.size() > 0) {
    addFigures(
        part,
        shown,
        series,
        {"torque", "N·m", series.torque, prepared.torque, prepared.torqueCutoff},
        options);
  }
  part.tables.push_back(dataTable(series, prepared, shown, scale));
  return part;
}

}  // namespace study::app
