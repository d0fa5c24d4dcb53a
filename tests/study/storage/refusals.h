#pragma once

#include <functional>
#include <string>

#include <gtest/gtest.h>

#include "study/model/storage_error.h"

namespace tests {

/// The error that a caller got.
struct Refusal {
  bool happened = false;
  study::storage::StorageError::Kind kind = study::storage::StorageError::Kind::Other;
  std::string words;
};

inline Refusal refusalOf(const std::function<void()>& action) {
  try {
    action();
  } catch (const study::storage::StorageError& error) {
    return {.happened = true, .kind = error.kind(), .words = error.what()};
  }
  return {};
}

/// Checks that a message is for an operator: long enough to say what failed, where, and what to do,
/// and not only a library's code.
inline void expectClear(const Refusal& refusal, const std::string& mentions) {
  EXPECT_TRUE(refusal.happened);
  EXPECT_NE(refusal.words.find(mentions), std::string::npos) << refusal.words;
  EXPECT_GT(refusal.words.size(), 40U) << refusal.words;
  EXPECT_EQ(std::string(".?\"").find(refusal.words.back()) == std::string::npos, false)
      << refusal.words;
}

}  // namespace tests
