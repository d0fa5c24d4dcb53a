#pragma once

#include <string_view>

#include <gtest/gtest.h>

namespace tests {

/// Whether @p words are in @p text; a failure prints both.
inline testing::AssertionResult says(std::string_view text, std::string_view words) {
  constexpr std::size_t kMostPrinted = 20'000;
  if (text.find(words) != std::string_view::npos) return testing::AssertionSuccess();
  return testing::AssertionFailure()
         << '"' << words << "\" is not in \"" << text.substr(0, kMostPrinted) << '"';
}

}  // namespace tests
