#pragma once

#include <filesystem>
#include <string_view>

#include <gtest/gtest.h>

namespace tests {

/// The folder of the sources.
std::filesystem::path repository();

/// A file of tests/data: our own reference values, which are part of the repository.
std::filesystem::path testData(std::string_view relative);

/// A file of others that the repository must not contain: the recordings of the punch, NIST's
/// reference data. Its folder is PALPATE_FETCHED_DATA (docs/developing.md).
std::filesystem::path fetchedData(std::string_view relative);

}  // namespace tests

/// Skips a test if a fetched file is missing; ./check counts these tests.
#define SKIP_WITHOUT_FETCHED_DATA(relative)                                                      \
  if (!std::filesystem::exists(tests::fetchedData(relative))) {                                  \
    GTEST_SKIP() << "needs data that are not ours to ship (PALPATE_FETCHED_DATA): " << relative; \
  }                                                                                              \
  static_assert(true)
