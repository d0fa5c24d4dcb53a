#include "study/app/measurements/packing_report.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "study/app/measurements/figure_lines.h"

namespace study::app {
namespace {

namespace reaming = haptics::reaming;
using report::Chart;
using report::ChartSeries;

Chart forceChart(const reaming::BoneFitReport& fit) {
  Chart chart{.x = {.title = "depth [mm]"}, .y = {.title = "force [N]"}, .series = {}};
  int colour = 0;
  for (const auto& curve : fit.curves) {
    ChartSeries wanted{.title = curve.curve, .points = {}, .colour = colour};
    ChartSeries fittedForce{
        .title = curve.curve + ": spheres",
        .style = ChartSeries::Style::Dashed,
        .points = {},
        .colour = colour++};
    for (std::size_t i = 0; i < curve.depths.size(); ++i) {
      wanted.points.push_back({.x = kMillimetres * curve.depths[i], .y = curve.wanted[i]});
      fittedForce.points.push_back(
          {.x = kMillimetres * curve.depths[i], .y = curve.fittedForce[i]});
    }
    chart.series.push_back(std::move(wanted));
    chart.series.push_back(std::move(fittedForce));
  }
  return chart;
}

/// A histogram of the radii of spheres.
Chart sizeChart(const reaming::Packing& packing) {
  constexpr std::size_t kBins = 40;
  const double least = packing.spheres.back().radius;
  const double most = packing.spheres.front().radius;
  std::array<double, kBins> counts{};
  for (const auto& sphere : packing.spheres) {
    const double share = most > least ? (sphere.radius - least) / (most - least) : 0.0;
    counts[std::min(kBins - 1, static_cast<std::size_t>(share * kBins))] += 1.0;
  }
  Chart chart{
      .x = {.title = "radius [mm]"},
      .y = {.title = "spheres", .isLogarithmic = true},
      .series = {{.title = "", .style = ChartSeries::Style::LineAndMarkers, .points = {}}}};
  for (std::size_t i = 0; i < kBins; ++i) {
    if (counts[i] == 0.0) continue;
    const double middle = least + (most - least) * (static_cast<double>(i) + 0.5) / kBins;
    chart.series[0].points.push_back({.x = kMillimetres * middle, .y = counts[i]});
  }
  return chart;
}

DataTable fitTable(const reaming::BoneFitReport& fit) {
  DataTable table{
      .name = "fit",
      .description = "How well the spheres feel like the curves",
      .columns = {
          {"curve", "Curve"},
          {"error", "|Aρ − F| / |F|"},
          {"layers_error", "12 layers alone"},
          {"largest_n", "Largest [N]"},
          {"gap", "Above the optimum by at most"},
          {"iterations", "Steps"},
          {"touched", "Spheres touched"},
          {"torque_error", "|μBρ − T| / |T|"}}};
  for (const auto& curve : fit.curves) {
    double largest = 0.0;
    for (std::size_t i = 0; i < curve.wanted.size(); ++i) {
      largest = std::max(largest, std::abs(curve.fittedForce[i] - curve.wanted[i]));
    }
    table.rows.push_back(
        {curve.curve,
         curve.fit.spheres.error,
         curve.fit.layers.error,
         largest,
         fit.hasOptimalityGap ? Cell(std::max(curve.fit.spheres.gap, 0.0)) : Cell(std::monostate()),
         static_cast<std::int64_t>(curve.fit.spheres.iterations),
         curve.fit.touchedShare,
         curve.torqueError ? Cell(*curve.torqueError) : Cell(std::monostate())});
  }
  return table;
}

DataTable forceTable(const reaming::BoneFitReport& fit) {
  DataTable table{
      .name = "forces",
      .columns = {{"curve", "Curve"}, {"depth_m", ""}, {"wanted_n", ""}, {"felt_n", ""}}};
  for (const auto& curve : fit.curves) {
    for (std::size_t i = 0; i < curve.depths.size(); ++i) {
      table.rows.push_back({curve.curve, curve.depths[i], curve.wanted[i], curve.fittedForce[i]});
    }
  }
  return table;
}

}  // namespace

std::string syntheticMark(const reaming::PackedBone& bone) {
  return bone.isSynthetic ? "SYNTHETIC: no real bone was measured." : "";
}

std::vector<std::string> warningsOf(const reaming::BoneFitReport& fit) {
  constexpr double kMostGap = 0.01;
  constexpr double kMostError = 0.05;
  std::vector<std::string> warnings;
  for (const auto& curve : fit.curves) {
    const auto& spheres = curve.fit.spheres;
    if (!fit.hasOptimalityGap) {
      if (spheres.error > kMostError) {
        warnings.push_back(fmt::format(
            "The swarm misses the {} curve by {:.0f} % of its force. Give it more --iterations or "
            "another number of --layers, or use --method exact.",
            curve.curve,
            100.0 * spheres.error));
      }
    } else if (!(spheres.gap <= kMostGap)) {
      warnings.push_back(fmt::format(
          "The {} curve was not fitted: after {} steps its densities may be up to {:.0f} % above "
          "the optimum, where less than 1 % is usual. Do not use them; build the bone with more "
          "spheres or another seed, and fit it again.",
          curve.curve,
          spheres.iterations,
          100.0 * spheres.gap));
    } else if (spheres.error > kMostError) {
      warnings.push_back(fmt::format(
          "The {} curve cannot be felt with these spheres: the best densities miss it by {:.0f} % "
          "of its force. Give the reamer more bone in its way: turn or move the mesh, or build it "
          "with more spheres.",
          curve.curve,
          100.0 * spheres.error));
    }
    if (curve.torqueError.value_or(0.0) <= kMostError) continue;
    warnings.push_back(fmt::format(
        "The torque of the {} curve cannot be felt with these spheres: it is {:.0f} % off. {}",
        curve.curve,
        100.0 * *curve.torqueError,
        fit.hasOptimalityGap ? "Build the bone with more spheres, or leave --friction out."
                             : "Use --method exact, which fits force and torque."));
  }
  return warnings;
}

report::Document packingReport(
    const reaming::PackedBone& bone, const reaming::BoneFitReport& fit, const DataTable& feeds) {
  report::Document document{.title = "Spheres that feel like a material", .lead = {}, .parts = {}};
  document.lead.push_back(fmt::format(
      "{} spheres cover {:.1f} % of {:.1f} cm³; a reamer of {:.1f} mm radius goes in along +z.",
      bone.packing.spheres.size(),
      100.0 * bone.packing.coverage(),
      1e6 * bone.packing.volume,
      kMillimetres * bone.reamerRadius));
  if (bone.isSynthetic) document.lead.push_back(syntheticMark(bone));
  for (const auto& warning : warningsOf(fit)) document.lead.push_back("WARNING: " + warning);
  document.parts.push_back(
      {.heading = "Forces",
       .paragraphs = {fmt::format(
           "The virtual experiment: the reamer is put in, and what all spheres give way at is "
           "added up. {:.0f} % of the spheres are ever touched; the experiment says nothing of the "
           "others, which are as the deepest layer that is touched. {:.1f} s for all curves.{}",
           100.0 * fit.curves.front().fit.touchedShare,
           fit.seconds,
           fit.friction ? fmt::format(" Friction {:.3g}.", *fit.friction) : "")},
       .figures =
           {{.name = "forces",
             .caption = "Curves of the material, and what the spheres make of them.",
             .chart = forceChart(fit),
             .svg = {}}},
       .tables = {fitTable(fit), forceTable(fit)}});
  document.parts.push_back(
      {.heading = "Feed and force",
       .paragraphs =
           {"A curve was measured at 0.01 or 0.03 mm/s. The force grows with the feed, up to the "
            "feed that the reamer's teeth can take; pushed harder, it goes no faster."},
       .figures = {},
       .tables = {feeds}});
  document.parts.push_back(
      {.heading = "Spheres",
       .paragraphs = {},
       .figures =
           {{.name = "sizes",
             .caption = "How many spheres there are of each size.",
             .chart = sizeChart(bone.packing),
             .svg = {}}},
       .tables = {}});
  return document;
}

}  // namespace study::app
