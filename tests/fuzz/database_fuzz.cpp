#include <unistd.h>

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "study/storage/content_hash.h"
#include "study/storage/database.h"
#include "study/storage/event_log.h"
#include "study/storage/records.h"
#include "study/storage/study_schema.h"

// Fuzzes the pages of a study's database: whatever bytes are changed, it is read or refused in
// words. Three bytes of input are a place and the byte that is written there.

namespace {

namespace fs = std::filesystem;
using namespace study::storage;

const fs::path& folder() {
  static const fs::path made = [] {
    auto name = fs::temp_directory_path() / ("palpate-fuzz-" + std::to_string(getpid()));
    fs::create_directory(name);
    return name;
  }();
  return made;
}

/// The bytes of an intact study.db.
const std::string& intact() {
  static const std::string bytes = [] {
    const auto path = folder() / "intact.db";
    {
      auto database = Database::create(path.string(), studySchema());
      EventLog events(database);
      for (int i = 0; i < 40; ++i) {
        events.append({.kind = study::EventKind::Note, .detail = "event " + std::to_string(i)});
      }
    }
    std::ifstream file(path, std::ios::binary);
    return std::string{std::istreambuf_iterator<char>(file), {}};
  }();
  return bytes;
}

void readAll(const std::string& path) {
  auto database = Database::open(path, studySchema(), Database::Access::ReadOnly);
  database.integrityProblems();
  EventLog events(database);
  events.firstBreak();
  events.read();
  contentHash(database);
  const Records records(database);
  records.sessions();
  records.answers();
  records.trials();
}

}  // namespace

// NOLINTNEXTLINE(readability-identifier-naming): libFuzzer calls it
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t count) {
  std::string bytes = intact();
  for (std::size_t i = 0; i + 3 <= count; i += 3) {
    const std::size_t place = 256U * data[i] + data[i + 1];
    bytes[place % bytes.size()] = static_cast<char>(data[i + 2]);
  }
  const std::string path = folder() / "study.db";
  std::ofstream(path, std::ios::binary | std::ios::trunc) << bytes;
  try {
    readAll(path);
  } catch (const StorageError& error) {
    if (std::string(error.what()).empty()) std::abort();
  }
  for (const char* more : {"", "-wal", "-shm"}) fs::remove(path + more);
  return 0;
}
