#pragma once

#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "haptics/reaming/material/material_fit.h"
#include "protocols/reading/material_file.h"

namespace study::app {

/// The series and the choices that the commands of `material` share, as they were typed.
struct MaterialInputs {
  std::vector<std::string> files[3];  ///< by test set
  std::vector<std::string> columns;
  std::vector<std::string> units;
  std::string axis = "depth";
  std::string cutoffRule = "detrended-hann";
  std::string envelope = "pointwise";
  std::string nodes = "greedy";
  std::string spline = "hermite-data-slope";
  std::string nodesOf;
  bool isSynthetic = false;
  haptics::reaming::FitOptions options;

  /// Adds the options to @p verb; this outlives it.
  void addTo(CLI::App& verb);

  /// What was chosen. @throws UserError  where two choices exclude each other.
  haptics::reaming::FitOptions chosen(const CLI::App& verb) const;
};

/// The series of all test sets.
struct ReadSeries {
  std::vector<haptics::reaming::Series> series;
  std::vector<protocols::MaterialSource> sources;  ///< of each
  bool isSynthetic = false;                        ///< one of them is
};

/// @throws UserError  where no file was named; haptics::recordings::Error where one is no series.
ReadSeries readAll(const MaterialInputs& inputs);

}  // namespace study::app
