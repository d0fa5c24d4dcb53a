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
  std::string sourceFile{};             ///< without its folder; empty if it was not recorded
  std::vector<RowRange> rows{};         ///< one range, or one for each closure of a mean
  std::vector<std::size_t> closures{};  ///< from 1; empty if rows were chosen
  std::string calibration{};            ///< e.g. `paper-eq1`
  std::string filter{};                 ///< e.g. `authors-fir`
  std::string filterParameters{};       ///< in words
  std::optional<double> slopeLimit{};   ///< [N/travel unit]
  std::vector<std::string> changes{};   ///< changes to the recorded curve
};

/// The four points of a cut, as models::CutDetector finds them; those it did not find are empty.
struct CutLandmarks {
  std::optional<CurvePoint> interception{};  ///< the load begins to rise
  std::optional<CurvePoint> yield{};         ///< the surface is cut through
  std::optional<CurvePoint> bottomOut{};     ///< end of the travel, and the force rises again
  std::optional<CurvePoint> opening{};       ///< the largest force before the contact is lost

  friend bool operator==(const CutLandmarks&, const CutLandmarks&) = default;
};

/// A load that only tissue gives [N]. In the published recordings each yield of meniscus has 3.6 N
/// or more, from interception to yield; the punch alone and a sheet of paper reach 2.7 N before the
/// force falls (3.7 N in one fast closure, which loses all of it on the way).
inline constexpr double kLeastYieldLoad = 3.0;

/// The landmarks of the first cut that is completed along these samples, or of what has happened
/// by their end. Travel and force have the same length and are in the order of time.
///
/// A force that rises and falls while nothing is cut is no yield: where less than a quarter of the
/// load is left while the tool goes on, the finger has only lost the handle.
///
/// @param yieldLoad  the load from interception to yield, at least [N]; 0 accepts every one.
CutLandmarks landmarksAlong(
    std::span<const double> travel,
    std::span<const double> force,
    double yieldLoad = kLeastYieldLoad);

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
  bool isSynthetic = false;  ///< it was not recorded
};

/// What a parametric cut is built from. The defaults are the landmarks of the reference
/// cut, rounded, with a bottom-out half a newton lower so that the cutting through can be felt: the
/// recorded force falls by 0.69 N, hardly more than its sensor errs (0.56 N).
struct CutShape {
  double start = 2.0;  ///< no force from here to the interception [travel units]
  CurvePoint interception{3.8, 0.0};
  CurvePoint yield{7.2, 4.4};
  CurvePoint through{8.4, 3.5};  ///< the fall after the yield is over
  CurvePoint bottomOut{10.3, 3.2};
  CurvePoint end{11.0, 5.0};
  /// Beyond the end, where the jaw opens: over which the force falls to nothing, in a straight
  /// line. 0: the curve stops at the end, as in release 0.1 [travel units], from 0 on
  double release = 0.0;
  double spacing = 0.1;       ///< between nodes, at most [travel units]
  double openingShare = 0.2;  ///< of the closing force that is left while opening, 0 to 1
  double maxSlope = 4.39;     ///< as in ImportOptions [N/travel unit]
};

/// A parametric cut, not recorded: smooth pieces between landmarks, monotone in each.
///
/// Each piece is a cubic Hermite polynomial over s = (x − x₀)/h with h = x₁ − x₀, Δ = (f₁ − f₀)/h,
///
///     f = f₀ + h [ m₀ s(1 − s)² + Δ s²(3 − 2s) − m₁ s²(1 − s) ],   0 ≤ m/Δ ≤ 3 at both ends,
///
/// the bound of Fritsch and Carlson that keeps it monotone. The slope is zero at the interception
/// (the load rises slowly at first, then stiffens), at the yield and at the bottom-out; the Δ of
/// the slow fall where the fast one passes into it; and 1.5 Δ at the end, which is as steep as the
/// last piece gets. Then the slope is limited as everywhere.
///
/// Opening meets the same curve at a share of its force: what is cut does not push back as it did.
///
/// @throws std::invalid_argument  if the travels do not rise from landmark to landmark, the forces
///     do not rise, fall, fall more slowly and rise, a number is not finite or a force negative,
///     or the spacing is not between a ten-thousandth and a tenth of the whole.
/// @throws std::invalid_argument  if the release is negative or no number.
Cut parametricCut(const CutShape& shape = {});

/// The 76 rows of a published recording that the authors' program renders as its table, known by
/// the recorder's clock: 1,820.425 s to 1,820.659 s. They are rows 5900 to 5975 of the file in its
/// folder HAPTIC_RENDERING/MATLAB, and rows 13,486 to 13,561 of the whole recording.
///
/// @return nothing where @p recording is another one.
std::optional<RowRange> publishedCutIn(const Recording& recording);

}  // namespace haptics::recordings
