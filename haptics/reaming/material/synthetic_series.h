#pragma once

#include <cstdint>
#include <vector>

#include "haptics/reaming/material/series.h"

namespace haptics::reaming {

/// A fault that a synthetic test simulates.
enum class SyntheticFault {
  None,
  FeedChange,     ///< the feed changes during the test
  BreakOut,       ///< the acetabulum breaks out of its resin
  ReamedThrough,  ///< the bone is reamed through after 10 mm
};

/// Parameters of one test of one simulated specimen.
struct SyntheticTest {
  TestSet set = TestSet::Dynamic1;
  double hardness = 0.5;  ///< of the specimen's bone, 0 to 1
  double feed = 0.01e-3;  ///< [m/s]; ignored by static tests, which have 0.07 mm/s
  double noise = 1.0;     ///< standard deviation of the force sensor [N]
  /// Amplitude of the force at the reamer's rotation rate [N]; 0 in static tests.
  double rotation = 3.0;
  double rotationRate = 5;  ///< [Hz]
  SyntheticFault simulatedFault = SyntheticFault::None;
  std::uint64_t seed = 1;
};

/// Simulates a series with the published properties (reaming paper, Fig. 3–6): sampled at 100 Hz; a
/// preload of 20 N, which in a dynamic test is reamed away before the beginning; almost no force at
/// first, because the reamer keeps up with the feed; one local peak; then a rise until 800 N, a
/// stalled reamer or 20 mm; a torque proportional to the force.
Series syntheticSeries(const SyntheticTest& test);

/// The series of @p test without noise and without the force at the rotation rate: what a filter
/// should recover.
Series noiselessSeries(SyntheticTest test);

/// Three tests of 24 specimens: 72 series, of which ten have faults for which the paper excludes a
/// series (two feed changes, four break-outs, four reamed through).
std::vector<Series> syntheticStudy(std::uint64_t seed);

}  // namespace haptics::reaming
