#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "haptics/reaming/material/material_fit.h"
#include "haptics/reaming/packing/packed_bone.h"
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

struct FittedMaterial {
  haptics::reaming::MaterialFit fit;
  bool isSynthetic = false;  ///< nobody measured the series
};
/// @param folder  CSV or TSV files, one per series. Each file name contains its test: static,
///                dynamic-1 or dynamic-2.
FittedMaterial fitMaterialTo(
    const std::string& folder,
    const std::string& title,
    const std::string& out,
    const Progress& progress);

/// @param out  a path that ends in .packing.
haptics::reaming::PackedBone buildBoneTo(
    std::size_t spheres, std::uint64_t seed, const std::string& out, const Progress& progress);

}  // namespace study::gui
