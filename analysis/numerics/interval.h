#pragma once

namespace analysis {

/// From here to there, both ends included.
struct Interval {
  double low = 0.0;
  double high = 0.0;
};

}  // namespace analysis
