#include "study/app/scene_play.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "haptics/engine/compiled_scene.h"
#include "study/model/user_error.h"

namespace study::app {
namespace {

namespace engine = haptics::engine;

/// A minimum-jerk movement from 0 to 1 (Flash & Hogan 1985). Its largest speed is 1.875 per unit of
/// time.
double minimumJerk(double tau) {
  return tau * tau * tau * (10.0 - tau * (15.0 - 6.0 * tau));
}

constexpr double kPeakSpeedOfMinimumJerk = 1.875;

/// The position, 0 to 1, at time @p tau, 0 to 1.
double positionAt(Motion::Shape shape, double tau) {
  switch (shape) {
    case Motion::Shape::Closing:
      return tau;
    case Motion::Shape::Cut:
      return tau < 0.5 ? minimumJerk(2.0 * tau) : minimumJerk(2.0 - 2.0 * tau);
    case Motion::Shape::Sine:
      return 0.5 - 0.5 * std::cos(4.0 * std::numbers::pi * tau);
  }
  return 0.0;
}

double secondsOf(const Motion& motion) {
  const double way = motion.most - motion.least;
  switch (motion.shape) {
    case Motion::Shape::Closing:
      return way / motion.speed;
    case Motion::Shape::Cut:
      return 2.0 * kPeakSpeedOfMinimumJerk * way / motion.speed;
    case Motion::Shape::Sine:
      return 2.0 * std::numbers::pi * way / motion.speed;
  }
  return 0.0;
}

/// Repeats the first step until the scene is ready, as if the hand waited before a trial. A bone
/// gives no force until the tool is known to be outside of all its spheres, of which each tick
/// checks some. Other scenes are ready at once.
haptics::models::Response<double> firstResponse(
    engine::CompiledScene& scene, const engine::ToolState& first) {
  constexpr double kLongest = 10.0;  // [s]: enough to check 20 million spheres
  auto response = scene.respond(first);
  for (double waited = 0.0; !scene.isReady() && waited < kLongest; waited += first.dt) {
    response = scene.respond(first);
  }
  return response;
}

PlayedCurve playOne(
    const std::string& condition,
    const std::string& title,
    const engine::SceneSpec& spec,
    const TravelProfile& profile) {
  PlayedCurve curve{.condition = condition, .title = title};
  engine::CompiledScene scene(spec);
  engine::ToolState tool{.travel = profile.travel.front(), .dt = 1.0 / profile.rate};
  for (std::size_t i = 0; i < profile.travel.size(); ++i) {
    tool.velocity = (profile.travel[i] - tool.travel) * profile.rate;
    tool.travel = profile.travel[i];
    const auto response = i == 0 ? firstResponse(scene, tool) : scene.respond(tool);
    curve.force.push_back(response.isDefined ? response.force : std::nan(""));
    curve.stiffness.push_back(response.isDefined ? response.stiffness : std::nan(""));
  }
  return curve;
}

/// @throws UserError  if the scene gives a force in less than half of the steps.
void checkNotEmpty(const PlayedCurve& curve, const TravelProfile& profile) {
  const auto answered = static_cast<std::size_t>(
      std::ranges::count_if(curve.force, [](double force) { return std::isfinite(force); }));
  if (2 * answered >= curve.force.size()) return;
  throw UserError(fmt::format(
      "Condition '{}' answers with a force at {} of {} steps only, so there is nothing to draw. A "
      "bone that is reamed answers after the tool has been outside of it: let the motion begin "
      "there (it begins at a travel of {:g}).",
      curve.condition,
      answered,
      curve.force.size(),
      profile.travel.front()));
}

}  // namespace

TravelProfile profileOf(const Motion& motion) {
  TravelProfile profile{.rate = motion.rate};
  const double seconds = secondsOf(motion);
  const auto steps = static_cast<std::size_t>(std::ceil(seconds * motion.rate));
  for (std::size_t i = 0; i <= steps; ++i) {
    const double tau = std::fmin(static_cast<double>(i) / (motion.rate * seconds), 1.0);
    double travel = motion.least + (motion.most - motion.least) * positionAt(motion.shape, tau);
    if (motion.quantum > 0.0) travel = motion.quantum * std::round(travel / motion.quantum);
    profile.travel.push_back(travel);
  }
  return profile;
}

std::vector<PlayedCurve> play(
    const std::string& condition,
    const std::string& title,
    const engine::SceneSpec& spec,
    const TravelProfile& profile,
    bool withFilterInputs) {
  std::vector<PlayedCurve> curves;
  const auto parts = engine::partsOf(spec.model);
  if (withFilterInputs && parts.filter != nullptr) {
    auto part = spec;
    part.model = *parts.cut;
    curves.push_back(playOne(condition, "interpolation", part, profile));
    part.model = *parts.elements;
    curves.push_back(playOne(condition, "finite elements", part, profile));
    for (auto& curve : curves) curve.isFilterInput = true;
  }
  curves.push_back(playOne(condition, title, spec, profile));
  checkNotEmpty(curves.back(), profile);
  return curves;
}

DataTable asTable(const TravelProfile& profile, const std::vector<PlayedCurve>& curves) {
  DataTable table{.name = "scene"};
  for (const char* name : {"condition", "curve", "time_s", "travel", "force_n", "stiffness"}) {
    table.columns.push_back({.name = name});
  }
  for (const auto& curve : curves) {
    for (std::size_t i = 0; i < profile.travel.size(); ++i) {
      table.rows.push_back(
          {curve.condition,
           curve.title,
           static_cast<double>(i) / profile.rate,
           profile.travel[i],
           finiteCell(curve.force[i]),
           finiteCell(curve.stiffness[i])});
    }
  }
  return table;
}

report::Chart asChart(
    const TravelProfile& profile,
    const std::vector<PlayedCurve>& curves,
    const haptics::devices::DeviceKind& device,
    bool isOverTime) {
  const double scale = device.shown.factor;
  report::Chart chart;
  chart.x.title = isOverTime ? "time [s]" : device.shown.axis;
  chart.y.title = "force [N]";
  for (const auto& curve : curves) {
    report::ChartSeries series{.title = curve.title};
    if (curve.isFilterInput) series.style = report::ChartSeries::Style::Dashed;
    for (std::size_t i = 0; i < profile.travel.size(); ++i) {
      const double x =
          isOverTime ? static_cast<double>(i) / profile.rate : scale * profile.travel[i];
      series.points.push_back({x, curve.force[i]});
    }
    chart.series.push_back(std::move(series));
  }
  return chart;
}

}  // namespace study::app
