#include "study/app/scene_play.h"

#include <cmath>
#include <numbers>

#include "haptics/engine/compiled_scene.h"

namespace study::app {
namespace {

namespace engine = haptics::engine;

/// From 0 to 1 as people move (Flash & Hogan 1985); its greatest speed is 1.875.
double minimumJerk(double tau) {
  return tau * tau * tau * (10.0 - tau * (15.0 - 6.0 * tau));
}

constexpr double kPeakOfMinimumJerk = 1.875;

/// Where a motion is that lasts from 0 to 1, from 0 to 1.
double placeAt(Motion::Shape shape, double tau) {
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
      return 2.0 * kPeakOfMinimumJerk * way / motion.speed;
    case Motion::Shape::Sine:
      return 2.0 * std::numbers::pi * way / motion.speed;
  }
  return 0.0;
}

PlayedCurve alongOne(
    const std::string& condition,
    const std::string& title,
    const engine::SceneSpec& spec,
    const TravelProfile& profile) {
  PlayedCurve curve{.condition = condition, .title = title};
  engine::CompiledScene scene(spec);
  for (const double travel : profile.travel) {
    const auto response = scene.respond({.travel = travel});
    curve.force.push_back(response.isDefined ? response.force : std::nan(""));
    curve.stiffness.push_back(response.isDefined ? response.stiffness : std::nan(""));
  }
  return curve;
}

}  // namespace

TravelProfile profileOf(const Motion& motion) {
  TravelProfile profile{.rate = motion.rate};
  const double seconds = secondsOf(motion);
  const auto steps = static_cast<std::size_t>(std::ceil(seconds * motion.rate));
  for (std::size_t i = 0; i <= steps; ++i) {
    const double tau = std::fmin(static_cast<double>(i) / (motion.rate * seconds), 1.0);
    double travel = motion.least + (motion.most - motion.least) * placeAt(motion.shape, tau);
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
    bool withIngredients) {
  std::vector<PlayedCurve> curves;
  const auto parts = engine::partsOf(spec.model);
  if (withIngredients && parts.filter != nullptr) {
    auto part = spec;
    part.model = *parts.cut;
    curves.push_back(alongOne(condition, "interpolation", part, profile));
    part.model = *parts.elements;
    curves.push_back(alongOne(condition, "finite elements", part, profile));
    for (auto& curve : curves) curve.isIngredient = true;
  }
  curves.push_back(alongOne(condition, title, spec, profile));
  return curves;
}

DataTable asTable(const TravelProfile& profile, const std::vector<PlayedCurve>& curves) {
  DataTable table{.name = "scene"};
  for (const char* name : {"condition", "curve", "time_s", "travel", "force_n", "stiffness"}) {
    table.columns.push_back({.name = name});
  }
  const auto orNothing = [](double value) {
    return std::isfinite(value) ? Cell(value) : Cell(std::monostate());
  };
  for (const auto& curve : curves) {
    for (std::size_t i = 0; i < profile.travel.size(); ++i) {
      table.rows.push_back(
          {curve.condition,
           curve.title,
           static_cast<double>(i) / profile.rate,
           profile.travel[i],
           orNothing(curve.force[i]),
           orNothing(curve.stiffness[i])});
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
    if (curve.isIngredient) series.style = report::ChartSeries::Style::Dashed;
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
