#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "study/storage/database.h"

struct sqlite3_file;

namespace study::storage {

/// The bytes of a database file, read through the file handle of SQLite. The connection must
/// outlive this object.
class RawFile {
 public:
  RawFile(std::string path, sqlite3_file* file);

  const std::string& path() const noexcept { return path_; }

  /// Reads the next bytes, at most @p most, into @p to. @return their number; 0 at the end of the
  /// file.
  /// @throws StorageError
  std::size_t read(char* to, std::size_t most);

 private:
  std::string path_;
  sqlite3_file* file_;
  std::int64_t size_ = 0;
  std::int64_t at_ = 0;
};

/// The database file and, if it is open, its write-ahead log.
std::vector<RawFile> rawFilesOf(const Database& database);

/// Searches the bytes of files for texts: of databases with their logs and free pages, and of
/// exports and HTML pages.
class ByteSearch {
 public:
  /// Adds a text to search for. Only its longest part is used that every file format writes
  /// unchanged (without quotes, line ends, '&', '<' and the like). If this part is shorter than
  /// @p shortest, the text is ignored, because it would be found by chance.
  /// @param shortest  [bytes]
  void add(const std::string& text, std::size_t shortest);

  /// Ignores the texts that are part of @p text, which stays: finding them would say nothing.
  void ignorePartsOf(std::string_view text);

  /// The number of texts to search for.
  std::size_t size() const noexcept { return texts_.size(); }
  /// The number of texts that are not searched for: too short, or ignored by ignorePartsOf().
  std::size_t ignored() const noexcept { return ignored_; }

  /// The files below @p folder that contain one of the texts, as sorted paths relative to @p
  /// folder.
  /// @param open  databases in that folder that this process has open. They are read through their
  ///     connection, because closing another handle of the file would release their locks.
  /// @throws StorageError  if a file cannot be read
  std::vector<std::string> filesIn(
      const std::filesystem::path& folder, const std::vector<const Database*>& open) const;

 private:
  /// Reads the next bytes, at most @p most, into @p to; returns their number, 0 at the end.
  using Reader = std::function<std::size_t(char* to, std::size_t most)>;
  /// Whether the bytes contain one of the texts.
  bool isIn(const Reader& read) const;
  bool isIn(const std::filesystem::path& file) const;

  std::vector<std::string> texts_;
  std::size_t ignored_ = 0;
};

}  // namespace study::storage
