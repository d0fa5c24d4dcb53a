#pragma once

#include <cstddef>

namespace haptics::recordings {

/// Rows of a recording, numbered from 1, both ends included. Lines that are no rows do not count.
struct RowRange {
  std::size_t first = 0;
  std::size_t last = 0;

  friend bool operator==(const RowRange&, const RowRange&) = default;
};

}  // namespace haptics::recordings
