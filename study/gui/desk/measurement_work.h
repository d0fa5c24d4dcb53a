#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

#include "study/model/progress.h"

namespace study::gui {

// What the dialogs about measurements do, in any thread. Each writes a new file, overwrites
// nothing, and says in a few lines what it made. They throw in words, and whatever the progress
// throws.

/// @param cut  its number in the recording, from 1; nothing: the most typical one.
std::string importCutTo(
    const std::string& recording,
    std::optional<std::size_t> cut,
    const std::string& out,
    const Progress& progress);

/// @param folder  of series, CSV or TSV, each with its test in its name: static, dynamic-1,
///                dynamic-2.
std::string fitMaterialTo(
    const std::string& folder,
    const std::string& title,
    const std::string& out,
    const Progress& progress);

/// @param out  ends in .packing.
std::string buildBoneTo(
    std::size_t spheres, std::uint64_t seed, const std::string& out, const Progress& progress);

}  // namespace study::gui
