#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "analysis/data/reason.h"
#include "analysis/numerics/interval.h"

namespace analysis {

/// What the paired t-test says. What is not defined is missing,
/// with a reason.
struct PairedTResult {
  std::uint64_t n = 0;  ///< of the pairs

  std::optional<double> meanDifference;  ///< of x − y
  std::optional<double> variance;        ///< of the differences, with n − 1
  std::optional<double> standardError;   ///< of their mean
  std::optional<double> t;               ///< ±infinity for differences that are all the same
  std::optional<double> degreesOfFreedom;

  std::optional<double> p;         ///< two-sided, not yet adjusted for the number of tests
  std::optional<double> log10P;    ///< of p; also where p is too small for a double
  std::optional<double> pLess;     ///< if only x < y were of interest
  std::optional<double> pGreater;  ///< if only x > y were of interest

  Reason reason;  ///< why something above is missing; empty if nothing is
};

/// The paired t-test: do the same participants answer differently under two conditions?
///
///     t = d̄ / (s_d / √n),   d = x − y,   n − 1 degrees of freedom
///
/// The differences are taken in double arithmetic, so that tests of their ranks see the same ones;
/// their mean and variance are taken with 31 digits.
///
/// The test is not defined for fewer than two pairs, nor for differences that are all the same.
///
/// @throws std::invalid_argument  if there are not as many y as x, or a value is infinite or NaN.
PairedTResult pairedTTest(std::span<const double> x, std::span<const double> y);

/// Where the mean difference lies, with a confidence of @p level, for instance 0.95; std::nullopt
/// if the test is not defined or a limit is beyond what a double can hold.
///
/// @throws std::invalid_argument  for a level that is not between 0 and 1.
std::optional<Interval> confidenceInterval(const PairedTResult& result, double level);

}  // namespace analysis
