#include "study/app/measurements/feed_table.h"

#include <cmath>
#include <vector>

#include <fmt/format.h>

#include "study/app/measurements/figure_lines.h"

namespace study::app {
namespace {

namespace reaming = haptics::reaming;

constexpr double kDepths[]{0.004, 0.006, 0.008};  // [m]
constexpr double kMostDepth = 0.010;              // [m]

/// Those of the measurements, then on in steps of about three to nine tenths of the most that the
/// reamer goes at: a machine that goes at the limit itself never catches up [m/s].
std::vector<double> feedsUpTo(double most) {
  const double last = 0.9 * most;
  std::vector<double> feeds;
  for (const double feed : {0.01e-3, 0.03e-3, 0.1e-3, 0.3e-3, 1e-3, 3e-3, 10e-3}) {
    if (feed < last) feeds.push_back(feed);
  }
  if (std::isfinite(last) && last > 0.0) feeds.push_back(last);
  return feeds;
}

Cell orNothing(double value) {
  return std::isfinite(value) ? Cell(value) : Cell(std::monostate());
}

/// The curve at @p depth, straight between the depths at which it was fitted.
double wantedAt(const reaming::CurveFit& curve, double depth) {
  return reaming::forceAt({.depth = curve.depths, .force = curve.wanted, .stop = {}}, depth);
}

}  // namespace

DataTable feedTable(
    const reaming::PackedBone& bone,
    const reaming::BoneFitReport& fit,
    const haptics::engine::Reamer& reamer) {
  DataTable table{
      .name = "feeds",
      .description = fmt::format(
          "Force by feed: reamed to {:g} mm with {:g} turns a second, {} teeth and {:g} mm per "
          "tooth, at most {:.3g} mm/s. Mass is density times volume: the work of removal.",
          kMillimetres * kMostDepth,
          reamer.speed,
          reamer.teeth,
          kMillimetres * reamer.feedPerTooth,
          kMillimetres * reamer.mostFeed()),
      .columns = {{"curve", "Curve"}, {"feed_mm_per_s", "Feed [mm/s]"}}};
  for (const double depth : kDepths) {
    const double mm = kMillimetres * depth;
    table.columns.push_back(
        {fmt::format("force_n_at_{:g}_mm", mm), fmt::format("Force at {:g} mm [N]", mm)});
    table.columns.push_back(
        {fmt::format("curve_n_at_{:g}_mm", mm), fmt::format("Curve at {:g} mm [N]", mm)});
  }
  table.columns.push_back({"removed_nm", "Removed [N·m]"});
  table.columns.push_back({"removed_share", "Share of the mass"});
  table.columns.push_back({"unaccounted_share", "Not accounted for"});
  double h = 0.0;
  for (const auto& curve : fit.curves) {
    for (const double feed : feedsUpTo(reamer.mostFeed())) {
      const auto result = reaming::ream(
          bone,
          h,
          {.feed = feed,
           .mostDepth = kMostDepth,
           .mostForce = 1e6,
           .mostFeed = reamer.mostFeed(),
           .cuttingDamping = reamer.dampingOf(reaming::BoneOptions().cuttingDamping)});
      std::vector<Cell> row{curve.curve, kMillimetres * feed};
      for (const double depth : kDepths) {
        row.push_back(orNothing(reaming::forceAt(result, depth)));
        row.push_back(orNothing(wantedAt(curve, depth)));
      }
      row.push_back(result.removed);
      row.push_back(result.removedShare);
      row.push_back(result.unaccounted);
      table.rows.push_back(std::move(row));
    }
    h += 0.5;
  }
  return table;
}

}  // namespace study::app
