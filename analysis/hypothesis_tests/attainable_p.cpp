#include "analysis/hypothesis_tests/attainable_p.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>
#include <vector>

#include <boost/math/special_functions/gamma.hpp>

#include "analysis/hypothesis_tests/vote_tests.h"

namespace analysis {
namespace {

constexpr int kMostOptions = 1000;

void requireLevel(double alpha) {
  if (!(alpha > 0.0 && alpha < 1.0)) throw std::invalid_argument("alpha lies between 0 and 1");
}

void requireOptions(int k) {
  if (k < 2 || k > kMostOptions) throw std::invalid_argument("there are 2 to 1000 options");
}

AttainableP attainablePFromLog(double naturalLog) {
  const double log10P = std::min(naturalLog / std::numbers::ln10, 0.0);
  return {.p = std::min(std::exp(naturalLog), 1.0), .log10P = log10P};
}

/// base^(−exponent); exact if a double can represent it.
AttainableP power(double base, double exponent) {
  return {.p = std::pow(base, -exponent), .log10P = -exponent * std::log10(base)};
}

/// Distributes @p votes over @p options as equally as possible. Of all distributions of the votes
/// for the other options, this is the most probable one and gives the largest p.
std::vector<std::uint64_t> evenVoteCounts(std::uint64_t votes, int options) {
  const auto count = static_cast<std::uint64_t>(options);
  std::vector<std::uint64_t> shares(count, votes / count);
  for (std::uint64_t i = 0; i < votes % count; ++i) ++shares[i];
  return shares;
}

std::optional<double> pOfWinner(std::uint64_t winner, std::uint64_t n, int k) {
  std::vector<std::string> names;
  for (int i = 0; i < k; ++i) names.push_back(std::to_string(i));
  VoteCounts votes(names);
  votes.add(names[0], winner);
  const auto others = evenVoteCounts(n - winner, k - 1);
  for (std::size_t i = 0; i < others.size(); ++i) votes.add(names[i + 1], others[i]);
  return equalSharesP(votes);
}

}  // namespace

FamilyLevels levelsOf(double alpha, std::size_t tests, std::optional<Adjustment> correction) {
  requireLevel(alpha);
  if (!correction) return {.strictest = alpha, .mostLenient = alpha};
  const double bonferroni = alphaPerTest(alpha, tests);
  const auto m = static_cast<double>(tests);
  switch (*correction) {
    case Adjustment::Bonferroni:
    case Adjustment::Holm:
      return {.strictest = bonferroni, .mostLenient = bonferroni};
    case Adjustment::HolmSidak: {
      const double level = -std::expm1(std::log1p(-alpha) / m);
      return {.strictest = level, .mostLenient = level};
    }
    case Adjustment::Hochberg:
    case Adjustment::Hommel:
    case Adjustment::BenjaminiHochberg:
      return {.strictest = bonferroni, .mostLenient = alpha};
    case Adjustment::BenjaminiYekutieli: {
      double harmonic = 0.0;
      for (double i = 1.0; i <= m; i += 1.0) harmonic += 1.0 / i;
      return {.strictest = bonferroni / harmonic, .mostLenient = alpha / harmonic};
    }
  }
  throw std::invalid_argument("there is no such adjustment");
}

AttainableP smallestSignFlipP(std::uint64_t n) {
  return n < 2 ? AttainableP{} : power(2.0, static_cast<double>(n - 1));
}

AttainableP smallestFriedmanP(std::uint64_t n, int k) {
  requireOptions(k);
  if (n < 2) return {};
  const auto participants = static_cast<double>(n);
  constexpr int kExactFactorial = 18;  // 18! < 2^53
  if (k <= kExactFactorial) return power(std::round(std::tgamma(k + 1.0)), participants - 1.0);
  return attainablePFromLog(-(participants - 1.0) * boost::math::lgamma(k + 1.0));
}

AttainableP smallestMannWhitneyP(std::uint64_t n1, std::uint64_t n2) {
  double p = 2.0;  // computed as a product, which is exact as long as the binomial coefficient is
  double logP = std::numbers::ln2;
  double combinations = 1.0;
  const auto fewer = static_cast<double>(std::min(n1, n2));
  const auto more = static_cast<double>(std::max(n1, n2));
  for (double i = 1.0; i <= fewer; i += 1.0) {
    combinations = combinations * (more + i) / i;
    logP -= std::log1p(more / i);
  }
  p /= combinations;
  return p >= 1.0 ? AttainableP{} : AttainableP{.p = p, .log10P = logP / std::numbers::ln10};
}

AttainableP smallestVoteP(std::uint64_t n, int k) {
  requireOptions(k);
  return n < 2 ? AttainableP{} : power(k, static_cast<double>(n - 1));
}

std::uint64_t fewestParticipantsForSignFlip(double level) {
  requireLevel(level);
  std::uint64_t n = 2;
  while (std::ldexp(1.0, 1 - static_cast<int>(n)) > level) ++n;
  return n;
}

std::optional<std::uint64_t> fewestVotesForSignificance(std::uint64_t n, int k, double alpha) {
  requireLevel(alpha);
  requireOptions(k);
  const auto suffices = [&](std::uint64_t winner) {
    return pOfWinner(winner, n, k).value_or(1.0) <= alpha;
  };
  if (!suffices(n)) return std::nullopt;
  std::uint64_t tooFew = n / static_cast<std::uint64_t>(k);  // p falls as the winner gains
  std::uint64_t enough = n;
  while (enough - tooFew > 1) {
    const auto middle = tooFew + (enough - tooFew) / 2;
    (suffices(middle) ? enough : tooFew) = middle;
  }
  return enough;
}

}  // namespace analysis
