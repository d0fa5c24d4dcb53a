#pragma once

#include <functional>
#include <optional>
#include <string>

#include "haptics/bench/stopwatch.h"

namespace haptics::bench {

/// What a method came to in one setting.
struct Measurement {
  std::string family;   ///< "splines", "finite elements", "Kalman filter", "encoder", "refresh"
  std::string setting;  ///< what was done: "random, 10,000 nodes"
  std::string method;
  double parameter = 0.0;       ///< what is swept: nodes, elements, decades …
  std::optional<double> error;  ///< in the unit of the setting
  std::optional<Timing> time;
};

using Report = std::function<void(const Measurement&)>;

/// Splines over an analytic curve of reaming's shape, 4 to 10,000 nodes: largest error [N], time of
/// an evaluation at random; and three settings of their own: coherent, random, cold.
void measureSplines(const Report& report);

/// Force and mesh of the finite elements, N = 5 to 12,445; relative error against 100 digits, also
/// where elements differ by up to 12 decades.
void measureFiniteElements(const Report& report);

/// A step of the filter, its error against 100 digits, and how often a variance gets negative.
void measureKalmanFilter(const Report& report);

/// What an encoder's grain does to each rendering: RMS error of the force against an ideal encoder
/// [N].
void measureEncoders(const Report& report);

/// How often a second each of the punch's three renderings can be worked out with its mesh: Fig. 12
/// of the punch paper.
void measureRefresh(const Report& report);

/// Bone of spheres: area ripple [%] and time of a contact, beside nanoflann, Embree and a loop over
/// all spheres; single steps with removal, warm and cold.
void measurePacking(const Report& report);

/// Densities: relative error of the force over the time of a fit; bounded least squares, MLEM,
/// Eigen's LSCG, a swarm of 20 seeds.
void measureDensity(const Report& report);

/// From a series to nodes: RMS error against the noiseless curve, counts of nodes, times.
void measureFilter(const Report& report);

}  // namespace haptics::bench
