#pragma once

#include <cstdint>
#include <vector>

#include "haptics/reaming/material/series.h"

namespace haptics::reaming {

/// A fault that is put into a synthetic test.
enum class SyntheticFault {
  None,
  FeedChange,     ///< the feed is changed during the test
  BreakOut,       ///< the acetabulum broke out of its resin
  ReamedThrough,  ///< nothing is left after 10 mm
};

/// One test of one specimen that does not exist.
struct SyntheticTest {
  TestSet set = TestSet::Dynamic1;
  double hardness = 0.5;    ///< from 0 to 1: how hard this specimen's bone is
  double feed = 0.01e-3;    ///< [m/s]; not for static tests, which have 0.07 mm/s
  double noise = 1.0;       ///< standard deviation of the force sensor [N]
  double rotation = 3.0;    ///< amplitude of the line at the reamer's rotation [N]; 0 when static
  double rotationRate = 5;  ///< [Hz]
  SyntheticFault mishap = SyntheticFault::None;
  std::uint64_t seed = 1;
};

/// A series with the published properties (reaming paper, Fig. 3–6): 100 Hz; 20 N of preload, which
/// a dynamic test has reamed away before it begins; almost no force at first, because the reamer
/// keeps up with the feed; one local peak; then a rise until 800 N, a stalled reamer or 20 mm;
/// torque that follows the force. Not a measurement.
Series syntheticSeries(const SyntheticTest& test);

/// The same without noise and without the line of the rotation: the truth that a filter is after.
Series noiselessSeries(SyntheticTest test);

/// 24 specimens, each with its three tests: 72 series, of which ten are such as the paper excludes
/// (two feed changes, four break-outs, four reamed through).
std::vector<Series> syntheticStudy(std::uint64_t seed);

}  // namespace haptics::reaming
