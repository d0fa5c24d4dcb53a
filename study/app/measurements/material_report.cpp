#include "study/app/measurements/material_report.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace study::app {
namespace {

namespace reaming = haptics::reaming;
using report::Chart;
using report::ChartSeries;

constexpr double kMillimetres = 1000.0;

/// Every so many points, so that a figure of 200,000 samples stays one that opens.
template <typename X, typename Y>
ChartSeries thinned(const std::string& title, std::size_t count, X x, Y y) {
  constexpr std::size_t kMost = 3000;
  ChartSeries series{.title = title};
  const std::size_t stride = std::max<std::size_t>(1, count / kMost);
  for (std::size_t i = 0; i < count; i += stride) series.points.push_back({x(i), y(i)});
  return series;
}

ChartSeries lineOf(const std::string& title, const reaming::SampledCurve& curve, double scale) {
  return thinned(
      title,
      curve.size(),
      [&](std::size_t i) { return scale * curve.x[i]; },
      [&](std::size_t i) { return curve.y[i]; });
}

/// The first dynamic series that was used, or the first that was: an example for figures 4 and 5.
std::size_t exampleOf(const reaming::MaterialFit& fit) {
  std::size_t example = fit.series.size();
  for (std::size_t i = 0; i < fit.series.size(); ++i) {
    if (fit.series[i].exclusion.isExcluded()) continue;
    if (fit.series[i].cutoff > 0.0) return i;
    example = std::min(example, i);
  }
  return example;
}

report::DocumentPart seriesPart(
    const reaming::Series& series,
    const reaming::PreparedSeries& prepared,
    const reaming::FitOptions& options) {
  const auto raw = reaming::curveOver(series.displacement, series.force);
  Chart filtered{.x = {.title = "displacement [mm]"}, .y = {.title = "force [N]"}};
  filtered.series.push_back(lineOf("measured", raw, kMillimetres));
  filtered.series.push_back(
      lineOf("filtered", prepared.force, kMillimetres * prepared.largestDisplacement));
  const auto spectrum = reaming::spectrumOf(series.force, series.rate, options.cutoffRule);
  Chart shown{
      .x = {.title = "frequency [Hz]", .isLogarithmic = true},
      .y = {.title = "amplitude [N]", .isLogarithmic = true}};
  ChartSeries line{.title = "spectrum"};
  double next = 0.0;
  for (std::size_t i = 1; i < spectrum.amplitude.size(); ++i) {
    const double frequency = spectrum.step * static_cast<double>(i);
    if (frequency < next) continue;
    line.points.push_back({frequency, spectrum.amplitude[i]});
    next = frequency * 1.002;
  }
  ChartSeries cutoff{.title = "cut-off", .style = ChartSeries::Style::Dashed};
  const double highest = *std::max_element(spectrum.amplitude.begin(), spectrum.amplitude.end());
  if (prepared.cutoff > 0.0) {
    cutoff.points = {{prepared.cutoff, 1e-6 * highest}, {prepared.cutoff, highest}};
  }
  shown.series = {std::move(line), std::move(cutoff)};
  Chart normalised{
      .x = {.title = "share of the largest displacement"}, .y = {.title = "force [N]"}};
  normalised.series.push_back(lineOf("force", prepared.force, 1.0));
  Chart torque{.x = {.title = "share of the largest displacement"}, .y = {.title = "torque [N·m]"}};
  torque.series.push_back(lineOf("torque", prepared.torque, 1.0));

  report::DocumentPart part{
      .heading = "One series: " + series.name,
      .paragraphs = {fmt::format(
          "{} samples at {:.4g} Hz. {}",
          series.force.size(),
          series.rate,
          prepared.cutoff > 0.0
              ? fmt::format(
                    "Low-pass at {:.4g} Hz ({}), forwards and backwards, without delay.",
                    prepared.cutoff,
                    options.cutoff ? "as asked for" : "from its spectrum")
              : "Not filtered, as in the paper: the reamer was off.")},
      .figures = {
          {.name = "filtered", .caption = "Measured and filtered force.", .chart = filtered},
          {.name = "spectrum", .caption = "Its spectrum and the cut-off.", .chart = shown},
          {.name = "normalised", .caption = "Normalised force.", .chart = normalised}}};
  if (prepared.torque.size() > 0) {
    part.figures.push_back(
        {.name = "torque", .caption = "Normalised torque.", .chart = std::move(torque)});
  }
  return part;
}

/// The splines of an envelope, drawn over its data.
Chart envelopeChart(const reaming::FittedEnvelope& envelope, const std::string& unit) {
  Chart chart{.x = {.title = "displacement [mm]"}, .y = {.title = unit}};
  const std::pair<const char*, const reaming::FittedCurve*> curves[]{
      {"maximum", &envelope.maximum},
      {"average", &envelope.average},
      {"minimum", &envelope.minimum}};
  int colour = 0;
  for (const auto& [name, curve] : curves) {
    auto data = lineOf(name, curve->data, kMillimetres);
    data.colour = colour;
    ChartSeries nodes{
        .title = fmt::format("{}: {} nodes", name, curve->spline.nodes.size()),
        .style = ChartSeries::Style::Markers,
        .colour = colour++};
    for (const auto& node : curve->spline.nodes) {
      nodes.points.push_back({kMillimetres * node.position, node.force});
    }
    chart.series.push_back(std::move(data));
    chart.series.push_back(std::move(nodes));
  }
  return chart;
}

/// The paper's Fig. 7: the same nodes, two splines.
report::DocumentFigure cubicAgainstHermite(
    const reaming::TestSetFit& set, const reaming::FitOptions& options) {
  const auto& curve = set.force.maximum;
  std::vector<std::size_t> nodes;
  for (const auto& node : curve.spline.nodes) {
    const auto at = std::lower_bound(curve.data.x.begin(), curve.data.x.end(), node.position);
    nodes.push_back(static_cast<std::size_t>(at - curve.data.x.begin()));
  }
  const auto slopes = reaming::dataSlopes(curve.data);
  Chart chart{.x = {.title = "displacement [mm]"}, .y = {.title = "force [N]"}};
  chart.series.push_back(lineOf("data", curve.data, kMillimetres));
  std::string errors;
  const std::pair<const char*, reaming::SplineKind> kinds[]{
      {"natural cubic", reaming::SplineKind::NaturalCubic},
      {"cubic Hermite", reaming::SplineKind::HermiteDataSlope}};
  for (const auto& [name, kind] : kinds) {
    const auto spline = reaming::splineThrough(curve.data, slopes, nodes, kind);
    const auto error = reaming::errorOf(curve.data, spline, options.forceFloor);
    auto line = thinned(
        name,
        curve.data.size(),
        [&](std::size_t i) { return kMillimetres * curve.data.x[i]; },
        [&](std::size_t i) { return spline.at(curve.data.x[i]); });
    line.style = ChartSeries::Style::Dashed;
    chart.series.push_back(std::move(line));
    errors += fmt::format(
        "{}{}: |e_a| up to {:.3g} % at {:.3g} mm as published, {:.3g} % at {:.3g} mm with a floor "
        "of "
        "{:g} N, {:.3g} N at most",
        errors.empty() ? "" : "; ",
        name,
        100.0 * error.published,
        kMillimetres * error.publishedAt,
        100.0 * error.floored,
        kMillimetres * error.flooredAt,
        options.forceFloor,
        error.largest);
  }
  return {
      .name = "cubic-and-hermite-" + std::string(nameOf(set.set)),
      .caption = fmt::format(
          "Maximum force of {} through the same {} nodes. {}.",
          nameOf(set.set),
          nodes.size(),
          errors),
      .chart = std::move(chart)};
}

DataTable seriesTable(const reaming::MaterialFit& fit) {
  DataTable table{
      .name = "series",
      .description = "Every series",
      .columns = {
          {"series", "Series"},
          {"test_set", "Test set"},
          {"used", "Used"},
          {"excluded_because", "Left out because"},
          {"cutoff_hz", "Cut-off [Hz]"},
          {"largest_depth_mm", "Largest depth [mm]"}}};
  for (const auto& series : fit.series) {
    const bool isUsed = !series.exclusion.isExcluded();
    table.rows.push_back(
        {series.name,
         std::string(nameOf(series.set)),
         isUsed,
         isUsed ? Cell(std::monostate()) : Cell(series.exclusion.words),
         series.cutoff > 0.0 ? Cell(series.cutoff) : Cell(std::monostate()),
         isUsed ? Cell(kMillimetres * series.largestDisplacement) : Cell(std::monostate())});
  }
  return table;
}

DataTable errorTable(const reaming::MaterialFit& fit) {
  DataTable table{
      .name = "curves",
      .description = "How far the splines are from the data",
      .columns = {
          {"test_set", "Test set"},
          {"quantity", "Of"},
          {"curve", "Curve"},
          {"nodes", "Nodes"},
          {"e_a_published", "|e_a| as published"},
          {"e_a_at_mm", "… at [mm]"},
          {"floored", "with a floor"},
          {"largest", "Largest [N, N·m]"},
          {"rms", "RMS [N, N·m]"},
          {"r_squared", "R²"}}};
  const auto add =
      [&](const reaming::TestSetFit& set, const char* of, const reaming::FittedEnvelope& envelope) {
        const std::pair<const char*, const reaming::FittedCurve*> curves[]{
            {"minimum", &envelope.minimum},
            {"average", &envelope.average},
            {"maximum", &envelope.maximum}};
        for (const auto& [name, curve] : curves) {
          const auto& e = curve->error;
          table.rows.push_back(
              {std::string(nameOf(set.set)),
               std::string(of),
               std::string(name),
               static_cast<std::int64_t>(curve->spline.nodes.size()),
               e.published,
               kMillimetres * e.publishedAt,
               e.floored,
               e.largest,
               e.rms,
               e.rSquared});
        }
      };
  for (const auto& set : fit.sets) {
    add(set, "force", set.force);
    if (set.torque) add(set, "torque", *set.torque);
  }
  return table;
}

}  // namespace

