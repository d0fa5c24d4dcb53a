#pragma once

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "questionnaires/json/problem.h"

namespace tests {

/// A faulty data file NAME.json, and parts of the problem that its reader must report. They are
/// the line "path | what | fix" of NAME.refused beside it; a fix that is empty is left out.
struct RefusedFile {
  std::string name;
  std::string path;
  std::string what;
  std::string fix;
};

/// The data files of @p folder. Adds a failure if one has no NAME.refused, or the reverse.
inline std::vector<RefusedFile> refusedFiles(const std::filesystem::path& folder) {
  std::vector<RefusedFile> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    const auto& file = entry.path();
    if (file.extension() == ".refused") {
      EXPECT_TRUE(exists(std::filesystem::path(file).replace_extension(".json"))) << file;
    }
    if (file.extension() != ".json") continue;
    std::ifstream stream(std::filesystem::path(file).replace_extension(".refused"));
    std::string line;
    EXPECT_TRUE(std::getline(stream, line)) << file << " has no .refused beside it";
    std::vector<std::string> parts{""};
    for (std::size_t i = 0; i < line.size(); ++i) {
      if (line.compare(i, 3, " | ") == 0) {
        parts.emplace_back();
        i += 2;
      } else {
        parts.back() += line[i];
      }
    }
    EXPECT_GE(parts.size(), 2U) << file;
    parts.resize(3);
    files.push_back({file.stem().string(), parts[0], parts[1], parts[2]});
  }
  EXPECT_FALSE(files.empty()) << folder;
  return files;
}

/// Adds a failure unless @p problems have the one that @p file should have.
inline void expectProblem(
    const RefusedFile& file, const std::vector<questionnaires::Problem>& problems) {
  const auto isExpected = [&](const questionnaires::Problem& problem) {
    return problem.severity == questionnaires::Severity::Error && problem.path == file.path &&
           base::describe(problem.what).find(file.what) != std::string::npos &&
           base::describe(problem.fix).find(file.fix) != std::string::npos;
  };
  EXPECT_TRUE(std::any_of(problems.begin(), problems.end(), isExpected)) << file.name << "\n"
                                                                         << describe(problems);
}

}  // namespace tests
