#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "haptics/recordings/cut.h"
#include "haptics/recordings/recording.h"
#include "haptics/recordings/trace.h"

namespace haptics::recordings {

/// Which cut to take from a recording, and how.
///
/// Closures or rows, not both. Neither takes the closure that is most typical: of the complete
/// closures without a saturated row that whose curve is least far from the mean of all of theirs.
struct ImportOptions {
  std::vector<std::size_t> closures{};  ///< from 1; several become their mean curve
  std::optional<RowRange> rows{};
  std::optional<ForceCalibration> calibration{};  ///< none: calibrationFor() the recording
  TravelFilter filter{};

  /// Where the curve is steeper than this, it is made gentler [N/travel unit]. 4.39 is the largest
  /// stiffness that the punch paper finds in its cuts (V, below eq. (25)) and for which it works
  /// out how much damping the device needs to stay passive. The table that it then renders is as
  /// steep as 18.9 in its noisy end, so that the margin printed was not the margin felt.
  double maxSlope = 4.39;

  double yieldLoad = kLeastYieldLoad;  ///< as in landmarksAlong() [N]

  std::string name{};   ///< empty: the file's name without its ending
  std::string title{};  ///< empty: says which rows of which file it is
};

/// Once closed and opened again: what may be a cut.
///
/// Found on the unfiltered travel, with hysteresis: the tool is closed as soon as the travel is
/// above 7, and open again as soon as it is below 4. The closure begins at the last row with a
/// travel of at most 4 before that, or the first row of the recording (after another closure, the
/// row that ended it), and ends at the first row below 4, or the last row of the recording.
struct Closure {
  RowRange rows{};
  double start = 0.0;             ///< of its first row, by the recorder's clock [s]
  double duration = 0.0;          ///< [s]
  double peakForce = 0.0;         ///< [N]
  std::size_t saturatedRows = 0;  ///< with the force sensor at its end: peakForce is a lower bound
  bool isComplete = false;        ///< neither begins nor ends with the recording; at most 4 s

  /// The closing hand: from the smallest filtered travel since the closure before (the last such
  /// row; a slow hand has tissue in the jaw long before the travel is 4) to the largest within.
  RowRange closing{};

  /// The opening hand: from there to the smallest filtered travel before the next closure.
  RowRange opening{};

  /// On filtered travel, from the end of the closure before on.
  CutLandmarks landmarks{};

  bool isSaturated() const noexcept { return saturatedRows > 0; }
};

inline constexpr double kClosedAbove = 7.0;     ///< [travel units]
inline constexpr double kOpenBelow = 4.0;       ///< [travel units]
inline constexpr double kLongestClosure = 4.0;  ///< of a complete one [s]

/// All closures, in the order of time.
///
/// @param trace  of the same recording.
/// @param yieldLoad  as in landmarksAlong() [N].
std::vector<Closure> closuresOf(
    const Recording& recording, const Trace& trace, double yieldLoad = kLeastYieldLoad);

/// The rows that a cut is made of.
struct CutChoice {
  std::vector<std::size_t> closures{};  ///< from 1; empty if rows were asked for
  std::vector<RowRange> rows{};         ///< the closing part of each closure, or the rows asked for
  std::string reason{};                 ///< why these, in a sentence
};

/// Chooses as the options say; see ImportOptions and importCut().
///
/// @param source  what messages call the recording.
/// @throws UserError, std::invalid_argument  as importCut() does.
CutChoice chooseCut(
    const Trace& trace,
    std::span<const Closure> closures,
    const ImportOptions& options,
    const std::string& source);

/// What to know of a recording before a cut is taken from it.
struct RecordingSurvey {
  std::size_t rows = 0;
  Sampling sampling{};
  std::size_t saturatedRows = 0;     ///< force sensor at its end: clipped peaks, not plateaus
  std::size_t uncalibratedRows = 0;  ///< outside of the calibration; saturated ones among them
  double minForce = 0.0;   ///< the sensor's bias, if the hand released the tool at some time [N]
  double maxForce = 0.0;   ///< [N]
  double minTravel = 0.0;  ///< as recorded [travel units]
  double maxTravel = 0.0;  ///< as recorded [travel units]
  std::size_t distinctTravels = 0;  ///< as recorded: how coarse the potentiometer is
  std::size_t refusedLines = 0;
  std::vector<Closure> closures{};
};

/// @param trace  of the same recording.
/// @param yieldLoad  as in landmarksAlong() [N].
RecordingSurvey summariseCuts(
    const Recording& recording, const Trace& trace, double yieldLoad = kLeastYieldLoad);

/// What was in a recording, what was taken from it and why, and what was changed.
struct ImportReport {
  RecordingSurvey survey{};
  std::vector<std::size_t> closures{};  ///< chosen, from 1; empty if rows were
  std::vector<RowRange> rows{};         ///< that went into the curve
  std::string reason{};                 ///< why these, in a sentence
  std::size_t mergedSamples = 0;        ///< so that the travel rises strictly
  double peakBefore = 0.0;      ///< largest force of the rows; of several closures, their mean [N]
  double peakAfter = 0.0;       ///< largest force of the cut [N]
  std::size_t points = 0;       ///< of the curve
  std::size_t movedPoints = 0;  ///< by limiting the slope, by more than kVisibleShare of the peak
  double slopeBefore = 0.0;     ///< the largest, before it was limited [N/travel unit]
  /// The same over steps of kSlopeStep or more: what neighbouring samples of a tool that stands
  /// still differ by, divided by next to no travel, is noise [N/travel unit].
  double steepness = 0.0;
  double largestChange = 0.0;          ///< by limiting the slope [N]
  double largestChangeAt = 0.0;        ///< [travel units]
  std::vector<double> deviation{};     ///< of a mean: between its closures at each node [N]
  std::vector<std::string> changes{};  ///< all of it in words, what happened to the peak first

  /// Whether the cut differs from the recording by more than kVisibleShare of its peak.
  bool isAltered() const noexcept;
};

/// What "differs visibly" means here: a share of the recorded peak.
inline constexpr double kVisibleShare = 0.05;

/// Over which the steepness of a recording is measured [travel units].
inline constexpr double kSlopeStep = 0.1;

struct ImportedCut {
  Cut cut;
  ImportReport report;
};

/// Takes a cut from a recording: calibrates, filters, chooses, makes the travel strictly rising,
/// limits the slope, and reports all changes.
///
/// @throws UserError  if there is no closure, or none with a requested number; if none can be
/// chosen
///     automatically; if rows are outside the recording, or are no closure; if several closures
///     have no common travel.
/// @throws std::invalid_argument  if both closures and rows are asked for, a closure twice, or the
///     slope limit is not positive and finite.
ImportedCut importCut(const Recording& recording, const ImportOptions& options = {});

}  // namespace haptics::recordings
