#include "study/storage/erasure/raw_file.h"

#include <algorithm>
#include <utility>

#include <sqlite3.h>

namespace study::storage {
namespace {

sqlite3_file* fileOf(const Database& database, int which) {
  sqlite3_file* file = nullptr;
  const int code = sqlite3_file_control(database.handle(), "main", which, &file);
  const bool isOpen = code == SQLITE_OK && file != nullptr && file->pMethods != nullptr;
  return isOpen ? file : nullptr;
}

}  // namespace

RawFile::RawFile(std::string path, sqlite3_file* file) : path_(std::move(path)), file_(file) {
  sqlite3_int64 size = 0;
  if (file_->pMethods->xFileSize(file_, &size) != SQLITE_OK) {
    throw StorageError(path_ + " cannot be read byte by byte.");
  }
  size_ = size;
}

std::size_t RawFile::read(char* to, std::size_t most) {
  const auto wanted = std::min(static_cast<std::int64_t>(most), size_ - at_);
  if (wanted <= 0) return 0;
  if (file_->pMethods->xRead(file_, to, static_cast<int>(wanted), at_) != SQLITE_OK) {
    throw StorageError(path_ + " cannot be read byte by byte.");
  }
  at_ += wanted;
  return static_cast<std::size_t>(wanted);
}

std::vector<RawFile> rawFilesOf(const Database& database) {
  std::vector<RawFile> files;
  if (auto* file = fileOf(database, SQLITE_FCNTL_FILE_POINTER)) {
    files.emplace_back(database.path(), file);
  }
  if (auto* log = fileOf(database, SQLITE_FCNTL_JOURNAL_POINTER)) {
    files.emplace_back(database.path() + "-wal", log);
  }
  return files;
}

}  // namespace study::storage
