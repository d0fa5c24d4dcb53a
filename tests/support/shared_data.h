#pragma once

#include <filesystem>
#include <string_view>

#include <gtest/gtest.h>

namespace tests {

/// Where the shared recordings and golden values lie; they are no part of the project.
std::filesystem::path sharedData(std::string_view relative);

}  // namespace tests

/// Leaves a test, and says why, where the shared data are not there.
#define SKIP_WITHOUT_SHARED_DATA(relative)                                                  \
  if (!std::filesystem::exists(tests::sharedData(relative))) {                              \
    GTEST_SKIP() << "needs " << tests::sharedData(relative)                                 \
                 << ", which is not here; set PALPATE_SHARED_DATA when configuring";        \
  }                                                                                         \
  static_assert(true)
