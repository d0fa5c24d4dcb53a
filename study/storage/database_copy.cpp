// Copies a database file in a consistent state while others write to it.
#include <filesystem>
#include <memory>

#include <sqlite3.h>

#include "study/storage/database.h"
#include "study/storage/statement.h"

namespace study::storage {
namespace {

// 1 MiB. After each part of this size, progress is reported and the copying can be cancelled.
constexpr int kPagesAtATime = 256;

struct BackupDeleter {
  void operator()(sqlite3_backup* backup) const noexcept { sqlite3_backup_finish(backup); }
};

}  // namespace

void Database::beginSnapshot() {
  execute("BEGIN");  // takes no lock yet: the snapshot is taken by the first statement that reads
  Statement look(*this, "SELECT count(*) FROM sqlite_schema");
  look.step();
}

void Database::copyTo(
    const std::string& path, const std::function<void(double share)>& progress) const {
  if (std::filesystem::exists(path)) {
    throw StorageError(
        path + " is there already. Nothing is ever overwritten: choose another folder.");
  }
  const Database copy(path, SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE);
  const std::unique_ptr<sqlite3_backup, BackupDeleter> backup(
      sqlite3_backup_init(copy.handle_, "main", handle_, "main"));
  if (!backup) copy.fail(sqlite3_errcode(copy.handle_), "write to");
  int code = SQLITE_OK;
  while (code == SQLITE_OK) {
    code = sqlite3_backup_step(backup.get(), kPagesAtATime);
    const int pages = sqlite3_backup_pagecount(backup.get());
    const int left = sqlite3_backup_remaining(backup.get());
    if (code == SQLITE_OK && progress && pages > 0) progress(1.0 - 1.0 * left / pages);
  }
  if (code != SQLITE_DONE) {
    throw StorageError(
        "Could not copy " + path_ + " to " + path + " (" + sqlite3_errstr(code) +
            "). Check the room on both disks, and who may write there.",
        code == SQLITE_FULL ? StorageError::Kind::DiskFull : StorageError::Kind::Other);
  }
}

std::string Database::quickCheckProblems() {
  return problemsFoundBy("PRAGMA quick_check(20)");
}

std::string Database::problemsFoundBy(const char* pragma) {
  std::string problems;
  Statement check(*this, pragma);
  while (check.step()) {
    if (check.text(0) != "ok") problems += path_ + ": " + check.text(0) + "\n";
  }
  return problems;
}

}  // namespace study::storage
