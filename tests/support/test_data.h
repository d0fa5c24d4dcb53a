#pragma once

#include <filesystem>
#include <string_view>

#include <gtest/gtest.h>

namespace tests {

/// The folder of the sources.
std::filesystem::path repository();

/// A file of tests/data: reference values that are our own, and always there.
std::filesystem::path testData(std::string_view relative);

/// A file that others own and that the repository does not hold: the recordings of the punch,
/// NIST's reference data. Its folder is PALPATE_FETCHED_DATA (docs/developing.md).
std::filesystem::path fetchedData(std::string_view relative);

}  // namespace tests

/// Leaves a test where a fetched file is missing; ./check counts these tests.
#define SKIP_WITHOUT_FETCHED_DATA(relative)                                                      \
  if (!std::filesystem::exists(tests::fetchedData(relative))) {                                  \
    GTEST_SKIP() << "needs data that are not ours to ship (PALPATE_FETCHED_DATA): " << relative; \
  }                                                                                              \
  static_assert(true)
