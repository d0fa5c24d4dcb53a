#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "haptics/recordings/closure.h"
#include "haptics/recordings/import_options.h"
#include "haptics/recordings/trace.h"

namespace haptics::recordings {

/// The rows that a cut is made of.
struct CutChoice {
  std::vector<std::size_t> closures{};  ///< from 1; empty if rows were asked for
  std::vector<RowRange> rows{};         ///< the closing branch of each closure, or the rows
  std::string reason{};                 ///< why these, in a sentence
};

/// Chooses as the options say; see ImportOptions and importCut().
///
/// @param source  what messages call the recording.
/// @throws Error, std::invalid_argument  as importCut() does.
CutChoice chooseCut(
    const Trace& trace,
    std::span<const Closure> closures,
    const ImportOptions& options,
    const std::string& source);

}  // namespace haptics::recordings
