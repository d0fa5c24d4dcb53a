#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace tests {

/// xoshiro256**, step by step as Blackman & Vigna describe it: "Scrambled Linear Pseudorandom
/// Number Generators", ACM Transactions on Mathematical Software 47 (2021), fig. 1 and table 2.
struct ReferenceXoshiro {
  std::array<std::uint64_t, 4> s;

  std::uint64_t next();
};

/// SplitMix64: Steele, Lea & Flood, "Fast Splittable Pseudorandom Number Generators" (2014), with
/// the constants of Stafford's variant 13.
std::uint64_t referenceSplitMix(std::uint64_t& state);

/// FNV-1a, 64 bits: Fowler, Noll & Vo.
std::uint64_t referenceFnv1a(std::string_view text);

/// The state is four numbers of SplitMix64, into whose state the first numbers drawn from the seed
/// and the index were mixed with the index and the hash of the purpose.
ReferenceXoshiro referenceStream(std::uint64_t seed, std::uint64_t index, std::string_view purpose);

}  // namespace tests
