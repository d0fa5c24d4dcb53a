// Independent implementations of the generators: plain shifts, no library.
#include "tests/base/reference_generators.h"

namespace tests {
namespace {

std::uint64_t turnedLeft(std::uint64_t word, unsigned by) {
  return (word << by) | (word >> (64U - by));
}

}  // namespace

std::uint64_t ReferenceXoshiro::next() {
  const std::uint64_t scrambled = turnedLeft(s[1] * 5U, 7) * 9U;
  const std::uint64_t shifted = s[1] << 17U;
  const auto before = s;
  s[1] = before[1] ^ before[2] ^ before[0];
  s[0] = before[0] ^ before[3] ^ before[1];
  s[2] = before[2] ^ before[0] ^ shifted;
  s[3] = turnedLeft(before[3] ^ before[1], 45);
  return scrambled;
}

std::uint64_t referenceSplitMix(std::uint64_t& state) {
  state += 11400714819323198485U;  // 2⁶⁴ / golden ratio, made odd
  std::uint64_t word = state;
  word ^= word >> 30U;
  word *= 13787848793156543929U;
  word ^= word >> 27U;
  word *= 10723151780598845931U;
  return word ^ (word >> 31U);
}

std::uint64_t referenceFnv1a(std::string_view text) {
  std::uint64_t hash = 14695981039346656037U;
  for (const char letter : text) {
    hash ^= static_cast<std::uint8_t>(letter);
    hash *= 1099511628211U;
  }
  return hash;
}

ReferenceXoshiro referenceStream(
    std::uint64_t seed, std::uint64_t index, std::string_view purpose) {
  std::uint64_t state = seed;
  state = referenceSplitMix(state) ^ index;
  state = referenceSplitMix(state) ^ referenceFnv1a(purpose);
  ReferenceXoshiro generator{};
  for (auto& word : generator.s) word = referenceSplitMix(state);
  return generator;
}

}  // namespace tests
