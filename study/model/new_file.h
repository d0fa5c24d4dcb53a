#pragma once

#include <filesystem>
#include <string>

namespace study {

/// Writes a file that is not there yet, and returns when it is on the disk.
/// @throws storage::StorageError  in words, if it is there already or cannot be written; nothing is
/// ever overwritten.
void writeNewFile(const std::string& path, const std::string& content);

/// An empty folder beside @p target that nobody else has, for what is to be renamed to @p target
/// once it is whole.
/// @throws storage::StorageError  in words, if it cannot be made.
std::filesystem::path newFolderBeside(const std::filesystem::path& target);

}  // namespace study
