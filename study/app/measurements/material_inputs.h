#pragma once

#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "haptics/reaming/material/material_fit.h"
#include "protocols/reading/material_file.h"

namespace study::app {

/// The options of all `material` commands, as they were typed.
struct MaterialInputs {
  std::vector<std::string> files[3];  ///< file names, by test set
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

  const CLI::App* command = nullptr;  ///< for finding out which options were given

  /// Adds the options to the command @p verb; this object must outlive it.
  void addTo(CLI::App& verb);

  /// The options of a fit. @throws UserError  if two options exclude each other.
  haptics::reaming::FitOptions fitOptions() const;
};

/// The measurement series of all test sets.
struct SeriesWithSources {
  std::vector<haptics::reaming::Series> series;
  std::vector<protocols::MaterialSource> sources;  ///< one for each series
  bool isSynthetic = false;                        ///< whether at least one series is synthetic
};

/// @throws UserError  if no file was given, or if a file is no valid series.
SeriesWithSources readAll(const MaterialInputs& inputs);

}  // namespace study::app
