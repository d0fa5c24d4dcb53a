#include "base/random.h"

#include <bit>
#include <cmath>

namespace base {
namespace {

std::uint64_t fnv1a(std::string_view text) noexcept {
  std::uint64_t hash = 0xcbf29ce484222325U;
  for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3U;
  return hash;
}

}  // namespace

RandomStream::RandomStream(
    std::uint64_t seed, std::uint64_t index, std::string_view purpose) noexcept
    : state_{} {
  SplitMix64 withIndex(SplitMix64(seed).bits() ^ index);
  SplitMix64 withPurpose(withIndex.bits() ^ fnv1a(purpose));
  for (auto& word : state_) word = withPurpose.bits();
}

std::uint64_t RandomStream::bits() noexcept {
  const std::uint64_t result = std::rotl(state_[1] * 5, 7) * 9;
  const std::uint64_t t = state_[1] << 17;
  state_[2] ^= state_[0];
  state_[3] ^= state_[1];
  state_[1] ^= state_[2];
  state_[0] ^= state_[3];
  state_[2] ^= t;
  state_[3] = std::rotl(state_[3], 45);
  return result;
}

std::uint64_t RandomStream::below(std::uint64_t bound) noexcept {
  // 2⁶⁴ mod bound. Draws below it are rejected: they would make small numbers more likely.
  const std::uint64_t unfair = -bound % bound;
  std::uint64_t draw = bits();
  while (draw < unfair) draw = bits();
  return draw % bound;
}

double RandomStream::uniform() noexcept {
  return static_cast<double>(bits() >> 11) * 0x1.0p-53;
}

double RandomStream::normal() noexcept {
  double u = 0.0;
  double square = 0.0;
  do {
    u = uniform(-1.0, 1.0);
    const double v = uniform(-1.0, 1.0);
    square = u * u + v * v;
  } while (square >= 1.0 || square == 0.0);
  return u * std::sqrt(-2.0 * std::log(square) / square);
}

}  // namespace base
