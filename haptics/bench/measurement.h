#pragma once

#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "haptics/timing/stopwatch.h"

namespace haptics::bench {

using timing::Contestant;
using timing::Timing;

/// The result of one method in one setting.
struct Measurement {
  std::string family;   ///< "splines", "finite elements", "Kalman filter", "encoder", "refresh" …
  std::string setting;  ///< what was done: "random", "a step, cold"
  std::string method;
  double parameter = 0.0;       ///< what is swept: nodes, elements, decades …
  std::optional<double> error;  ///< in the unit of the setting
  std::optional<double> bound;  ///< that the error must not exceed, where it has one
  std::optional<Timing> time;

  /// True without a bound, too. NaN is within no bound.
  bool isWithinBound() const { return !bound || (error && *error <= *bound); }
};

/// Where measurements go, and how much is measured.
struct AccuracyRun {
  std::function<void(const Measurement&)> report;
  bool isShort = false;  ///< errors only, of small models: for ./check

  /// Times of contestants beside each other, see timing::compareTimes(); none in a short run.
  std::vector<std::optional<Timing>> times(const std::vector<Contestant>& contestants) const;
  /// The same with cold caches, see timing::compareColdTimes().
  std::vector<std::optional<Timing>> coldTimes(
      const std::vector<Contestant>& contestants, int rounds) const;
};

// Each family reports errors and times of our method and of its peers. docs/benchmarks.md says what
// they mean. All errors are deterministic.

/// Splines over an analytic curve of reaming's shape, 4 to 10,000 nodes: largest error [N].
void measureSplines(const AccuracyRun& run);

/// Force and mesh of the finite elements, N = 5 to 12,445: error relative to 100 decimal digits,
/// also where the stiffnesses of elements differ by up to 24 decades.
void measureFiniteElements(const AccuracyRun& run);

/// A step of the filter: error relative to 100 decimal digits, and how often a variance is
/// negative.
void measureKalmanFilter(const AccuracyRun& run);

/// What an encoder's resolution does to each rendering: RMS difference of the force from that of an
/// ideal encoder, and RMS chatter [N]. No times.
void measureEncoders(const AccuracyRun& run);

/// Times of the punch's three renderings with their mesh (Fig. 12 of the punch paper). No errors.
void measureRefresh(const AccuracyRun& run);

/// From a measured series to nodes: RMS error against the noiseless curve [N], numbers of nodes.
void measureFilter(const AccuracyRun& run);

/// Bone of spheres: area ripple [%], difference from a loop over all spheres; contact and removal,
/// warm and cold.
void measurePacking(const AccuracyRun& run);

/// Densities of spheres: relative error of the force by bounded least squares, MLEM, conjugate
/// gradients and a particle swarm.
void measureDensity(const AccuracyRun& run);

/// A measurement on one line, for another process to read; and back. std::nullopt for any other
/// line.
std::string asLine(const Measurement& measurement);
std::optional<Measurement> fromLine(const std::string& line);

/// The same measurement by several processes. The addresses of a process stay the same as long as
/// it lives, and one process may be faster than another for that alone.
struct Repeated {
  Measurement measurement;  ///< times are medians over the processes
  double fastest = 0.0;     ///< of the processes' medians [ns]
  double slowest = 0.0;     ///< [ns]
  int processes = 0;
};

/// In the order in which things were first measured.
std::vector<Repeated> mergedOverProcesses(const std::vector<Measurement>& measurements);

/// What a measurement was taken with: processor, kernel, governor, load, compiler, peers. Pairs of
/// a name and words.
std::vector<std::pair<std::string, std::string>> describeMachine();

}  // namespace haptics::bench
