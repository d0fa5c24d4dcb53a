#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "protocols/reading/material_file.h"

// Fuzzes the reader of materials: words for every refusal.

// NOLINTNEXTLINE(readability-identifier-naming): libFuzzer calls it
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t count) {
  const std::string_view text(reinterpret_cast<const char*>(data), count);
  questionnaires::Problems problems;
  const auto read = protocols::readMaterial(text, problems);
  if (!read && problems.all().empty()) std::abort();
  return 0;
}
