#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/message.h"
#include "haptics/recordings/cut.h"
#include "haptics/recordings/recording.h"
#include "haptics/recordings/trace.h"

namespace haptics::recordings {

/// Which cut to take from a recording, and how.
///
/// At most one of closures and rows is given. Without both, the most typical closure is imported:
/// of the complete closures without a saturated row, the one whose curve differs least (root mean
/// square) from the mean of their curves.
struct ImportOptions {
  /// Numbers from 1; of several closures the mean curve is imported.
  std::vector<std::size_t> closures{};
  std::optional<RowRange> rows{};
  std::optional<ForceCalibration> calibration{};  ///< std::nullopt: calibrationFor(recording)
  TravelFilter filter{};

  /// Largest slope of the imported curve, see limitSlope() [N/travel unit]. 4.39 is the largest
  /// stiffness that the punch paper states for its cuts (section V, below eq. (25)), and for which
  /// it computes the damping that makes the device passive. The table that the authors' program
  /// renders has slopes up to 18.9 at its noisy end, so its margin of passivity was smaller than
  /// the published one.
  double maxSlope = 4.39;

  double yieldLoad = kLeastYieldLoad;  ///< as in landmarksAlong() [N]

  std::string name{};   ///< empty: the file's name without its ending
  std::string title{};  ///< empty: a title that names the file and the rows
};

/// One closing and opening of the tool in a recording: a candidate for a cut.
///
/// Detected on the unfiltered travel, with hysteresis: the tool is closed when the travel exceeds
/// kClosedAbove, and open again when it falls below kOpenBelow. The closure begins at the last row
/// with a travel of at most kOpenBelow before the tool is closed, at the earliest at the first row
/// of the recording or the row that ended the previous closure. It ends at the first row below
/// kOpenBelow, or at the last row of the recording.
struct Closure {
  RowRange rows{};
  double start = 0.0;      ///< time of the first row, by the recorder's clock [s]
  double duration = 0.0;   ///< [s]
  double peakForce = 0.0;  ///< [N]
  /// Rows with a saturated force sensor: peakForce is a lower bound.
  std::size_t saturatedRows = 0;
  bool isComplete = false;  ///< inside the recording, and at most kLongestClosure long

  /// Rows in which the hand closes: from the smallest filtered travel since the previous closure
  /// (the last of such rows; a slow hand has tissue in the jaw long before the travel is 4) to the
  /// largest filtered travel within the closure.
  RowRange closing{};

  /// Rows in which the hand opens: from the end of `closing` to the smallest filtered travel before
  /// the next closure.
  RowRange opening{};

  /// Detected on the filtered travel, from the end of the previous closure on.
  CutLandmarks landmarks{};

  bool isSaturated() const noexcept { return saturatedRows > 0; }
};

inline constexpr double kClosedAbove = 7.0;     ///< [travel units]
inline constexpr double kOpenBelow = 4.0;       ///< [travel units]
inline constexpr double kLongestClosure = 4.0;  ///< longest duration of a complete closure [s]

/// All closures, in the order of time.
///
/// @param trace  of the same recording.
/// @param yieldLoad  as in landmarksAlong() [N].
std::vector<Closure> closuresOf(
    const Recording& recording, const Trace& trace, double yieldLoad = kLeastYieldLoad);

/// The rows that a cut is made of.
struct CutChoice {
  std::vector<std::size_t> closures{};  ///< numbers from 1; empty if rows were requested
  std::vector<RowRange> rows{};         ///< the closing rows of each closure, or the requested rows
  base::Message reason{};               ///< why these were chosen
};

/// Chooses the rows of a cut according to @p options; see importCut().
///
/// @param source  name of the recording in messages.
/// @throws UserError, std::invalid_argument  as importCut() does.
CutChoice chooseCut(
    const Trace& trace,
    std::span<const Closure> closures,
    const ImportOptions& options,
    const std::string& source);

/// Facts about a recording that are needed to choose a cut.
struct RecordingSurvey {
  std::size_t rows = 0;
  Sampling sampling{};
  std::size_t saturatedRows = 0;  ///< rows with a saturated force sensor: their peaks are clipped
  std::size_t uncalibratedRows = 0;  ///< rows outside the calibrated range, saturated ones included
  double minForce = 0.0;  ///< smallest force: the sensor's bias if the hand released the tool [N]
  double maxForce = 0.0;  ///< [N]
  /// Number of different recorded travels: the resolution of the sensor.
  std::size_t distinctTravels = 0;
  std::size_t refusedLines = 0;
  std::vector<Closure> closures{};
};

/// @param trace  of the same recording.
/// @param yieldLoad  as in landmarksAlong() [N].
RecordingSurvey summariseCuts(
    const Recording& recording, const Trace& trace, double yieldLoad = kLeastYieldLoad);

/// The report of an import: the content of the recording, the chosen rows and the reason for the
/// choice, and all changes.
struct ImportReport {
  RecordingSurvey survey{};
  /// Numbers of the chosen closures, from 1; empty if rows were requested.
  std::vector<std::size_t> closures{};
  std::vector<RowRange> rows{};   ///< rows from which the curve was made
  base::Message reason{};         ///< why these were chosen
  std::size_t mergedSamples = 0;  ///< samples merged to make the travel strictly increasing
  double peakBefore = 0.0;        ///< largest force of the rows; mean of several closures [N]
  double peakAfter = 0.0;         ///< largest force of the cut [N]
  std::size_t points = 0;         ///< number of nodes of the curve
  /// Nodes that the slope limit moved by more than kVisibleShare of the peak.
  std::size_t movedPoints = 0;
  double slopeBefore = 0.0;  ///< largest slope before it was limited [N/travel unit]
  /// As slopeBefore, but over travels of kSlopeStep or more: the force difference of neighbouring
  /// samples of a resting tool, divided by almost no travel, is noise [N/travel unit].
  double steepness = 0.0;
  double largestChange = 0.0;    ///< largest change of a node's force by the slope limit [N]
  double largestChangeAt = 0.0;  ///< travel of that node [travel units]
  /// Of a mean curve: standard deviation between the closures at each node [N]
  std::vector<double> deviation{};
  std::vector<base::Message> changes{};  ///< all changes, first that of the peak

  /// Whether the cut differs from the recording by more than kVisibleShare of its peak.
  bool isAltered() const noexcept;
};

/// Fraction of the recorded peak force above which a change counts as visible.
inline constexpr double kVisibleShare = 0.05;

/// Least travel over which ImportReport::steepness is measured [travel units].
inline constexpr double kSlopeStep = 0.1;

struct ImportedCut {
  Cut cut;
  ImportReport report;
};

/// Imports a cut from a recording: calibrates the force, filters the travel, chooses rows, makes
/// the travel strictly increasing, limits the slope, and reports all changes.
///
/// @throws UserError  if there is no closure, or none with a requested number; if none can be
///     chosen automatically; if rows are outside the recording, or are no closure; if several
///     closures have no common travel; or as calibrationFor() and traceOf().
/// @throws std::invalid_argument  if both closures and rows are requested, a closure twice, or the
///     slope limit is not positive and finite.
ImportedCut importCut(const Recording& recording, const ImportOptions& options = {});

}  // namespace haptics::recordings
