#pragma once

#include <optional>

#include "analysis/data/reason.h"
#include "analysis/tests/paired_t.h"
#include "analysis/tests/welch.h"

namespace analysis {

/// Between these, a difference is too small to matter. They belong to the protocol, and are in the
/// units of the scale.
struct EquivalenceBounds {
  double lower = 0.0;
  double upper = 0.0;
};

/// One of the two one-sided tests.
struct OneSidedTest {
  double t = 0.0;  ///< (difference − bound) / standard error; ±infinity beyond a double
  double p = 1.0;
  std::optional<double> log10P;  ///< also where p is too small for a double
};

/// Whether two conditions are equivalent within the bounds.
struct EquivalenceResult {
  EquivalenceBounds bounds;
  std::optional<OneSidedTest> aboveLower;  ///< small p: the difference is above the lower bound
  std::optional<OneSidedTest> belowUpper;  ///< small p: the difference is below the upper bound
  std::optional<double> p;                 ///< of both: the larger one
  std::optional<double> log10P;
  Reason reason;  ///< why something above is missing; empty if nothing is
};

/// Two one-sided tests (Schuirmann 1987; Lakens 2017): is the difference within the bounds?
///
///     p = max(P(T ≥ (diff − lower) / se), P(T ≤ (diff − upper) / se))
///
/// With p ≤ α, the confidence interval of the difference at 1 − 2α lies within the bounds. A
/// difference that is not significant does not show equivalence.
///
/// Not defined where the test of the difference is not.
///
/// @throws std::invalid_argument  unless lower < upper, both finite.
EquivalenceResult equivalenceTest(const WelchResult& test, const EquivalenceBounds& bounds);
EquivalenceResult equivalenceTest(const PairedTResult& test, const EquivalenceBounds& bounds);

}  // namespace analysis
