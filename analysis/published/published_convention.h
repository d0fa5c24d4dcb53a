#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "analysis/numerics/interval.h"
#include "analysis/published/published_table.h"

namespace analysis {

/// The choices in computing p values that publications often do not state.
struct PublishedConvention {
  enum class Test {
    Welch,
    WelchToolpak,  ///< degrees of freedom rounded to the nearest whole number
    Student,
  };
  enum class Tails { Two, One };
  enum class Divisor {
    Sample,      ///< printed variances are divided by n − 1 (VAR.S)
    Population,  ///< printed variances are divided by n (VAR.P); the test uses n − 1
  };

  Test test = Test::Welch;
  Tails tails = Tails::Two;  ///< One: in the direction of the observed difference
  Divisor divisor = Divisor::Sample;
  RoundingRule rounding = RoundingRule::Rounded;  ///< of means, variances and p values

  bool operator==(const PublishedConvention&) const = default;
};

/// All 24 conventions, the most usual one first.
std::vector<PublishedConvention> publishedConventions();

/// For example "Welch, two-sided, variances with n − 1, rounded".
std::string describe(const PublishedConvention& convention);

/// The range of the variance (divided by n − 1) of a group, never negative.
/// @param n  at least 2.
Interval varianceBounds(
    const PublishedGroup& group, std::uint64_t n, const PublishedConvention& convention);

/// The standard error of a difference of two means, with its degrees of freedom.
struct SpreadOfDifference {
  double standardError = 0.0;     ///< 0 where both groups are constant
  double degreesOfFreedom = 1.0;  ///< at least 1
};

/// @param variance1  divided by n − 1, not negative; n at least 2.
SpreadOfDifference spreadOfDifference(
    PublishedConvention::Test test,
    double variance1,
    std::uint64_t n1,
    double variance2,
    std::uint64_t n2);

/// p of a difference of means: 1 (one-sided ½) if the difference is 0, otherwise 0 if the standard
/// error is 0.
double pOf(double difference, const SpreadOfDifference& spread, PublishedConvention::Tails tails);

}  // namespace analysis
