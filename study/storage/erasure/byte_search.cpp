#include "study/storage/erasure/byte_search.h"

#include <algorithm>
#include <fstream>
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

namespace {

namespace fs = std::filesystem;

constexpr std::size_t kBytesPerRead = 1 << 20;  // [bytes]

std::string longestPlainPart(const std::string& text) {
  constexpr std::string_view kWrittenDifferently = "\"'&<>\\\r\n\t";
  std::string longest;
  for (std::size_t begin = 0; begin <= text.size();) {
    const auto end = std::min(text.find_first_of(kWrittenDifferently, begin), text.size());
    if (end - begin > longest.size()) longest = text.substr(begin, end - begin);
    begin = end + 1;
  }
  return longest;
}

/// Whether @p file is one of the @p open databases, or the log or shared memory of one.
bool isOf(const std::vector<const Database*>& open, const fs::path& file) {
  return std::ranges::any_of(open, [&](const Database* database) {
    const auto& path = database->path();
    return file == path || file == path + "-wal" || file == path + "-shm";
  });
}

}  // namespace

void ByteSearch::add(const std::string& text, std::size_t shortest) {
  auto part = longestPlainPart(text);
  const bool isNew = std::ranges::find(texts_, part) == texts_.end();
  if (part.size() < shortest) {
    ++ignored_;
  } else if (isNew) {
    texts_.push_back(std::move(part));
  }
}

void ByteSearch::ignorePartsOf(std::string_view text) {
  ignored_ += std::erase_if(texts_, [&](const auto& part) { return text.find(part) != text.npos; });
}

bool ByteSearch::isIn(const Reader& read) const {
  std::size_t longest = 1;
  for (const auto& text : texts_) longest = std::max(longest, text.size());
  std::string bytes;
  while (true) {
    // A text may extend over two blocks: keep the end of the previous one.
    bytes.erase(0, bytes.size() - std::min(bytes.size(), longest - 1));
    const auto kept = bytes.size();
    bytes.resize(kept + kBytesPerRead);
    const auto came = read(bytes.data() + kept, kBytesPerRead);
    if (came == 0) return false;
    bytes.resize(kept + came);
    const bool isFound = std::ranges::any_of(
        texts_, [&](const auto& text) { return bytes.find(text) != std::string::npos; });
    if (isFound) return true;
  }
}

bool ByteSearch::isIn(const fs::path& file) const {
  std::ifstream stream(file, std::ios::binary);
  if (!stream) throw StorageError(file.string() + " cannot be read.");
  return isIn([&](char* to, std::size_t most) {
    stream.read(to, static_cast<std::streamsize>(most));
    if (stream.bad()) throw StorageError(file.string() + " cannot be read to its end.");
    return static_cast<std::size_t>(stream.gcount());
  });
}

std::vector<std::string> ByteSearch::filesIn(
    const fs::path& folder, const std::vector<const Database*>& open) const {
  std::vector<std::string> found;
  if (texts_.empty()) return found;
  const auto relative = [&](const fs::path& file) {
    return file.lexically_relative(folder).generic_string();
  };
  for (const auto* database : open) {
    for (auto& file : rawFilesOf(*database)) {
      if (isIn([&](char* to, std::size_t most) { return file.read(to, most); })) {
        found.push_back(relative(file.path()));
      }
    }
  }
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    const bool isSearched = entry.is_regular_file() && !isOf(open, entry.path());
    if (isSearched && isIn(entry.path())) found.push_back(relative(entry.path()));
  }
  std::ranges::sort(found);
  return found;
}

}  // namespace study::storage
