#include "study/app/measurements/material_report.h"

#include <algorithm>

#include <fmt/format.h>

#include "haptics/reaming/material/node_choice.h"
#include "protocols/reading/material_file.h"
#include "study/app/measurements/feed_table.h"
#include "study/app/measurements/figure_lines.h"

namespace study::app {
namespace {

namespace reaming = haptics::reaming;
using report::Chart;
using report::ChartSeries;

/// The x axis of a test set's figures.
struct DepthScale {
  std::string title;
  double factor;  ///< multiplied by depths [m]
};

DepthScale depthScaleOf(const reaming::TestSetFit& set, const reaming::FitOptions& options) {
  if (options.axis == reaming::DepthAxis::Depth) return {"displacement [mm]", kMillimetres};
  return {"share of the largest displacement", 1.0 / set.scale};
}

/// Figure 3: all measured series of a test set.
Chart seriesChart(
    const std::vector<reaming::Series>& series,
    const reaming::MaterialFit& fit,
    reaming::TestSet set,
    bool isTorque) {
  constexpr std::size_t kPoints = 300;
  Chart chart{
      .x = {.title = "displacement [mm]"}, .y = {.title = isTorque ? "torque [N·m]" : "force [N]"}};
  for (std::size_t i = 0; i < series.size(); ++i) {
    if (series[i].set != set || fit.series[i].exclusion.isExcluded()) continue;
    const auto& samples = isTorque ? series[i].torque : series[i].force;
    if (samples.empty()) continue;
    const auto curve = reaming::curveOver(series[i].displacement, samples);
    chart.series.push_back(lineOf("", curve, kMillimetres, kPoints));
  }
  return chart;
}

/// The curves of an envelope, with the nodes of their splines.
Chart envelopeChart(
    const reaming::FittedEnvelope& envelope,
    const std::string& unit,
    const DepthScale& depth,
    const reaming::FitOptions& options) {
  Chart chart{.x = {.title = depth.title}, .y = {.title = unit}};
  const std::pair<std::string, const reaming::FittedCurve*> curves[]{
      {"maximum", &envelope.maximum},
      {middleCurveNameOf(options.envelope), &envelope.average},
      {"minimum", &envelope.minimum}};
  int colour = 0;
  for (const auto& [name, curve] : curves) {
    auto data = lineOf(name, curve->data, depth.factor);
    data.colour = colour;
    ChartSeries nodes{
        .title = fmt::format("{}: {} nodes", name, curve->spline.nodes.size()),
        .style = ChartSeries::Style::Markers,
        .colour = colour++};
    for (const auto& node : curve->spline.nodes) {
      nodes.points.push_back({depth.factor * node.position, node.force});
    }
    chart.series.push_back(std::move(data));
    chart.series.push_back(std::move(nodes));
  }
  return chart;
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
          {"torque_cutoff_hz", "… of the torque [Hz]"},
          {"largest_depth_mm", "Largest depth [mm]"},
          {"ended", "Ended"}}};
  for (const auto& series : fit.series) {
    const bool isUsed = !series.exclusion.isExcluded();
    table.rows.push_back(
        {series.name,
         std::string(nameOf(series.set)),
         isUsed,
         isUsed ? Cell(std::monostate()) : Cell(series.exclusion.words),
         series.cutoff > 0.0 ? Cell(series.cutoff) : Cell(std::monostate()),
         series.torqueCutoff > 0.0 ? Cell(series.torqueCutoff) : Cell(std::monostate()),
         isUsed ? Cell(kMillimetres * series.largestDisplacement) : Cell(std::monostate()),
         !isUsed             ? Cell(std::monostate())
         : series.isCensored ? Cell(std::string("at the force limit"))
                             : Cell(std::string("stalled, or at the last depth"))});
  }
  return table;
}

