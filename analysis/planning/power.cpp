#include "analysis/planning/power.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <boost/math/distributions/non_central_t.hpp>

#include "analysis/numerics/student_distribution.h"

namespace analysis {
namespace {

void require(bool isSound, const char* what) {
  if (!isSound) throw std::invalid_argument(what);
}

}  // namespace

double pairedTPower(double dz, std::uint64_t n, double alpha) {
  require(n >= 2, "a paired test needs two participants");
  require(alpha > 0.0 && alpha < 1.0, "alpha lies between 0 and 1");
  require(std::isfinite(dz), "an effect is a number");
  const auto participants = static_cast<double>(n);
  const double critical = StudentDistribution(participants - 1.0).twoSidedQuantile(alpha);
  const double shift = std::abs(dz) * std::sqrt(participants);
  if (shift == 0.0) return alpha;
  // Beyond this the test misses nothing, and the series that follows would not end.
  constexpr double kLargestShift = 1000.0;
  if (shift > std::max(kLargestShift, 50.0 * critical)) return 1.0;
  const boost::math::non_central_t law(participants - 1.0, shift);
  const double right = boost::math::cdf(boost::math::complement(law, critical));
  return std::min(1.0, right + boost::math::cdf(law, -critical));
}

std::optional<std::uint64_t> participantsForPower(double dz, double alpha, double power) {
  require(alpha > 0.0 && alpha < 1.0, "alpha lies between 0 and 1");
  require(power > alpha && power < 1.0, "a power lies between alpha and 1");
  require(std::isfinite(dz), "an effect is a number");
  const auto suffices = [&](std::uint64_t n) { return pairedTPower(dz, n, alpha) >= power; };
  if (dz == 0.0) return std::nullopt;
  std::uint64_t tooFew = 1;
  std::uint64_t enough = 2;
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
