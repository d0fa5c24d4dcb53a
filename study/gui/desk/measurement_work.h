#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

#include "study/model/progress.h"

namespace study::gui {

// The work behind the measurement dialogs, callable from any thread. Each function writes a new
// file, never overwrites one, and returns a few lines that describe the result. They throw errors
// with a message for the user, and pass on what @p progress throws.

/// @param columns  a columns file that describes @p recording; empty: the recorder's five columns.
/// @param cut  its number in the recording, from 1; nothing: the most typical cut.
std::string importCutTo(
    const std::string& recording,
    const std::string& columns,
    std::optional<std::size_t> cut,
    const std::string& out,
    const Progress& progress);

/// @param folder  CSV or TSV files, one per series. Each file name contains its test: static,
///                dynamic-1 or dynamic-2.
std::string fitMaterialTo(
    const std::string& folder,
    const std::string& title,
    const std::string& out,
    const Progress& progress);

/// @param out  a path that ends in .packing.
std::string buildBoneTo(
    std::size_t spheres, std::uint64_t seed, const std::string& out, const Progress& progress);

}  // namespace study::gui
