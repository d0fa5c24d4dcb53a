#include "analysis/published/published_convention.h"

#include <algorithm>
#include <cmath>

#include "analysis/numerics/distributions.h"

namespace analysis {
namespace {

using Convention = PublishedConvention;

const char* nameOfTest(Convention::Test test) {
  switch (test) {
    case Convention::Test::Welch:
      return "Welch";
    case Convention::Test::WelchToolpak:
      return "Welch (ToolPak)";
    case Convention::Test::Student:
      return "Student";
  }
  return "";
}

/// Welch & Satterthwaite's degrees of freedom, from shares of the variance, which cannot overflow.
SpreadOfDifference welchSpread(double v1, double n1, double v2, double n2) {
  const double total = v1 + v2;
  if (total == 0.0) return {};
  const double share = v1 / total;
  const double inverse = share * share / (n1 - 1.0) + (1.0 - share) * (1.0 - share) / (n2 - 1.0);
  return {.standardError = std::sqrt(total), .degreesOfFreedom = std::max(1.0, 1.0 / inverse)};
}

}  // namespace

std::vector<PublishedConvention> publishedConventions() {
  std::vector<Convention> all;
  for (const auto rounding : {RoundingRule::Rounded, RoundingRule::Truncated}) {
    for (const auto divisor : {Convention::Divisor::Sample, Convention::Divisor::Population}) {
      for (const auto tails : {Convention::Tails::Two, Convention::Tails::One}) {
        for (const auto test :
             {Convention::Test::Welch, Convention::Test::WelchToolpak, Convention::Test::Student}) {
          all.push_back({.test = test, .tails = tails, .divisor = divisor, .rounding = rounding});
        }
      }
    }
  }
  return all;
}

std::string describe(const PublishedConvention& convention) {
  std::string words = nameOfTest(convention.test);
  words += convention.tails == Convention::Tails::Two ? ", two-sided" : ", one-sided";
  words += convention.divisor == Convention::Divisor::Sample ? ", variances with n − 1"
                                                             : ", variances with n";
  words += convention.rounding == RoundingRule::Rounded ? ", rounded" : ", truncated";
  return words;
}

Interval varianceBounds(
    const PublishedGroup& group, std::uint64_t n, const PublishedConvention& convention) {
  Interval bounds = group.spread.bounds(convention.rounding);
  bounds.low = std::max(bounds.low, 0.0);
  if (group.isStandardDeviation) {
    bounds = {.low = bounds.low * bounds.low, .high = bounds.high * bounds.high};
  }
  if (convention.divisor == Convention::Divisor::Population) {
    const auto size = static_cast<double>(n);
    bounds.low *= size / (size - 1.0);
    bounds.high *= size / (size - 1.0);
  }
  return bounds;
}

SpreadOfDifference spreadOfDifference(
    PublishedConvention::Test test,
    double variance1,
    std::uint64_t n1,
    double variance2,
    std::uint64_t n2) {
  const auto size1 = static_cast<double>(n1);
  const auto size2 = static_cast<double>(n2);
  if (test == Convention::Test::Student) {
    const double df = size1 + size2 - 2.0;
    const double pooled = ((size1 - 1.0) * variance1 + (size2 - 1.0) * variance2) / df;
    return {
        .standardError = std::sqrt(pooled * (1.0 / size1 + 1.0 / size2)), .degreesOfFreedom = df};
  }
  auto spread = welchSpread(variance1 / size1, size1, variance2 / size2, size2);
  if (test == Convention::Test::WelchToolpak) {
    spread.degreesOfFreedom = std::floor(spread.degreesOfFreedom + 0.5);
  }
  return spread;
}

double pOf(double difference, const SpreadOfDifference& spread, PublishedConvention::Tails tails) {
  if (difference == 0.0) return tails == Convention::Tails::Two ? 1.0 : 0.5;
  if (spread.standardError == 0.0) return 0.0;
  const StudentDistribution distribution(spread.degreesOfFreedom);
  const double p = distribution.twoSidedP(difference / spread.standardError);
  return tails == Convention::Tails::Two ? p : 0.5 * p;
}

}  // namespace analysis
