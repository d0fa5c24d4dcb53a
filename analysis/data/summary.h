#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "analysis/data/moments.h"

namespace analysis {

/// A group in a table: how many, how large on average, how scattered.
struct Summary {
  std::uint64_t n = 0;
  std::optional<double> mean;               ///< nothing for n = 0
  std::optional<double> variance;           ///< with n − 1; nothing for n < 2, or beyond a double
  std::optional<double> standardDeviation;  ///< its root; a double may hold it all the same
};

/// @throws std::invalid_argument  if a value is infinite or no number.
Summary summarise(std::span<const double> values);
Summary summarise(const LikertCounts& counts);
Summary summarise(const Moments& moments);

}  // namespace analysis
