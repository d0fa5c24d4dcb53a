#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "haptics/recordings/force_curve.h"
#include "haptics/recordings/recording.h"

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

/// One cut, ready to be felt: the content of a cut file.
struct Cut {
  std::string name{};   ///< for files and protocols
  std::string title{};  ///< for people
  std::string unit =
      "travel_unit";  ///< of every travel in it, until a laboratory supplies a factor
  ForceCurve curve;
  std::optional<ForceCurve> opening{};  ///< what was recorded while the tool opened again
  CutLandmarks landmarks{};             ///< as measured, before the slope was limited
  Provenance provenance{};
  bool isSynthetic = false;  ///< nobody recorded it
};

}  // namespace haptics::recordings
