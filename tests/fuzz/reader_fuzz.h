#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "questionnaires/json/problem.h"

namespace tests {

/// Aborts where @p read refuses a text without saying what is wrong with it. Returns 0, as
/// libFuzzer wants it.
int refusesInWords(const std::uint8_t* data, std::size_t count, const auto& read) {
  const std::string_view text(reinterpret_cast<const char*>(data), count);
  questionnaires::Problems problems;
  if (!read(text, problems) && problems.all().empty()) std::abort();
  return 0;
}

}  // namespace tests
