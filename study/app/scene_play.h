#pragma once

#include <string>
#include <vector>

#include "haptics/engine/scene_spec.h"
#include "study/model/data_table.h"
#include "study/report/chart.h"

namespace study::app {

/// The travel of a tool, sampled at a fixed rate.
struct TravelProfile {
  double rate = 1000.0;        ///< [Hz], > 0
  std::vector<double> travel;  ///< [device's travel unit]
};

/// A simulated movement of the hand.
struct Motion {
  enum class Shape { Closing, Cut, Sine };  ///< see profileOf()
  Shape shape = Shape::Closing;
  double least = 0.0;    ///< smallest travel [device's travel unit]
  double most = 10.0;    ///< largest travel [device's travel unit]
  double speed = 57.0;   ///< Closing: constant; Cut, Sine: maximum [travel unit/s], > 0
  double rate = 1000.0;  ///< of the steps [Hz], > 0
  double quantum = 0.0;  ///< resolution of the encoder [travel unit]; 0: exact
};

/// Closing goes from the least to the largest travel at constant speed; Cut closes and opens again
/// with minimum jerk; Sine goes back and forth twice.
TravelProfile profileOf(const Motion& motion);

/// One curve of a played scene.
struct PlayedCurve {
  std::string condition;          ///< condition's id
  std::string title;              ///< for the legend
  std::vector<double> force;      ///< desired by the scene at each step [N]; NaN if undefined
  std::vector<double> stiffness;  ///< [N per travel unit]
  bool isFilterInput = false;     ///< whether it is one of the two forces that a filter combines
};

/// Plays @p spec along @p profile; with @p withFilterInputs also the two forces that a filter
/// combines. The tool stays at the first travel until the scene is ready.
/// @throws UserError  if the scene gives a force in less than half of the steps.
std::vector<PlayedCurve> play(
    const std::string& condition,
    const std::string& title,
    const haptics::engine::SceneSpec& spec,
    const TravelProfile& profile,
    bool withFilterInputs);

/// A table `condition, curve, time_s, travel, force_n, stiffness` with a row for each step of each
/// curve.
DataTable asTable(const TravelProfile& profile, const std::vector<PlayedCurve>& curves);

/// The force over travel, or over time if @p isOverTime.
report::Chart asChart(
    const TravelProfile& profile,
    const std::vector<PlayedCurve>& curves,
    const haptics::devices::DeviceKind& device,
    bool isOverTime);

}  // namespace study::app
