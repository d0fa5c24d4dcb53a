#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "study/session/verification.h"
#include "tests/support/test_data.h"

namespace tests {

/// The names of all files below @p folder that hold @p text.
inline std::vector<std::string> filesWith(
    const std::filesystem::path& folder, const std::string& text) {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    if (!entry.is_regular_file()) continue;
    if (tests::contentOf(entry.path()).find(text) == std::string::npos) continue;
    names.push_back(entry.path().filename().string());
  }
  return names;
}

/// What verify() finds, one line each; empty for a sound study.
inline std::string problemsOf(study::Study& study, const study::VerifyOptions& options = {}) {
  std::string all;
  for (const auto& check : study::verify(study, {}, options).checks) {
    for (const auto& problem : check.problems) all += check.what + ": " + problem + "\n";
  }
  return all;
}

}  // namespace tests
