#pragma once

#include <cstdint>
#include <functional>
#include <optional>

#include "haptics/reaming/bone/packing.h"

namespace haptics::reaming {

/// Options of pack(). Exactly one of count, coverage and smallestRadius is given; it decides when
/// the packing is complete.
struct PackingOptions {
  std::optional<std::size_t> count;      ///< exact number of spheres
  std::optional<double> coverage;        ///< fraction of the body's volume, (0, 0.8]
  std::optional<double> smallestRadius;  ///< radius of the smallest sphere [m], > 0
  /// Radius of the largest sphere [m]. Default: 0.95 · (volume / count)^(1/3) with a count, 4 ·
  /// smallestRadius with a smallest radius, else 1/50 of the cube root of the body's volume.
  std::optional<double> largestRadius;
  std::uint64_t seed = 1;
  int threads = 2;  ///< the packing does not depend on it
};

struct PackingProgress {
  std::size_t spheres = 0;
  double coverage = 0.0;
  double radius = 0.0;  ///< least radius of the present pass [m]
};

/// Fills @p body with spheres that do not overlap: in passes with decreasing radii, each sphere
/// where the space between four neighbours is locally largest (as ProtoSphere: Weller & Zachmann
/// 2010). Blocks of cells are filled in parallel, in eight colours of blocks that are not
/// neighbours, so that the packing depends on the seed but not on the number of threads.
///
/// @param onProgress  called with the progress; returns false to cancel. May be empty.
/// @return std::nullopt if cancelled.
/// @throws std::invalid_argument  with a message, if the options are not valid or the body is too
/// small for them.
std::optional<Packing> pack(
    const Solid& body,
    const PackingOptions& options,
    const std::function<bool(const PackingProgress&)>& onProgress = {});

}  // namespace haptics::reaming
