#pragma once

#include <optional>
#include <span>

#include "haptics/recordings/curve_point.h"

namespace haptics::recordings {

/// The four points of a cut, as models::CutDetector finds them; those it did not find are empty.
struct CutLandmarks {
  std::optional<CurvePoint> interception{};  ///< the load begins to rise
  std::optional<CurvePoint> yield{};         ///< the surface is cut through
  std::optional<CurvePoint> bottomOut{};     ///< end of the travel, and the force rises again
  std::optional<CurvePoint> opening{};       ///< the largest force before the contact is lost

  friend bool operator==(const CutLandmarks&, const CutLandmarks&) = default;
};

/// The landmarks of the first cut that is completed along these samples, or of what has happened
/// by their end. Both are equally long, in the order of time.
CutLandmarks landmarksAlong(std::span<const double> travel, std::span<const double> force);

}  // namespace haptics::recordings
