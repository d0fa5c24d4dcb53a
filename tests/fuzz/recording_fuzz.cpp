#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "haptics/recordings/recording.h"

// Fuzzes the reader of recordings: it reads, or says what is wrong.

// NOLINTNEXTLINE(readability-identifier-naming): libFuzzer calls it
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t count) {
  const std::string_view text(reinterpret_cast<const char*>(data), count);
  try {
    const auto recording = haptics::recordings::readRecording(text);
    static_cast<void>(recording);
  } catch (const base::UserError& error) {
    if (std::string_view(error.what()).empty()) std::abort();
  }
  return 0;
}
