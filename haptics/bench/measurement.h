#pragma once

#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "haptics/timing/stopwatch.h"

namespace haptics::bench {

using timing::Contestant;
using timing::nanosecondsSince;
using timing::Timing;

/// The result of one method in one setting.
struct Measurement {
  std::string family;   ///< "splines", "finite elements", "Kalman filter", "encoder", "refresh" …
  std::string setting;  ///< the test case: "random", "a step, cold"
  std::string method;
  double parameter = 0.0;       ///< value of the varied parameter: nodes, elements, decades …
  std::optional<double> error;  ///< in the unit of the family
  std::optional<double> bound;  ///< largest allowed error, if there is one
  std::optional<Timing> time;

  /// True if the error is within the bound, or there is none; false for NaN.
  bool isWithinBound() const { return !bound || (error && *error <= *bound); }
};

/// Receives measurements, and selects how much is measured.
struct AccuracyRun {
  std::function<void(const Measurement&)> report;
  bool isShortRun = false;  ///< true: measures only errors, and only of small models; for ./check

  /// Times of @p contestants by timing::compareTimes(); std::nullopt in a short run.
  std::vector<std::optional<Timing>> times(const std::vector<Contestant>& contestants) const;
  /// Times with cold caches by timing::compareColdTimes(); std::nullopt in a short run.
  std::vector<std::optional<Timing>> coldTimes(
      const std::vector<Contestant>& contestants, int rounds) const;
};

// Each function reports errors and times of Palpate's method and of others. docs/benchmarks.md
// explains them. All errors are deterministic.

/// Splines through an analytic curve that resembles reaming, 4 to 10,000 nodes: largest error [N].
void measureSplines(const AccuracyRun& run);

/// Force and mesh of the finite elements, N = 5 to 12,445: relative error against 100 decimal
/// digits, also for stiffnesses of elements that differ by up to 24 decades.
void measureFiniteElements(const AccuracyRun& run);

/// A step of the Kalman filter: relative error against 100 decimal digits, and how often a variance
/// is negative.
void measureKalmanFilter(const AccuracyRun& run);

/// Effect of an encoder's resolution on each rendering: RMS difference of the force from that with
/// an ideal encoder, and RMS chatter [N]. No times.
void measureEncoders(const AccuracyRun& run);

/// Times of the punch's three renderings with their mesh (Fig. 12 of the punch paper). No errors.
void measureRefresh(const AccuracyRun& run);

/// Filtering of measured series and choice of nodes: RMS error against the noiseless curve [N], and
/// numbers of nodes.
void measureFilter(const AccuracyRun& run);

/// Bone of spheres: ripple of the area [%], difference from a loop over all spheres; times of
/// contact and removal with warm and cold caches.
void measurePacking(const AccuracyRun& run);

/// Fits of densities: relative error of the force by bounded least squares, conjugate gradients
/// and a particle swarm.
void measureDensity(const AccuracyRun& run);

/// asLine() converts a measurement to a line of text for another process, and fromLine() converts
/// it back. fromLine() returns std::nullopt for a line that is no measurement.
std::string asLine(const Measurement& measurement);
std::optional<Measurement> fromLine(const std::string& line);

/// A measurement that was repeated in several processes. The memory layout of a process is fixed
/// while it runs, and can make that process faster or slower than others.
struct RepeatedMeasurement {
  Measurement measurement;  ///< times are medians over the processes
  double fastest = 0.0;     ///< smallest median of a process [ns]
  double slowest = 0.0;     ///< largest median of a process [ns]
  int processes = 0;
};

/// Merges repeated measurements, in the order in which each first occurs.
std::vector<RepeatedMeasurement> mergedOverProcesses(const std::vector<Measurement>& measurements);

/// Describes the machine and the build: processor, kernel, governor, load, compiler, compared
/// libraries. Pairs of name and text.
std::vector<std::pair<std::string, std::string>> describeMachine();

}  // namespace haptics::bench
