#pragma once

#include <optional>
#include <span>
#include <vector>

#include "analysis/data/reason.h"

namespace analysis {

/// The result of the Brown–Forsythe test of the spread of several groups.
struct BrownForsytheResult {
  std::optional<double> f;
  std::optional<double> degreesOfFreedom1;  ///< k − 1
  std::optional<double> degreesOfFreedom2;  ///< n − k
  std::optional<double> p;
  std::optional<double> log10P;  ///< also where p is too small for a double
  Reason reason;                 ///< why something above is missing; empty if nothing is
};

/// Do k groups differ in their spread? Levene's test about the medians (Brown & Forsythe 1974): the
/// one-way analysis of variance of |x − median of its group|.
///
/// To be read beside a test of means, not to choose between tests.
///
/// @throws std::invalid_argument  if a value is infinite or NaN.
BrownForsytheResult brownForsytheTest(std::span<const std::vector<double>> groups);

}  // namespace analysis
