#pragma once

#include <string>

namespace study {

/// Writes a file that is not there yet, and returns when it is on the disk.
/// @throws storage::StorageError  in words, if it is there already or cannot be written; nothing is
/// ever overwritten.
void writeNewFile(const std::string& path, const std::string& content);

}  // namespace study