DataTable errorTable(const std::vector<NamedCurve>& curves) {
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
          {"floored_at_mm", "… at [mm]"},
          {"largest", "Largest [N, N·m]"},
          {"rms", "RMS [N, N·m]"},
          {"r_squared", "R²"}}};
  for (const auto& curve : curves) {
    const auto& e = curve.curve->error;
    table.rows.push_back(
        {curve.setName,
         curve.quantity,
         curve.curveName,
         static_cast<std::int64_t>(curve.curve->spline.nodes.size()),
         e.published,
         kMillimetres * e.publishedPosition,
         e.floored,
         kMillimetres * e.flooredPosition,
         e.largest,
         e.rms,
         e.rSquared});
  }
  return table;
}

/// The number of specimens behind a test set's curves, over depth.
DataTable specimenTable(const reaming::TestSetFit& set) {
  DataTable table{
      .name = "specimens-" + std::string(nameOf(set.set)),
      .description = "Specimens that count, from each depth at which that changes",
      .columns = {
          {"from_mm", "From [mm]"}, {"measured", "Measured"}, {"held", "Held at the limit"}}};
  for (const auto& stretch : reaming::specimenCountsOf(set.force)) {
    table.rows.push_back(
        {kMillimetres * stretch.from, std::int64_t{stretch.measured}, std::int64_t{stretch.held}});
  }
  return table;
}

/// An envelope and its splines at all depths, for a CSV file.
DataTable envelopeTable(
    const reaming::TestSetFit& set,
    const char* quantity,
    const char* unit,
    const reaming::FittedEnvelope& envelope,
    const reaming::FitOptions& options) {
  auto middle = middleCurveNameOf(options.envelope);
  std::ranges::replace(middle, '-', '_');
  DataTable table{
      .name = fmt::format("envelope-{}-{}", nameOf(set.set), quantity),
      .columns = {{"depth_mm", ""}, {"share_of_test_set", ""}, {"measured", ""}, {"held", ""}}};
  for (const std::string& curve : {std::string("minimum"), middle, std::string("maximum")}) {
    table.columns.push_back({curve + "_" + unit, ""});
    table.columns.push_back({curve + "_spline_" + unit, ""});
  }
  const reaming::FittedCurve* const curves[]{
      &envelope.minimum, &envelope.average, &envelope.maximum};
  for (std::size_t i = 0; i < envelope.average.data.size(); ++i) {
    const double depth = envelope.average.data.x[i];
    std::vector<Cell> row{
        kMillimetres * depth,
        depth / set.scale,
        std::int64_t{envelope.measured[i]},
        std::int64_t{envelope.held[i]}};
    for (const auto* curve : curves) {
      row.emplace_back(curve->data.y[i]);
      row.emplace_back(curve->spline.at(depth));
    }
    table.rows.push_back(std::move(row));
  }
  return table;
}

std::string describeAxis(const reaming::TestSetFit& set, const reaming::FitOptions& options) {
  switch (options.axis) {
    case reaming::DepthAxis::Depth:
      return fmt::format(
          "{} series, each at the depths at which it was measured, to {:.3f} mm. A test that ended "
          "at its force limit counts on with that force; one that ended otherwise leaves over {} "
          "mm, and no curve falls because of it.",
          set.used,
          kMillimetres * set.scale,
          kMillimetres * reaming::kFadeOutDepth);
    case reaming::DepthAxis::Normalised:
      return fmt::format(
          "{} series over shares of the largest displacement of the test set, {:.3f} mm; tests "
          "that have ended are absent. For comparing figures.",
          set.used,
          kMillimetres * set.scale);
    case reaming::DepthAxis::NormalisedSeries:
      return fmt::format(
          "{} series, each over shares of its own largest displacement; the largest of all is "
          "{:.3f} mm. For comparing figures: a test that ended early is stretched.",
          set.used,
          kMillimetres * set.scale);
  }
  return {};
}

/// Whether a scene can render the curves of a test set by reaming.
bool isReamable(const reaming::TestSetFit& set, const reaming::FitOptions& options) {
  return set.set != reaming::TestSet::Static && options.axis == reaming::DepthAxis::Depth &&
         options.spline != reaming::SplineKind::Linear;
}

