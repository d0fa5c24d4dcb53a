#include "analysis/numerics/common_unit.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace analysis {
namespace {

constexpr std::int64_t kMostParts = 1000;
constexpr double kNoise = 1e-12;        // of the largest number
constexpr double kMostMultiples = 1e6;  // beyond, chance alone would find a unit

double largestOf(std::span<const double> numbers) {
  double largest = 0.0;
  for (const double number : numbers) {
    if (!std::isfinite(number)) {
      throw std::invalid_argument(
          "a value is infinite or no number: it is no multiple of anything");
    }
    largest = std::max(largest, std::abs(number));
  }
  return largest;
}

}  // namespace

std::optional<Multiples> commonUnitOf(std::span<const double> numbers) {
  const double largest = largestOf(numbers);
  for (std::int64_t parts = 1; parts <= kMostParts; ++parts) {
    const auto q = static_cast<double>(parts);
    if (largest * q > kMostMultiples) return std::nullopt;
    const double noise = kNoise * largest * q;
    const bool fits = std::ranges::all_of(numbers, [&](double number) {
      return std::abs(number * q - std::round(number * q)) <= noise;
    });
    if (!fits || (largest > 0.0 && largest * q < 0.5)) continue;

    Multiples result{.multiples = {}, .denominator = parts};
    for (const double number : numbers) {
      result.multiples.push_back(static_cast<std::int64_t>(std::round(number * q)));
    }
    return result;
  }
  return std::nullopt;
}

std::vector<double> withoutRoundingNoise(std::span<const double> numbers) {
  const auto common = commonUnitOf(numbers);
  std::vector<double> cleaned(numbers.begin(), numbers.end());
  if (!common) return cleaned;
  std::ranges::transform(common->multiples, cleaned.begin(), [&](std::int64_t multiple) {
    return static_cast<double>(multiple) / static_cast<double>(common->denominator);
  });
  return cleaned;
}

}  // namespace analysis
