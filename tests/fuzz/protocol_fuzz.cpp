#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "protocols/load_protocol.h"

// Fuzzes the reader of protocols and all checks behind it: words for every refusal.

// NOLINTNEXTLINE(readability-identifier-naming): libFuzzer calls it
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t count) {
  const std::string_view text(reinterpret_cast<const char*>(data), count);
  questionnaires::Problems problems;
  const auto nothing = [](const auto&) { return std::nullopt; };
  const auto read = protocols::loadProtocol(text, nothing, problems);
  if (!read && problems.all().empty()) std::abort();
  return 0;
}
