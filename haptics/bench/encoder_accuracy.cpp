#include <cmath>

#include "haptics/bench/measurement.h"
#include "haptics/engine/built_in_models.h"
#include "haptics/engine/compiled_scene.h"
#include "haptics/filters/averages.h"

namespace haptics::bench {
namespace {

/// A closing at constant speed from 2 to 10.5 travel units, seen through an encoder.
struct Closing {
  double speed = 10.0;   ///< [travel units/s]
  double rate = 1000.0;  ///< [Hz]
  double quantum = 0.0;  ///< resolution of the encoder [travel units]

  std::vector<double> forcesOf(const engine::SceneSpec& spec) const {
    engine::CompiledScene scene(spec);
    std::vector<double> forces;
    const int steps = static_cast<int>(8.5 / speed * rate);
    for (int i = 0; i < steps; ++i) {
      double travel = 2.0 + speed * i / rate;
      if (quantum > 0.0) travel = quantum * std::round(travel / quantum);
      forces.push_back(scene.respond({.travel = travel}).force);
    }
    return forces;
  }
};

/// RMS of the second difference of the force, scaled to the amplitude of a square wave [N]: what a
/// hand feels as a buzz.
double rmsChatter(const std::vector<double>& forces) {
  double sum = 0.0;
  for (std::size_t i = 2; i < forces.size(); ++i) {
    const double bend = forces[i] - 2.0 * forces[i - 1] + forces[i - 2];
    sum += bend * bend / 16.0;  // gives 1 for a square wave of amplitude 1
  }
  return std::sqrt(sum / static_cast<double>(forces.size() - 2));
}

}  // namespace

void measureEncoders(const AccuracyRun& run) {
  using models::KalmanScheme;
  const std::pair<const char*, engine::SceneSpec> scenes[]{
      {"interpolation", {.model = engine::publishedInterpolation()}},
      {"finite elements", {.model = engine::publishedElements(5)}},
      {"filter, paper-text", {.model = engine::publishedFilter(KalmanScheme::PaperText, 5)}},
      {"filter, authors-firmware",
       {.model = engine::publishedFilter(KalmanScheme::AuthorsFirmware, 5)}},
      {"filter, sequential", {.model = engine::publishedFilter(KalmanScheme::Sequential, 5)}},
      {"filter, space-domain", {.model = engine::publishedFilter(KalmanScheme::SpaceDomain, 5)}}};
  for (const auto& [name, spec] : scenes) {
    for (const double speed : {1.0, 10.0, 57.0}) {
      const auto ideal = Closing{.speed = speed}.forcesOf(spec);
      for (const double quantum : {0.0, 0.0439, 0.176}) {
        const auto felt = Closing{.speed = speed, .quantum = quantum}.forcesOf(spec);
        const std::string at = std::to_string(static_cast<int>(speed)) + " travel units/s";
        run.report(
            {.family = "encoder",
             .setting = "RMS difference from an ideal encoder [N], " + at,
             .method = name,
             .parameter = quantum,
             .error = filters::rmsDifference(felt, ideal)});
        run.report(
            {.family = "encoder",
             .setting = "RMS chatter [N], " + at,
             .method = name,
             .parameter = quantum,
             .error = rmsChatter(felt)});
      }
    }
  }
}

}  // namespace haptics::bench
