#pragma once

#include <cstdint>
#include <string_view>
#include <utility>
#include <vector>

namespace protocols {

/// The version of everything below: a study stores it, and a stream of one version never changes.
inline constexpr int kRandomVersion = 1;

/// Random numbers for one purpose and nobody else's: a stream is named by the study's seed, an
/// index (of a participant, a slot) and a purpose ("order", "labels"), so that a new purpose
/// changes no other. Standard distributions differ between libraries and versions; these do not.
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

  /// A number from the normal law with mean 0 and standard deviation 1 (Marsaglia's polar method).
  double normal() noexcept;

  /// Puts @p values into one of their orders, each equally likely (Fisher–Yates).
  template <typename T>
  void shuffle(std::vector<T>& values) noexcept {
    for (std::size_t i = values.size(); i > 1; --i) std::swap(values[i - 1], values[below(i)]);
  }

 private:
  std::uint64_t state_[4];
};

}  // namespace protocols