report::Document materialReport(
    const std::vector<reaming::Series>& series,
    const reaming::MaterialFit& fit,
    const reaming::FitOptions& options) {
  report::Document document{.title = "A reaming material from measured series"};
  const bool isSynthetic =
      std::any_of(series.begin(), series.end(), [](const auto& each) { return each.isSynthetic; });
  if (isSynthetic) {
    document.lead.emplace_back(
        "SYNTHETIC: nobody measured these series. They have the published properties and no more.");
  }
  document.parts.push_back({.heading = "Series", .tables = {seriesTable(fit)}});
  const std::size_t example = exampleOf(fit);
  if (example < series.size()) {
    document.parts.push_back(seriesPart(series[example], fit.series[example], options));
  }
  for (const auto& set : fit.sets) {
    const std::string name(nameOf(set.set));
    report::DocumentPart part{
        .heading = "Test set " + name,
        .paragraphs = {fmt::format(
            "{} series; shares of the largest displacement times {:.3f} mm.",
            set.used,
            kMillimetres * set.scale)},
        .figures = {
            {.name = "force-" + name,
             .caption = "Force: data and nodes.",
             .chart = envelopeChart(set.force, "force [N]")}}};
    if (set.torque) {
      part.figures.push_back(
          {.name = "torque-" + name,
           .caption = "Torque: data and nodes.",
           .chart = envelopeChart(*set.torque, "torque [N·m]")});
    }
    part.figures.push_back(cubicAgainstHermite(set, options));
    document.parts.push_back(std::move(part));
  }
  document.parts.push_back({.heading = "Errors", .tables = {errorTable(fit)}});
  return document;
}

}  // namespace study::app
