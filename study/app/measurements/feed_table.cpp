#include "study/app/measurements/feed_table.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <fmt/format.h>

#include "haptics/engine/reamed_material.h"
#include "study/app/measurements/figure_lines.h"

namespace study::app {
namespace {

namespace reaming = haptics::reaming;

constexpr double kDepths[]{0.004, 0.006, 0.008};  // [m]
constexpr double kMostDepth = 0.010;              // [m]

/// The feeds of the published measurements, then larger ones in steps of about a factor of 3, up to
/// 0.9 of the reamer's feed limit @p most [m/s]. At the limit itself the reamer would never remove
/// bone as fast as the machine advances.
std::vector<double> feedsUpTo(double most) {
  const double last = 0.9 * most;
  std::vector<double> feeds;
  for (const double feed : {0.01e-3, 0.03e-3, 0.1e-3, 0.3e-3, 1e-3, 3e-3, 10e-3}) {
    if (feed < last) feeds.push_back(feed);
  }
  if (std::isfinite(last) && last > 0.0) feeds.push_back(last);
  return feeds;
}

/// The force of the fitted curve at @p depth [m], interpolated linearly [N].
double curveForceAt(const reaming::CurveFit& curve, double depth) {
  return reaming::forceAt({.depth = curve.depths, .force = curve.wanted, .stop = {}}, depth);
}

/// The columns of the table.
DataTable emptyTable(const haptics::engine::Reamer& reamer, const char* mass) {
  DataTable table{
      .name = "feeds",
      .description = fmt::format(
          "Force by feed: reamed to {:g} mm with {:g} turns a second, {} teeth and {:g} mm per "
          "tooth, at most {:.3g} mm/s. {}",
          kMillimetres * kMostDepth,
          reamer.speed,
          reamer.teeth,
          kMillimetres * reamer.feedPerTooth,
          kMillimetres * reamer.mostFeed(),
          mass),
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
  return table;
}

/// @param wanted  returns the force of the curve at a depth [N].
template <typename Wanted>
std::vector<Cell> rowOf(
    const std::string& curve,
    double feed,
    const reaming::ExperimentResult& result,
    const Wanted& wanted) {
  std::vector<Cell> row{curve, kMillimetres * feed};
  for (const double depth : kDepths) {
    row.push_back(finiteCell(reaming::forceAt(result, depth)));
    row.push_back(finiteCell(wanted(depth)));
  }
  for (const double value : {result.removed, result.removedShare, result.unaccounted}) {
    row.push_back(finiteCell(value));
  }
  return row;
}

/// ∫ F dz of a curve from its beginning to @p depth [N·m].
double workTo(const reaming::CurveNodes& curve, double depth) {
  constexpr int kSteps = 10'000;
  const double begin = curve.front().position;
  const double step = (depth - begin) / kSteps;
  double work = 0.0;
  for (int i = 0; i < kSteps; ++i) work += reaming::forceOf(curve, begin + (i + 0.5) * step) * step;
  return work;
}

/// Reams the curve of a bone of hardness @p h at a constant feed of the tool, with the engine's
/// model.
reaming::ExperimentResult ream(
    const reaming::HardnessCurves& force,
    double h,
    double feed,
    const haptics::engine::Reamer& reamer) {
  using Model = haptics::engine::ReamedMaterialModel;
  constexpr double kStep = 4e-6;  // advance of the tool per step [m]
  const auto curve = reaming::curveOf(force, h);
  const double begin = curve.front().position;
  const double end = std::min(begin + kMostDepth, curve.back().position);
  Model model(
      {.nodes = {}, .curves = force, .torque = {}, .hardness = h, .isRemoved = true}, reamer);
  reaming::ExperimentResult result{.depth = {}, .force = {}, .stop = "the largest depth"};
  const double damping = reamer.cuttingDampingOf(Model::kCuttingDamping);
  double work = 0.0;
  double lost = 0.0;
  double felt = 0.0;
  for (double target = begin + kStep; model.depth() < end; target += kStep) {
    // The machine also advances by the deflection of the coupling, as if the coupling were
    // infinitely stiff.
    const double before = model.depth();
    const double dt = kStep / feed;
    felt = model.respond({.travel = target + felt / Model::kCoupling, .dt = dt}).force;
    const double advance = model.depth() - before;
    if (!(advance > 0.0)) continue;
    work += felt * advance;
    lost += damping * advance / dt * advance;
    result.depth.push_back(model.depth());
    result.force.push_back(felt);
  }
  result.removed = workTo(curve, model.depth());
  result.removedShare = result.removed / workTo(curve, curve.back().position);
  result.unaccounted = std::abs(work - lost - result.removed) / result.removed;
  return result;
}

}  // namespace

DataTable feedTable(
    const reaming::PackedBone& bone,
    const reaming::BoneFitReport& fit,
    const haptics::engine::Reamer& reamer) {
  auto table = emptyTable(reamer, "Mass is density times volume: the work of removal.");
  double h = 0.0;
  for (const auto& curve : fit.curves) {
    for (const double feed : feedsUpTo(reamer.mostFeed())) {
      const auto result = reaming::ream(
          bone,
          h,
          {.feed = feed,
           .mostDepth = kMostDepth,
           .largestForce = 1e6,
           .mostFeed = reamer.mostFeed(),
           .cuttingDamping = reamer.cuttingDampingOf(reaming::BoneOptions().cuttingDamping)});
      table.rows.push_back(rowOf(
          curve.curve, feed, result, [&](double depth) { return curveForceAt(curve, depth); }));
    }
    h += 0.5;
  }
  return table;
}

DataTable feedTable(
    const reaming::HardnessCurves& force,
    const std::string& middle,
    const haptics::engine::Reamer& reamer) {
  auto table = emptyTable(reamer, "The mass of a curve is the work of its removal.");
  double h = 0.0;
  for (const std::string& name : {std::string("minimum"), middle, std::string("maximum")}) {
    const auto curve = reaming::curveOf(force, h);
    for (const double feed : feedsUpTo(reamer.mostFeed())) {
      table.rows.push_back(rowOf(name, feed, ream(force, h, feed, reamer), [&](double depth) {
        return reaming::forceOf(curve, depth);
      }));
    }
    h += 0.5;
  }
  return table;
}

}  // namespace study::app
