#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "haptics/recordings/row_range.h"

namespace haptics::recordings {

/// Where a cut comes from and what was done to it, complete enough to do it again.
struct Provenance {
  std::string statement{};              ///< in a sentence
  std::string sourceFile{};             ///< without its folder; empty if nobody recorded it
  std::vector<RowRange> rows{};         ///< one range, or one for each closure of a mean
  std::vector<std::size_t> closures{};  ///< from 1; empty if rows were chosen
  std::string calibration{};            ///< e.g. `paper-eq1`
  std::string filter{};                 ///< e.g. `authors-fir`
  std::string filterParameters{};       ///< in words
  std::optional<double> slopeLimit{};   ///< [N/travel unit]
  std::vector<std::string> changes{};   ///< what the curve no longer says as it was recorded
};

}  // namespace haptics::recordings
