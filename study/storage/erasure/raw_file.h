#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "study/storage/database.h"

struct sqlite3_file;

namespace study::storage {

/// A file of a database, byte by byte, as SQLite itself reads it. The connection must outlive it.
class RawFile {
 public:
  RawFile(std::string path, sqlite3_file* file);

  const std::string& path() const noexcept { return path_; }

  /// Reads on, at most @p most bytes. @return  how many; 0 at the end. @throws StorageError
  std::size_t read(char* to, std::size_t most);

 private:
  std::string path_;
  sqlite3_file* file_;
  std::int64_t size_ = 0;
  std::int64_t at_ = 0;
};

/// The database file, and its write-ahead log if that is open.
std::vector<RawFile> rawFilesOf(const Database& database);

}  // namespace study::storage
