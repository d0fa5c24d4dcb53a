#pragma once

namespace analysis {

/// A closed interval: both ends belong to it.
struct Interval {
  double low = 0.0;
  double high = 0.0;
};

}  // namespace analysis
