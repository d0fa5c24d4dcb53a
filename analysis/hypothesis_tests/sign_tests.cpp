#include "analysis/hypothesis_tests/sign_tests.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

#include "analysis/data/ranks.h"
#include "analysis/numerics/exact_arithmetic.h"
#include "analysis/numerics/fair_coin.h"
#include "analysis/numerics/tail_probabilities.h"

namespace analysis {

SignTestResult signTest(std::span<const double> differences) {
  std::uint64_t positive = 0;
  std::uint64_t negative = 0;
  for (const double difference : differences) {
    if (std::isnan(difference)) throw std::invalid_argument("a difference is no number");
    if (difference > 0.0) ++positive;
    if (difference < 0.0) ++negative;
  }
  return signTest(positive, negative, differences.size() - positive - negative);
}

SignTestResult signTest(std::uint64_t positive, std::uint64_t negative, std::uint64_t zeros) {
  SignTestResult result;
  result.positive = positive;
  result.negative = negative;
  result.zeros = zeros;
  if (positive == 0 && negative == 0) {
    result.reason = zeros == 0 ? reason("no_differences") : reason("no_sign_to_test");
    return result;
  }
  if (positive > kMostBinomialTrials || negative > kMostBinomialTrials - positive) {
    result.reason = reason("too_many_differences");
    return result;
  }
  const std::uint64_t tosses = positive + negative;
  const SmallProbability both = symmetricBinomialP(positive, tosses);
  result.p = both.p;
  result.log10P = both.log10P;
  result.pLess = symmetricBinomialCdf(positive, tosses).p;
  result.pGreater = symmetricBinomialCdf(negative, tosses).p;
  if (!result.p || !result.pLess || !result.pGreater) {
    result.reason = reason("a_p_too_small");
  }
  return result;
}

namespace {

/// Doubled ranks of the differences that are not zero.
struct SignedRanks {
  std::vector<std::uint64_t> doubled;
  Int128 positiveSum = 0;
  Int128 sum = 0;
  Int128 squares = 0;
};

SignedRanks signedRanksOf(std::span<const double> differences, ZeroTreatment zeros) {
  std::vector<double> sizes;
  std::vector<int> signs;
  for (const double difference : differences) {
    if (difference == 0.0 && zeros == ZeroTreatment::Dropped) continue;
    sizes.push_back(std::abs(difference));
    signs.push_back(difference > 0.0 ? 1 : difference < 0.0 ? -1 : 0);
  }
  const Midranks midranks = midranksOf(sizes);

  SignedRanks ranks;
  for (std::size_t i = 0; i < signs.size(); ++i) {
    if (signs[i] == 0) continue;
    const auto rank = static_cast<Int128>(midranks.doubled[i]);
    ranks.doubled.push_back(midranks.doubled[i]);
    ranks.sum += rank;
    ranks.squares += rank * rank;
    if (signs[i] > 0) ranks.positiveSum += rank;
  }
  return ranks;
}

void addExact(SignedRankResult& result, const SignedRanks& ranks) {
  if (!WeightedBernoulliSum::isFeasible(ranks.doubled)) {
    result.reason = reason("too_many_differences_asymptotic");
    return;
  }
  const WeightedBernoulliSum distribution(ranks.doubled);
  const auto sum = static_cast<std::uint64_t>(ranks.positiveSum);
  result.p = distribution.twoSided(sum);
  result.pLess = distribution.atMost(sum);
  result.pGreater = distribution.atLeast(sum);
}

void addAsymptotic(SignedRankResult& result, const SignedRanks& ranks) {
  const Int128 excess = 2 * ranks.positiveSum - ranks.sum;  // 4 (V − its mean)
  // The continuity correction moves V by ½, that is 4V by 2, towards its mean.
  const Int128 corrected = excess > 0 ? excess - 2 : excess < 0 ? excess + 2 : 0;
  const DoubleDouble deviation = squareRoot(exactQuotient(ranks.squares, 1));
  result.rankBiserial = exactQuotient(excess, ranks.sum).high;
  result.z = (exactQuotient(excess, 1) / deviation).high;
  result.pAsymptotic = normalTwoSidedP(*result.z);
  result.pAsymptoticContinuity = normalTwoSidedP((exactQuotient(corrected, 1) / deviation).high);
}

}  // namespace

SignedRankResult signedRankTest(std::span<const double> differences, ZeroTreatment zeros) {
  const SignedRanks ranks = signedRanksOf(differences, zeros);
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

namespace {

using Integers = std::vector<Int128>;
constexpr std::size_t kMostEnumerated = 40;  // two halves of 2^20 sums each

/// A double as mantissa · 2^exponent.
struct BinaryNumber {
  Int128 mantissa = 0;
  int exponent = 0;
};

BinaryNumber mantissaAndExponent(double number) {
  constexpr int kBits = 53;
  BinaryNumber binary;
  binary.mantissa = static_cast<Int128>(std::ldexp(std::frexp(number, &binary.exponent), kBits));
  binary.exponent -= kBits;
  for (; binary.mantissa % 2 == 0; binary.mantissa /= 2) ++binary.exponent;
  return binary;
}

/// The numbers, none of them zero, in units of their smallest digit; std::nullopt if they differ so
/// much in size that sums of them need more than 126 binary digits.
std::optional<Integers> exactIntegers(const std::vector<double>& numbers) {
  constexpr int kMostShift =
      66;  // [bits]; with 53 of a mantissa and 6 for a sum of 64 numbers: 125
  std::vector<BinaryNumber> binaries;
  binaries.reserve(numbers.size());
  for (const double number : numbers) binaries.push_back(mantissaAndExponent(number));
  const auto least = std::ranges::min_element(binaries, {}, &BinaryNumber::exponent)->exponent;

  Integers integers;
  for (const auto& binary : binaries) {
    if (binary.exponent - least > kMostShift) return std::nullopt;
    integers.push_back(binary.mantissa * (Int128{1} << (binary.exponent - least)));
  }
  return integers;
}

/// The sums of all subsets, from the smallest: merging two sorted lists keeps them sorted.
Integers subsetSums(std::span<const Int128> weights) {
  Integers sums{0};
  for (const Int128 weight : weights) {
    Integers with = sums;
    for (Int128& sum : with) sum += weight;
    Integers merged(2 * sums.size());
    std::ranges::merge(sums, with, merged.begin());
    sums = std::move(merged);
  }
  return sums;
}

/// The number of subsets of @p weights with a sum of at least `least`, from the sums of the two
/// halves of the weights (Horowitz & Sahni 1974): as the sum of the lower half rises, the smallest
/// sum of the upper half that suffices falls. So 2^(n/2) sums are computed in place of 2ⁿ.
std::uint64_t countSubsetsWithSumAtLeast(std::span<const Int128> weights, Int128 least) {
  const Integers lower = subsetSums(weights.first(weights.size() / 2));
  const Integers upper = subsetSums(weights.subspan(weights.size() / 2));
  std::uint64_t count = 0;
  std::size_t firstEnough = upper.size();
  for (const Int128 sum : lower) {
    while (firstEnough > 0 && sum + upper[firstEnough - 1] >= least) --firstEnough;
    count += upper.size() - firstEnough;
  }
  return count;
}

/// The magnitudes of the differences, their sum, and the sum of the positive differences.
struct SignFlips {
  Integers sizes;
  Int128 positive = 0;
  Int128 total = 0;
};

SignFlips flipsOf(const Integers& integers) {
  SignFlips flips;
  for (const Int128 number : integers) {
    const Int128 size = number < 0 ? -number : number;
    if (number > 0) flips.positive += size;
    flips.total += size;
    flips.sizes.push_back(size);
  }
  return flips;
}

void addPByEnumeration(SignFlipResult& result, const SignFlips& flips) {
  const double all = std::ldexp(1.0, static_cast<int>(flips.sizes.size()));
  const auto atLeast = [&](Int128 sum) {
    return static_cast<double>(countSubsetsWithSumAtLeast(flips.sizes, sum)) / all;
  };
  result.pGreater = atLeast(flips.positive);
  result.pLess = atLeast(flips.total - flips.positive);
  result.p = std::min(1.0, 2.0 * std::min(*result.pLess, *result.pGreater));
}

/// Computes p from the distribution of all sums. Returns false if there are too many different
/// sums.
bool addPByAllSums(SignFlipResult& result, const SignFlips& flips) {
  std::vector<std::uint64_t> weights;
  for (const Int128 size : flips.sizes) weights.push_back(static_cast<std::uint64_t>(size));
  if (!WeightedBernoulliSum::isFeasible(weights)) return false;

  const WeightedBernoulliSum distribution(weights);
  const auto positive = static_cast<std::uint64_t>(flips.positive);
  result.p = distribution.twoSided(positive);
  result.pLess = distribution.atMost(positive);
  result.pGreater = distribution.atLeast(positive);
  return true;
}

}  // namespace

SignFlipResult signFlipTest(std::span<const double> differences) {
  const auto common = commonUnitOf(differences);
  SignFlipResult result;
  result.n = differences.size();
  std::vector<double> numbers;
  for (std::size_t i = 0; i < differences.size(); ++i) {
    const bool isZero = common ? common->multiples[i] == 0 : differences[i] == 0.0;
    if (!isZero)
      numbers.push_back(common ? static_cast<double>(common->multiples[i]) : differences[i]);
  }
  if (numbers.empty()) {
    result.reason = differences.empty() ? reason("no_differences") : reason("no_sign_to_flip");
    return result;
  }
  const bool areFew = numbers.size() <= kMostEnumerated;
  const auto integers = common || areFew ? exactIntegers(numbers) : std::nullopt;
  if (!integers && areFew) {
    result.reason = reason("sizes_too_unlike");
    return result;
  }
  const SignFlips flips = integers ? flipsOf(*integers) : SignFlips{};
  if (common && addPByAllSums(result, flips)) return result;
  if (areFew) {
    addPByEnumeration(result, flips);
  } else {
    result.reason = reason("too_many_to_flip");
  }
  return result;
}

}  // namespace analysis
