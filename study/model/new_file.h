#pragma once

#include <filesystem>
#include <string>

namespace study {

/// From now on, files and folders that this process makes are for its own user alone: a study holds
/// answers of people. The rights of what exists stay. Call it before any thread starts.
void keepNewFilesPrivate() noexcept;

/// Writes a new file that its owner alone can read, and returns when content and name are on the
/// disk.
/// @throws storage::StorageError  in words, if the file exists already or cannot be written;
///     nothing is ever overwritten.
void writeNewFile(const std::string& path, const std::string& content);

/// A new empty folder beside @p target, for moveIntoPlace() when it is complete. Its owner alone
/// can read it.
/// @throws storage::StorageError  in words, if it cannot be made.
std::filesystem::path newFolderBeside(const std::filesystem::path& target);

/// A new folder for this account alone (0700), which the destructor removes with all that is in it.
class TemporaryFolder {
 public:
  /// @throws storage::StorageError  if @p inside takes no folder
  explicit TemporaryFolder(
      const std::filesystem::path& inside = std::filesystem::temp_directory_path())
      : path_(newFolderBeside(inside / "palpate")) {}
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  const std::filesystem::path& path() const noexcept { return path_; }
  std::filesystem::path operator/(const char* name) const { return path_ / name; }

 private:
  std::filesystem::path path_;
};

/// Returns when all files in @p folder, their names and its own are on the disk.
/// @throws storage::StorageError  in words, if the disk fails.
void flushFolder(const std::filesystem::path& folder);

/// Gives a complete folder its name. After a power cut it is there as a whole or not at all.
/// @throws storage::StorageError  in words, if it cannot be renamed or the disk fails.
void moveIntoPlace(const std::filesystem::path& folder, const std::filesystem::path& target);

}  // namespace study
