#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>
#include <string_view>
#include <utility>
#include <vector>

// The random number generators of Palpate. (Test cases and power simulations use std::mt19937_64.)
// The same seed gives the same numbers on every computer and in every version, because stored
// orders, simulated participants and materials depend on them. The distributions of the standard
// library differ between implementations, so these generators have their own.
namespace base {

/// SplitMix64 (Steele, Lea & Flood 2014, "Fast Splittable Pseudorandom Number Generators"): small
/// and fast, for simulated noise, faults and series. Its state is a counter, so any seed is a good
/// one.
class SplitMix64 {
 public:
  explicit SplitMix64(std::uint64_t seed) noexcept : state_(seed) {}

  /// 64 random bits.
  std::uint64_t bits() noexcept {
    state_ += 0x9e3779b97f4a7c15U;
    std::uint64_t z = state_;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9U;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebU;
    return z ^ (z >> 31);
  }

  /// A number in [0, 1), a multiple of 2⁻⁵³.
  double uniform() noexcept { return static_cast<double>(bits() >> 11) * 0x1.0p-53; }

  /// A normally distributed number with mean 0 and standard deviation 1: the first number of each
  /// pair that the method of Box & Muller 1958 gives.
  double normal() noexcept {
    const double radius = std::sqrt(-2.0 * std::log(1.0 - uniform()));
    return radius * std::cos(2.0 * std::numbers::pi * uniform());
  }

 private:
  std::uint64_t state_;
};

/// The version of RandomStream, which a study stores. The numbers of one version never change.
inline constexpr int kRandomVersion = 1;

/// Random numbers for one purpose: a stream is named by the study's seed, an index (of a
/// participant, a slot) and a purpose ("order", "labels"), so that adding a purpose leaves the
/// numbers of all others as they are.
///
/// Generator: xoshiro256** (Blackman & Vigna 2018), its state filled by SplitMix64 from the seed,
/// the index and the FNV-1a hash of the purpose.
class RandomStream {
 public:
  RandomStream(std::uint64_t seed, std::uint64_t index, std::string_view purpose) noexcept;

  /// 64 random bits.
  std::uint64_t bits() noexcept;

  /// A whole number from 0 to @p bound − 1, each equally likely; @p bound > 0.
  std::uint64_t below(std::uint64_t bound) noexcept;

  /// A number in [0, 1), a multiple of 2⁻⁵³.
  double uniform() noexcept;
  double uniform(double least, double most) noexcept { return least + (most - least) * uniform(); }

  /// A normally distributed number with mean 0 and standard deviation 1 (Marsaglia's polar method).
  double normal() noexcept;

  /// Shuffles @p values; all orders are equally likely (Fisher–Yates).
  template <typename T>
  void shuffle(std::vector<T>& values) noexcept {
    for (std::size_t i = values.size(); i > 1; --i) std::swap(values[i - 1], values[below(i)]);
  }

 private:
  std::uint64_t state_[4];
};

}  // namespace base
