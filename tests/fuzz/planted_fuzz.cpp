#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

// The control of the fuzz targets: a fault that only one word reaches. A fuzzer that sees which
// branches are taken finds it letter by letter; one that does not never does.

// NOLINTNEXTLINE(readability-identifier-naming): libFuzzer calls it
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t count) {
  constexpr std::string_view kWord = "palpate";
  std::size_t right = 0;
  while (right < count && right < kWord.size() && data[right] == std::uint8_t(kWord[right])) {
    ++right;
  }
  if (right == kWord.size()) std::abort();
  return 0;
}
