#include "protocols/load_protocol.h"
#include "tests/fuzz/reader_fuzz.h"

// Fuzzes the reader of protocols and all checks behind it: words for every refusal.

// NOLINTNEXTLINE(readability-identifier-naming): libFuzzer calls it
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t count) {
  return tests::refusesInWords(data, count, [](auto text, auto& problems) {
    const auto nothing = [](const auto&) { return std::nullopt; };
    return protocols::loadProtocol(text, nothing, problems);
  });
}
