#include "questionnaires/reading/instrument_file.h"
#include "tests/fuzz/reader_fuzz.h"

// Fuzzes the reader of questionnaires: words for every refusal.

// NOLINTNEXTLINE(readability-identifier-naming): libFuzzer calls it
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t count) {
  return tests::refusesInWords(data, count, [](auto text, auto& problems) {
    return questionnaires::readInstrument(text, problems);
  });
}
