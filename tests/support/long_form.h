#pragma once

#include <cstdlib>

namespace tests {

/// Whether a test tries every case (./check --long sets PALPATE_LONG) in place of a sample.
inline bool isLong() {
  return std::getenv("PALPATE_LONG") != nullptr;  // NOLINT(concurrency-mt-unsafe): one thread
}

/// @p every in the long form, @p sample otherwise.
inline int inLongForm(int every, int sample) {
  return isLong() ? every : sample;
}

}  // namespace tests
