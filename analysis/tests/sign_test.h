#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "analysis/data/reason.h"

namespace analysis {

/// What the sign test says about paired differences; what is missing has its reason.
struct SignTestResult {
  std::uint64_t positive = 0;
  std::uint64_t negative = 0;
  std::uint64_t zeros = 0;
  std::optional<double> p;         ///< exact, two-sided
  std::optional<double> log10P;    ///< also where p is too small for a double
  std::optional<double> pLess;     ///< exact P(no more positive ones)
  std::optional<double> pGreater;  ///< exact P(no fewer positive ones)
  Reason reason;                   ///< why something above is missing; empty if nothing is
};

/// The sign test (Arbuthnott 1710): are there more differences up than down? Zeros are dropped, and
/// the others are tosses of a fair coin: p = min(1, 2 min(P(≤ k), P(≥ k))).
///
/// @throws std::invalid_argument  if a difference is NaN.
SignTestResult signTest(std::span<const double> differences);
SignTestResult signTest(std::uint64_t positive, std::uint64_t negative, std::uint64_t zeros = 0);

}  // namespace analysis