reaming::HardnessCurves curvesOf(const reaming::FittedEnvelope& envelope) {
  return {
      envelope.minimum.spline.nodes, envelope.average.spline.nodes, envelope.maximum.spline.nodes};
}

report::DocumentPart testSetPart(
    const std::vector<reaming::Series>& series,
    const reaming::MaterialFit& fit,
    const reaming::TestSetFit& set,
    const reaming::FitOptions& options) {
  const std::string name(nameOf(set.set));
  const auto depth = depthScaleOf(set, options);
  report::DocumentPart part{
      .heading = "Test set " + name, .paragraphs = {describeAxis(set, options)}};
  const auto add = [&](const char* quantity,
                       const char* unit,
                       const char* column,
                       const reaming::FittedEnvelope& envelope,
                       bool isTorque) {
    part.figures.push_back(
        {.name = fmt::format("all-{}-{}", quantity, name),
         .caption = fmt::format("All series as measured: {}.", quantity),
         .chart = seriesChart(series, fit, set.set, isTorque)});
    part.figures.push_back(
        {.name = fmt::format("{}-{}", quantity, name),
         .caption = fmt::format("Envelope of the {}: data and nodes.", quantity),
         .chart = envelopeChart(envelope, fmt::format("{} [{}]", quantity, unit), depth, options)});
    part.tables.push_back(envelopeTable(set, quantity, column, envelope, options));
  };
  part.tables.push_back(specimenTable(set));
  if (isReamable(set, options)) {
    auto feeds = feedTable(curvesOf(set.force), middleCurveNameOf(options.envelope));
    feeds.name += "-" + name;
    part.tables.push_back(std::move(feeds));
  }
  add("force", "N", "n", set.force, false);
  if (set.torque) add("torque", "N·m", "nm", *set.torque, true);
  return part;
}

}  // namespace

std::string middleCurveNameOf(reaming::EnvelopeRule rule) {
  return rule == reaming::EnvelopeRule::Pointwise ? "average" : "middle-specimen";
}

std::vector<NamedCurve> curvesOf(
    const reaming::MaterialFit& fit, const reaming::FitOptions& options) {
  std::vector<NamedCurve> curves;
  const auto add = [&](const reaming::TestSetFit& set,
                       const std::string& quantity,
                       const reaming::FittedEnvelope& envelope,
                       double floor) {
    const std::string name(nameOf(set.set));
    curves.push_back({name, quantity, "minimum", &envelope.minimum, floor});
    curves.push_back(
        {name, quantity, middleCurveNameOf(options.envelope), &envelope.average, floor});
    curves.push_back({name, quantity, "maximum", &envelope.maximum, floor});
  };
  for (const auto& set : fit.sets) {
    add(set, "force", set.force, options.forceFloor);
    if (set.torque) add(set, "torque", *set.torque, options.torqueFloor);
  }
  return curves;
}

std::string pathOf(const NamedCurve& curve) {
  return curve.setName + "/" + curve.quantity + "/" + curve.curveName;
}

reaming::FitOptions optionsForFigure7(reaming::FitOptions options) {
  if (!options.nodeCount) options.nodeCount = kPaperNodes;
  if (!options.nodesOf) options.nodesOf = reaming::SplineKind::NaturalCubic;
  return options;
}

