#pragma once

#include <functional>
#include <string>

#include <gtest/gtest.h>

#include "study/model/storage_error.h"

namespace tests {

/// What somebody was told who could not have what they wanted.
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

/// A sentence for the person at the desk: long enough to say what, to what, and what to do; no code
/// of a library alone.
inline void expectClear(const Refusal& refusal, const std::string& mentions) {
  EXPECT_TRUE(refusal.happened);
  EXPECT_NE(refusal.words.find(mentions), std::string::npos) << refusal.words;
  EXPECT_GT(refusal.words.size(), 40U) << refusal.words;
  EXPECT_EQ(std::string(".?\"").find(refusal.words.back()) == std::string::npos, false)
      << refusal.words;
}

}  // namespace tests
