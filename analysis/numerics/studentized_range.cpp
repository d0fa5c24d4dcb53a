#include "analysis/numerics/studentized_range.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <vector>

#include "analysis/numerics/tail_probabilities.h"

namespace analysis {
namespace {

constexpr double kStep = 1.0 / 32.0;
constexpr double kReach = 12.0;  // beyond it on either side, less than 1e-30 of the normal law

/// ln of φ(z) [Φ(z)^m − (Φ(z) − Φ(z − q))^m].
double logIntegrand(double z, double q, double m) {
  constexpr double kNegligible = -40.0;  // e^−40 of one
  const double logPhi = -0.5 * z * z - 0.5 * std::log(2.0 * std::numbers::pi);
  const double logBelow = logNormalCdf(z);
  const double logShare =
      std::min(0.0, logNormalCdf(z - q) - logBelow);  // of Φ(z) that lies more than q below
  const double logLoss = logShare < kNegligible
                             ? std::log(m) + logShare
                             : std::log(-std::expm1(m * std::log1p(-std::exp(logShare))));
  return logPhi + m * logBelow + logLoss;
}

/// ln P(Q ≥ q)
double logUpperTail(double q, std::size_t k) {
  const auto m = static_cast<double>(k - 1);
  const auto first = static_cast<long>(std::floor(-kReach / kStep));
  const auto last = static_cast<long>(std::ceil((q + kReach) / kStep));
  std::vector<double> logs;
  for (long i = first; i <= last; ++i) {
    logs.push_back(logIntegrand(static_cast<double>(i) * kStep, q, m));
  }
  const double largest = *std::ranges::max_element(logs);
  double sum = 0.0;
  for (const double log : logs) sum += std::exp(log - largest);
  return std::min(0.0, largest + std::log(sum * kStep * static_cast<double>(k)));
}

void require(double q, std::size_t k) {
  constexpr std::size_t kMostGroups = 10'000;
  constexpr double kLargest = 1e5;
  if (!(q >= 0.0 && q <= kLargest))
    throw std::invalid_argument("a range lies between 0 and 100000");
  if (k < 2 || k > kMostGroups) throw std::invalid_argument("a range is that of 2 to 10000 values");
}

}  // namespace

double studentizedRangeP(double q, std::size_t k) {
  require(q, k);
  return std::exp(logUpperTail(q, k));
}

double log10StudentizedRangeP(double q, std::size_t k) {
  require(q, k);
  return logUpperTail(q, k) / std::numbers::ln10;
}

}  // namespace analysis
