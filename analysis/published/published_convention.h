#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "analysis/numerics/interval.h"
#include "analysis/published/published_table.h"

namespace analysis {

/// How p values were computed, as far as publications often do not say.
struct PublishedConvention {
  enum class Test {
    Welch,
    WelchToolpak,  ///< degrees of freedom rounded to the nearest whole number
    Student,
  };
  enum class Tails { Two, One };
  enum class Divisor {
    Sample,      ///< printed variances have n − 1 (VAR.S)
    Population,  ///< … n (VAR.P); the test itself has n − 1
  };

  Test test = Test::Welch;
  Tails tails = Tails::Two;  ///< one: in the direction of the difference that was found
  Divisor divisor = Divisor::Sample;
  Reading reading = Reading::Rounded;  ///< of means, variances and p alike

  bool operator==(const PublishedConvention&) const = default;
};

/// All 24, the most usual one first.
std::vector<PublishedConvention> publishedConventions();

/// "Welch, two-sided, variances with n − 1, rounded"; "Welch (ToolPak)" has rounded degrees of
/// freedom.
std::string describe(const PublishedConvention& convention);

/// The variances with n − 1 that a group may have had, never negative.
/// @param n  at least 2.
Interval varianceBounds(
    const PublishedGroup& group, std::uint64_t n, const PublishedConvention& convention);

/// The standard error of a difference of two means, with its degrees of freedom.
struct SpreadOfDifference {
  double standardError = 0.0;     ///< 0 where both groups are constant
  double degreesOfFreedom = 1.0;  ///< at least 1
};

/// @param variance1  with n − 1, not negative; n at least 2.
SpreadOfDifference spreadOfDifference(
    PublishedConvention::Test test,
    double variance1,
    std::uint64_t n1,
    double variance2,
    std::uint64_t n2);

/// p of a difference; 0 where the spread is 0 and the difference is not, 1 where both are 0.
double pOf(double difference, const SpreadOfDifference& spread, PublishedConvention::Tails tails);

}  // namespace analysis
