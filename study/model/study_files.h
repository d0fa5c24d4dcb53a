#pragma once

#include <filesystem>
#include <string>

namespace study {

/// The files of a study. Answers, traces and names are in separate databases.
struct StudyFiles {
  std::filesystem::path folder;

  /// The paths of the files.
  std::string study() const { return (folder / "study.db").string(); }
  std::string traces() const { return (folder / "traces.db").string(); }
  std::string identity() const { return (folder / "identity.db").string(); }
};

}  // namespace study
