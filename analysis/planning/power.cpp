#include "analysis/planning/power.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <stdexcept>

#include <boost/math/distributions/non_central_t.hpp>

#include "analysis/numerics/distributions.h"

namespace analysis {
namespace {

void requireThat(bool isSound, const char* what) {
  if (!isSound) throw std::invalid_argument(what);
}

}  // namespace

double pairedTPower(double dz, std::uint64_t n, double alpha) {
  requireThat(n >= 2, "a paired test needs two participants");
  const auto participants = static_cast<double>(n);
  return twoSidedTPower(dz * std::sqrt(participants), participants - 1.0, alpha);
}

double twoSidedTPower(double noncentrality, double df, double alpha) {
  requireThat(alpha > 0.0 && alpha < 1.0, "alpha lies between 0 and 1");
  requireThat(std::isfinite(noncentrality), "an effect is a number");
  const double critical = StudentDistribution(df).twoSidedQuantile(alpha);
  const double shift = std::abs(noncentrality);
  if (shift == 0.0) return alpha;
  // Beyond this shift the power is 1.
  constexpr double kLargestShift = 1000.0;
  if (shift > std::max(kLargestShift, 50.0 * critical)) return 1.0;
  // For larger shifts Boost's series, used below, would be slow.
  constexpr double kLargestForSeries = 100.0;
  if (shift > kLargestForSeries) return 1.0 - noncentralTProbability(critical, df, shift);
  const boost::math::non_central_t distribution(df, shift);
  const double right = boost::math::cdf(boost::math::complement(distribution, critical));
  return std::min(1.0, right + boost::math::cdf(distribution, -critical));
}

std::optional<std::uint64_t> participantsForPower(double dz, double alpha, double power) {
  requireThat(std::isfinite(dz), "an effect is a number");
  return fewestParticipants(2, alpha, power, [&](std::uint64_t n) {
    return dz != 0.0 && pairedTPower(dz, n, alpha) >= power;
  });
}

std::optional<std::uint64_t> fewestParticipants(
    std::uint64_t least,
    double alpha,
    double power,
    const std::function<bool(std::uint64_t)>& suffices) {
  requireThat(alpha > 0.0 && alpha < 1.0, "alpha lies between 0 and 1");
  requireThat(power > alpha && power < 1.0, "a power lies between alpha and 1");
  std::uint64_t tooFew = least - 1;
  std::uint64_t enough = least;
  while (!suffices(enough)) {
    if (enough == kMostParticipants) return std::nullopt;
    tooFew = enough;
    enough = std::min(2 * enough, kMostParticipants);
  }
  while (enough - tooFew > 1) {
    const std::uint64_t middle = tooFew + (enough - tooFew) / 2;
    (suffices(middle) ? enough : tooFew) = middle;
  }
  return enough;
}

}  // namespace analysis
