#include "haptics/recordings/published_cut.h"

#include <algorithm>

namespace haptics::recordings {

std::optional<RowRange> publishedCutIn(const Recording& recording) {
  constexpr double kBegin = 1'820'425.0;  // [ms]
  constexpr double kEnd = 1'820'659.0;    // [ms]
  constexpr std::ptrdiff_t kRows = 76;
  const auto& rows = recording.rows;
  const auto first = std::find_if(
      rows.begin(), rows.end(), [](const Recording::Row& row) { return row.time == kBegin; });
  if (rows.end() - first < kRows || first[kRows - 1].time != kEnd) return std::nullopt;
  const auto before = static_cast<std::size_t>(first - rows.begin());
  return RowRange{before + 1, before + kRows};
}

}  // namespace haptics::recordings
