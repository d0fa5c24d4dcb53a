#include "analysis/tests/signed_rank.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "analysis/data/ranks.h"
#include "analysis/numerics/exact_arithmetic.h"
#include "analysis/numerics/fair_coin.h"
#include "analysis/numerics/tail_probabilities.h"

namespace analysis {
namespace {

/// Doubled ranks of the differences that have a sign.
struct SignedRanks {
  std::vector<std::uint64_t> doubled;
  Wide positiveSum = 0;
  Wide sum = 0;
  Wide squares = 0;
};

SignedRanks ranked(std::span<const double> differences, Zeros zeros) {
  std::vector<double> sizes;
  std::vector<int> signs;
  for (const double difference : differences) {
    if (difference == 0.0 && zeros == Zeros::Dropped) continue;
    sizes.push_back(std::abs(difference));
    signs.push_back(difference > 0.0 ? 1 : difference < 0.0 ? -1 : 0);
  }
  const Midranks midranks = midranksOf(sizes);

  SignedRanks ranks;
  for (std::size_t i = 0; i < signs.size(); ++i) {
    if (signs[i] == 0) continue;
    const auto rank = static_cast<Wide>(midranks.doubled[i]);
    ranks.doubled.push_back(midranks.doubled[i]);
    ranks.sum += rank;
    ranks.squares += rank * rank;
    if (signs[i] > 0) ranks.positiveSum += rank;
  }
  return ranks;
}

void addExact(SignedRankResult& result, const SignedRanks& ranks) {
  if (!SubsetSums::isFeasible(ranks.doubled)) {
    result.reason = reason("too_many_differences_asymptotic");
    return;
  }
  const SubsetSums law(ranks.doubled);
  const auto sum = static_cast<std::uint64_t>(ranks.positiveSum);
  result.p = law.twoSided(sum);
  result.pLess = law.atMost(sum);
  result.pGreater = law.atLeast(sum);
}

void addAsymptotic(SignedRankResult& result, const SignedRanks& ranks) {
  const Wide excess = 2 * ranks.positiveSum - ranks.sum;  // 4 (V − its mean)
  // The continuity correction moves V by ½, that is 4V by 2, towards its mean.
  const Wide corrected = excess > 0 ? excess - 2 : excess < 0 ? excess + 2 : 0;
  const DoubleDouble deviation = squareRoot(exactQuotient(ranks.squares, 1));
  result.rankBiserial = exactQuotient(excess, ranks.sum).high;
  result.z = (exactQuotient(excess, 1) / deviation).high;
  result.pAsymptotic = normalTwoSidedP(*result.z);
  result.log10PAsymptotic = log10NormalTwoSidedP(*result.z);
  result.pAsymptoticContinuity = normalTwoSidedP((exactQuotient(corrected, 1) / deviation).high);
}

}  // namespace

SignedRankResult signedRankTest(std::span<const double> differences, Zeros zeros) {
  const SignedRanks ranks = ranked(differences, zeros);
  SignedRankResult result;
  result.n = differences.size();
  result.positive = static_cast<std::uint64_t>(
      std::ranges::count_if(differences, [](double difference) { return difference > 0.0; }));
  result.negative = ranks.doubled.size() - result.positive;
  result.zeros = result.n - ranks.doubled.size();
  if (ranks.doubled.empty()) {
    result.reason = result.n == 0 ? reason("no_differences") : reason("no_sign_to_test");
    return result;
  }
  result.v = exactQuotient(ranks.positiveSum, 2).high;
  addExact(result, ranks);
  addAsymptotic(result, ranks);
  return result;
}

}  // namespace analysis