report::DocumentPart splineComparisonPart(
    const NamedCurve& curve, const reaming::FitOptions& options) {
  const auto& data = curve.curve->data;
  const auto kind = options.nodesOf.value_or(options.spline);
  const reaming::NodeCriterion nodeCriterion{options.nodes, kind, options.wantedError, curve.floor};
  const auto choice = options.nodeCount ? chooseNodes(data, *options.nodeCount, nodeCriterion)
                                        : chooseNodes(data, nodeCriterion);
  const auto comparison = reaming::compareSplines(data, choice.nodes, curve.floor);
  const bool isForce = curve.quantity == "force";
  report::DocumentPart part{
      .heading = fmt::format(
          "{}: {} nodes, placed for {}",
          pathOf(curve),
          comparison.nodes.size(),
          protocols::nameOf(kind))};
  Chart chart{
      .x = {.title = "displacement [mm]"}, .y = {.title = isForce ? "force [N]" : "torque [N·m]"}};
  chart.series.push_back(lineOf("data", data, kMillimetres));
  ChartSeries nodes{.title = "nodes", .style = ChartSeries::Style::Markers};
  for (const auto node : comparison.nodes) {
    nodes.points.push_back({kMillimetres * data.x[node], data.y[node]});
  }
  chart.series.push_back(std::move(nodes));
  const auto percent = [](double share) { return fmt::format("{:.3g} %", 100.0 * share); };
  for (const auto& spline : comparison.splines) {
    const std::string name(protocols::nameOf(spline.kind));
    auto line = thinnedSeries(
        name,
        data.size(),
        [&](std::size_t i) { return kMillimetres * data.x[i]; },
        [&](std::size_t i) { return spline.spline.at(data.x[i]); });
    line.style = ChartSeries::Style::Dashed;
    chart.series.push_back(std::move(line));
    const auto& first = comparison.splines.front();
    // The paper's "at the same reamer displacement" is the depth at which the first spline has its
    // largest error.
    const auto there = [&](double share, double depth) {
      return &spline == &first ? std::string()
                               : fmt::format(
                                     " ({} at {:.2f} mm, where {} is worst)",
                                     percent(share),
                                     kMillimetres * depth,
                                     protocols::nameOf(first.kind));
    };
    part.paragraphs.push_back(fmt::format(
        "{}: |e_a| with a floor of {:g} {} up to {} at {:.2f} mm{}; as published up to {} at "
        "{:.2f} "
        "mm{}; {:.3g} {} at most",
        name,
        curve.floor,
        isForce ? "N" : "N·m",
        percent(spline.error.floored),
        kMillimetres * spline.error.flooredPosition,
        there(spline.flooredErrorAtWorst, first.error.flooredPosition),
        percent(spline.error.published),
        kMillimetres * spline.error.publishedPosition,
        there(spline.publishedErrorAtWorst, first.error.publishedPosition),
        spline.error.largest,
        isForce ? "N" : "N·m"));
  }
  part.figures.push_back(
      {.name = fmt::format("splines-{}-{}-{}", curve.setName, curve.quantity, curve.curveName),
       .caption = "Data, nodes, and both splines through them.",
       .chart = std::move(chart)});
  return part;
}

report::Document materialReport(
    const std::vector<reaming::Series>& series,
    const reaming::MaterialFit& fit,
    const reaming::FitOptions& options) {
  report::Document document{.title = "A reaming material from measured series"};
  const bool isSynthetic =
      std::ranges::any_of(series, [](const auto& each) { return each.isSynthetic; });
  if (isSynthetic) {
    document.lead.emplace_back(
        "SYNTHETIC: these series were not measured. They have the published properties and no "
        "more.");
  }
  document.parts.push_back({.heading = "Series", .tables = {seriesTable(fit)}});
  for (const auto& set : fit.sets) document.parts.push_back(testSetPart(series, fit, set, options));
  const auto curves = curvesOf(fit, options);
  document.parts.push_back({.heading = "Errors", .tables = {errorTable(curves)}});
  for (const auto& curve : curves) {
    document.parts.push_back(splineComparisonPart(curve, optionsForFigure7(options)));
  }
  for (std::size_t i = 0; i < series.size(); ++i) {
    const auto& prepared = fit.series[i];
    if (prepared.exclusion.isExcluded()) continue;
    const auto set =
        std::ranges::find_if(fit.sets, [&](const auto& each) { return each.set == prepared.set; });
    document.parts.push_back(seriesPart(series[i], prepared, i + 1, set->scale, options));
  }
  return document;
}

}  // namespace study::app
