#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
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

/// Looks for texts in the bytes of files: in databases with their logs and free pages, in exports
/// and pages.
class ByteSearch {
 public:
  /// Adds what is looked for. Of a text the longest part is taken that every format writes alike
  /// (without quotes, line ends, '&', '<' and the like); too short a part is left out, because it
  /// would be found everywhere.
  /// @param shortest  [bytes]
  void add(const std::string& text, std::size_t shortest);

  /// The number of texts that are looked for.
  std::size_t size() const noexcept { return texts_.size(); }

  /// The files below @p folder that hold one of them, relative to it, in order.
  /// @param open  databases in that folder that this process has open. They are read through their
  ///     connection: another file handle, once closed, would take their locks away.
  /// @throws StorageError  if a file cannot be read
  std::vector<std::string> filesIn(
      const std::filesystem::path& folder, const std::vector<const Database*>& open) const;

 private:
  /// Reads on, at most so many bytes; 0 at the end.
  using Reader = std::function<std::size_t(char* to, std::size_t most)>;
  bool isIn(const Reader& read) const;
  bool isIn(const std::filesystem::path& file) const;

  std::vector<std::string> texts_;
};

}  // namespace study::storage
