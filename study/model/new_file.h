#pragma once

#include <filesystem>
#include <string>

namespace study {

/// Sets the umask: new files and folders of this process can be used by its own user only, because
/// a study holds answers of people. Permissions of existing files stay. Call it before any thread
/// starts.
void setPrivateUmask() noexcept;

/// If this process crashes, the system keeps no image of its memory, which has names and
/// conditions: neither as a file nor for a program that collects such images.
void forbidCoreFiles() noexcept;

/// Whether the error of a system call (errno) says that there is no room: on the disk, or in this
/// account's share of it.
bool isForLackOfRoom(int error) noexcept;

/// Writes a new file that its owner alone can read, and returns when content and name are on the
/// disk.
/// @throws storage::StorageError  if the file exists already or cannot be written; nothing is ever
///     overwritten.
void writeNewFile(const std::string& path, const std::string& content);

/// Called before work whose result becomes a new file.
/// @throws storage::StorageError  if the file exists already or its folder cannot be written.
void requireNewFile(const std::string& path);

/// What makeFolderBeside() appends to the name of the target, before some random letters.
constexpr const char* kUnfinished = ".unfinished-";

/// A new empty folder beside @p target, for moveIntoPlace() when it is complete. Its owner alone
/// can read it.
/// @throws storage::StorageError  if it cannot be made.
std::filesystem::path makeFolderBeside(const std::filesystem::path& target);

/// A new folder for this account alone (0700). The destructor removes it with its content.
class TemporaryFolder {
 public:
  /// @throws storage::StorageError  if no folder can be made in @p inside
  explicit TemporaryFolder(
      const std::filesystem::path& inside = std::filesystem::temp_directory_path())
      : path_(makeFolderBeside(inside / "palpate")) {}
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  const std::filesystem::path& path() const noexcept { return path_; }
  std::filesystem::path operator/(const char* name) const { return path_ / name; }

 private:
  std::filesystem::path path_;
};

/// Flushes all files in @p folder, their directory entries and that of the folder to the disk.
/// @throws storage::StorageError  if the disk fails.
void flushFolder(const std::filesystem::path& folder);

/// Flushes a complete folder and renames it to @p target. After a power cut the target is complete
/// or absent.
/// @throws storage::StorageError  if it cannot be renamed or the disk fails.
void moveIntoPlace(const std::filesystem::path& folder, const std::filesystem::path& target);

}  // namespace study
