#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "haptics/recordings/force_curve.h"
#include "haptics/recordings/recording.h"

namespace haptics::recordings {

/// The origin of a cut and how it was processed, complete enough to reproduce it.
struct Provenance {
  std::string statement{};       ///< a sentence that describes the origin
  std::string sourceFile{};      ///< file name without folder; empty if the cut was not recorded
  std::vector<RowRange> rows{};  ///< one range, or one per closure of a mean
  std::vector<std::size_t> closures{};  ///< numbers from 1; empty if rows were chosen
  std::string calibration{};            ///< e.g. `paper-eq1`
  std::string filter{};                 ///< e.g. `authors-fir`
  std::string filterParameters{};       ///< a description of the filter's parameters
  std::optional<double> slopeLimit{};   ///< [N/travel unit]
  std::vector<std::string> changes{};   ///< changes to the recorded curve
};

/// The four landmarks of a cut, as models::CutDetector defines them; std::nullopt if not found.
struct CutLandmarks {
  std::optional<CurvePoint> interception{};  ///< the load begins to rise
  std::optional<CurvePoint> yield{};         ///< the surface is cut through
  std::optional<CurvePoint> bottomOut{};     ///< at the end of the travel, the force rises again
  std::optional<CurvePoint> opening{};       ///< the largest force before the contact is lost

  friend bool operator==(const CutLandmarks&, const CutLandmarks&) = default;
};

/// Default for the least load from interception to yield [N]; only tissue reaches it. In the
/// published recordings each yield of meniscus has 3.6 N or more; the empty punch and a sheet of
/// paper reach 2.7 N before the force falls (3.7 N in one fast closure, in which the force then
/// falls to zero).
inline constexpr double kLeastYieldLoad = 3.0;

/// The landmarks of the first completed cut in the samples, or of the incomplete cut at their end.
/// Travel [travel units] and force [N] have the same length and are in the order of time.
///
/// A yield whose force falls below a quarter of the load while the tool closes further is rejected:
/// the finger has only lost contact with the handle.
///
/// @param yieldLoad  least load from interception to yield [N]; 0 accepts any.
CutLandmarks landmarksAlong(
    std::span<const double> travel,
    std::span<const double> force,
    double yieldLoad = kLeastYieldLoad);

/// A cut that can be rendered: the content of a cut file.
struct Cut {
  std::string name{};                ///< used in files and protocols
  std::string title{};               ///< as shown to users
  std::string unit = "travel_unit";  ///< unit of all travels in the cut
  ForceCurve curve;
  std::optional<ForceCurve> opening{};  ///< the opening branch
  CutLandmarks landmarks{};             ///< before the slope was limited
  Provenance provenance{};
  bool isSynthetic = false;  ///< not recorded
};

/// Parameters of a parametric cut. The defaults are the rounded landmarks of the reference cut,
/// with a bottom-out half a newton lower, so that the cutting through can be felt: the recorded
/// force falls by 0.69 N, hardly more than the error of its sensor (0.56 N).
struct CutShape {
  double start = 2.0;  ///< begin of the curve; no force up to the interception [travel units]
  CurvePoint interception{3.8, 0.0};
  CurvePoint yield{7.2, 4.4};
  CurvePoint through{8.4, 3.5};  ///< the fast fall after the yield ends here
  CurvePoint bottomOut{10.3, 3.2};
  CurvePoint end{11.0, 5.0};
  /// Travel beyond the end over which the force falls linearly to 0 [travel units], >= 0. 0: the
  /// curve stops at the end, as in release 0.1.
  double release = 0.0;
  double spacing = 0.1;       ///< largest distance of two nodes [travel units]
  double openingShare = 0.2;  ///< opening force / closing force, 0 to 1
  double maxSlope = 4.39;     ///< as in ImportOptions [N/travel unit]
};

/// Builds a parametric cut: smooth, monotone pieces between landmarks.
///
/// Each piece is a cubic Hermite polynomial over s = (x − x₀)/h with h = x₁ − x₀, Δ = (f₁ − f₀)/h,
///
///     f = f₀ + h [ m₀ s(1 − s)² + Δ s²(3 − 2s) − m₁ s²(1 − s) ],   0 ≤ m/Δ ≤ 3 at both ends,
///
/// with the bound of Fritsch and Carlson for monotonicity. The slope is 0 at the interception (the
/// load rises slowly at first), at the yield and at the bottom-out; at `through` it is the Δ of the
/// slow fall; at the end it is 1.5 Δ, the largest slope of the last piece. Finally limitSlope()
/// applies maxSlope.
///
/// The opening branch is the same curve times openingShare, since cut tissue resists less.
///
/// @throws std::invalid_argument  if the travels do not increase from landmark to landmark, the
///     forces do not rise, fall, fall more slowly and rise, a number is not finite or a force
///     negative, or the spacing is not between 1/10,000 and 1/10 of the whole travel.
/// @throws std::invalid_argument  if the release is negative or not finite, or openingShare is not
///     between 0 and 1.
Cut parametricCut(const CutShape& shape = {});

/// Finds the 76 rows of a published recording that the authors' program renders as its table. They
/// are identified by the recorder's clock, 1,820.425 s to 1,820.659 s: rows 5900 to 5975 of the
/// file in the program's folder HAPTIC_RENDERING/MATLAB, 13,486 to 13,561 of the whole recording.
///
/// @return std::nullopt if @p recording is another one.
std::optional<RowRange> publishedCutIn(const Recording& recording);

}  // namespace haptics::recordings
