#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "haptics/recordings/cut_import.h"
#include "haptics/recordings/recording_table.h"
#include "study/model/progress.h"

namespace study::gui {

// The work behind the measurement dialogs, callable from any thread. Each function writes a new
// file, never overwrites one, and returns what describes the result. They throw errors with a
// message for the user, and pass on what @p progress throws.

/// @param columns  of @p recording; std::nullopt: the recorder's five.
/// @return what was changed.
haptics::recordings::ImportReport importCutTo(
    const std::string& recording,
    const std::optional<haptics::recordings::RecordingColumns>& columns,
    const haptics::recordings::ImportOptions& options,
    const std::string& out,
    const Progress& progress);

/// How well the curves of one test describe its series.
struct FittedTest {
  std::string name;
  int series = 0;      ///< number of series that were used
  double depth = 0.0;  ///< depth to which the curves go [m]
  // The largest error of each curve, as a share of the force there, or of 10 N if that is more.
  double minimum = 0.0;
  double average = 0.0;
  double maximum = 0.0;
};
struct FittedMaterial {
  std::vector<FittedTest> tests;
  std::vector<std::string> leftOut;  ///< series that were left out, each with the reason
  bool isSynthetic = false;          ///< nobody measured them
};
/// @param folder  CSV or TSV files, one per series. Each file name contains its test: static,
///                dynamic-1 or dynamic-2.
FittedMaterial fitMaterialTo(
    const std::string& folder,
    const std::string& title,
    const std::string& out,
    const Progress& progress);

struct BuiltBone {
  std::size_t spheres = 0;
  double smallest = 0.0;  ///< radius [m]
  double largest = 0.0;   ///< radius [m]
  double coverage = 0.0;  ///< share of the volume, 0 to 1
  double volume = 0.0;    ///< [m³]
};
/// @param out  a path that ends in .packing.
BuiltBone buildBoneTo(
    std::size_t spheres, std::uint64_t seed, const std::string& out, const Progress& progress);

}  // namespace study::gui
