#pragma once

#include <filesystem>
#include <string>

namespace study {

/// Writes a new file, and returns when its content is on the disk.
/// @throws storage::StorageError  in words, if the file exists already or cannot be written;
///     nothing is ever overwritten.
void writeNewFile(const std::string& path, const std::string& content);

/// A new empty folder beside @p target, to be renamed to @p target when it is complete.
/// @throws storage::StorageError  in words, if it cannot be made.
std::filesystem::path newFolderBeside(const std::filesystem::path& target);

}  // namespace study
