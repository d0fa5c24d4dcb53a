#pragma once

#include <cstdint>
#include <functional>
#include <optional>

#include "haptics/reaming/bone/packing.h"

namespace haptics::reaming {

/// When a body is full. One of count, coverage and smallest radius.
struct PackingOptions {
  std::optional<std::size_t> count;      ///< exact number of spheres
  std::optional<double> coverage;        ///< share of the body, (0, 1)
  std::optional<double> smallestRadius;  ///< no sphere below it [m], > 0
  /// No sphere above it [m]. Left out: 0.95 · (volume / count)^(1/3), 4 times the smallest radius,
  /// or a fiftieth of the body's cube root.
  std::optional<double> largestRadius;
  std::uint64_t seed = 1;
  int threads = 2;  ///< any number; the packing is the same
};

struct PackingProgress {
  std::size_t spheres = 0;
  double coverage = 0.0;
  double radius = 0.0;  ///< that is being looked for room for [m]
};

/// Fills @p body with spheres that do not overlap: pass by pass with smaller radii, each where the
/// room between four neighbours is largest (as ProtoSphere: Weller & Zachmann 2010). Every place is
/// looked at by one block of cells, blocks of one colour of eight at a time: the same seed gives
/// the same packing with any number of threads.
///
/// @param onProgress  is called with the progress; false cancels. May be empty.
/// @return std::nullopt if it was cancelled.
/// @throws std::invalid_argument  if the options are not valid, or the body has no room for what is
/// asked for, in words.
std::optional<Packing> pack(
    const Solid& body,
    const PackingOptions& options,
    const std::function<bool(const PackingProgress&)>& onProgress = {});

}  // namespace haptics::reaming
