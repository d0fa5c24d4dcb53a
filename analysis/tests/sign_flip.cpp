#include "analysis/tests/sign_flip.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "analysis/numerics/exact_arithmetic.h"
#include "analysis/numerics/fair_coin.h"

namespace analysis {
namespace {

using Integers = std::vector<Wide>;
constexpr std::size_t kMostEnumerated = 40;  // two halves of 2^20 sums each

/// A double as a whole number of 2^exponent.
struct Binary {
  Wide mantissa = 0;
  int exponent = 0;
};

Binary binaryOf(double number) {
  constexpr int kBits = 53;
  Binary binary;
  binary.mantissa = static_cast<Wide>(std::ldexp(std::frexp(number, &binary.exponent), kBits));
  binary.exponent -= kBits;
  for (; binary.mantissa % 2 == 0; binary.mantissa /= 2) ++binary.exponent;
  return binary;
}

/// The numbers, none of them zero, in units of their smallest digit; std::nullopt if they differ so
/// much in size that sums of them need more than 126 digits.
std::optional<Integers> exactIntegers(const std::vector<double>& numbers) {
  constexpr int kMostShift = 66;  // with 53 digits and sums of 2^6 numbers
  std::vector<Binary> binaries;
  binaries.reserve(numbers.size());
  for (const double number : numbers) binaries.push_back(binaryOf(number));
  const auto least = std::ranges::min_element(binaries, {}, &Binary::exponent)->exponent;

  Integers integers;
  for (const auto& binary : binaries) {
    if (binary.exponent - least > kMostShift) return std::nullopt;
    integers.push_back(binary.mantissa * (Wide{1} << (binary.exponent - least)));
  }
  return integers;
}

/// The sums of all subsets, from the smallest: merging two sorted lists keeps them sorted.
Integers subsetSums(std::span<const Wide> weights) {
  Integers sums{0};
  for (const Wide weight : weights) {
    Integers with = sums;
    for (Wide& sum : with) sum += weight;
    Integers merged(2 * sums.size());
    std::ranges::merge(sums, with, merged.begin());
    sums = std::move(merged);
  }
  return sums;
}

/// How many subsets have a sum of at least `least`, by meeting in the middle (Horowitz & Sahni
/// 1974): for the sums of one half in ascending order, the smallest sufficient sum of the other
/// half descends. 2^(n/2) sums in place of 2ⁿ.
std::uint64_t subsetsOfAtLeast(std::span<const Wide> weights, Wide least) {
  const Integers lower = subsetSums(weights.first(weights.size() / 2));
  const Integers upper = subsetSums(weights.subspan(weights.size() / 2));
  std::uint64_t count = 0;
  std::size_t enough = upper.size();
  for (const Wide sum : lower) {
    while (enough > 0 && sum + upper[enough - 1] >= least) --enough;
    count += upper.size() - enough;
  }
  return count;
}

/// Of a sum of sizes, the part that is positive.
struct Flips {
  Integers sizes;
  Wide positive = 0;
  Wide total = 0;
};

Flips flipsOf(const Integers& integers) {
  Flips flips;
  for (const Wide number : integers) {
    const Wide size = number < 0 ? -number : number;
    if (number > 0) flips.positive += size;
    flips.total += size;
    flips.sizes.push_back(size);
  }
  return flips;
}

void addEnumerated(SignFlipResult& result, const Flips& flips) {
  const double all = std::ldexp(1.0, static_cast<int>(flips.sizes.size()));
  const auto atLeast = [&](Wide sum) {
    return static_cast<double>(subsetsOfAtLeast(flips.sizes, sum)) / all;
  };
  result.pGreater = atLeast(flips.positive);
  result.pLess = atLeast(flips.total - flips.positive);
  result.p = std::min(1.0, 2.0 * std::min(*result.pLess, *result.pGreater));
}

/// By the distribution of all sums; false where there are too many different ones.
bool addBySums(SignFlipResult& result, const Flips& flips) {
  std::vector<std::uint64_t> weights;
  for (const Wide size : flips.sizes) weights.push_back(static_cast<std::uint64_t>(size));
  if (!SubsetSums::isFeasible(weights)) return false;

  const SubsetSums law(weights);
  const auto positive = static_cast<std::uint64_t>(flips.positive);
  result.p = law.twoSided(positive);
  result.pLess = law.atMost(positive);
  result.pGreater = law.atLeast(positive);
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
  const Flips flips = integers ? flipsOf(*integers) : Flips{};
  if (common && addBySums(result, flips)) return result;
  if (areFew) {
    addEnumerated(result, flips);
  } else {
    result.reason = reason("too_many_to_flip");
  }
  return result;
}

}  // namespace analysis
