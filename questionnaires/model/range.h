#pragma once

#include <optional>

#include "questionnaires/model/instrument.h"

namespace questionnaires {

/// From the lowest answer to the highest, both included.
struct Range {
  double low = 0.0;
  double high = 0.0;

  bool operator==(const Range& other) const = default;
};

/// Where the answers to @p item lie; nothing where they are no numbers.
std::optional<Range> rangeOf(const Item& item) noexcept;

}  // namespace questionnaires
