#pragma once

#include "analysis/data/moments.h"
#include "analysis/numerics/double_double.h"

namespace analysis {

/// Two groups side by side, in common units: what a t-test is made of.
///
/// Units are powers of two, so that nothing is rounded by them, and nothing overflows.
struct Contrast {
  int meanExponent = 0;
  DoubleDouble difference;  ///< mean of group 1 − mean of group 2 [2^meanExponent]

  int spreadExponent = 0;
  DoubleDouble variance1;  ///< [4^spreadExponent]
  DoubleDouble variance2;  ///< [4^spreadExponent]
};

Contrast contrastOf(const Moments& group1, const Moments& group2);

/// difference / standardError as a double; ±infinity where a double cannot hold it, 0 where the
/// difference is 0.
///
/// @param standardError  [2^spreadExponent]
double tOf(const Contrast& contrast, const DoubleDouble& standardError);

}  // namespace analysis
