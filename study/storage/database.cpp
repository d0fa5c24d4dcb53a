#include "study/storage/database.h"

#include <sys/statvfs.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <filesystem>
#include <new>
#include <string_view>
#include <thread>
#include <utility>

#include <sqlite3.h>

#include "study/model/messages.h"
#include "study/model/new_file.h"
#include "study/storage/local_disk.h"
#include "study/storage/statement.h"

namespace study::storage {
namespace {

constexpr std::chrono::milliseconds kBusyPause{2};
constexpr std::chrono::seconds kLongestWait{3};   // for a lock; then the caller gets an error
constexpr std::size_t kMostIdleStatements = 200;  // statements of a few kB; the program has fewer

/// Whether no account can write the file (an archive, or a read-only disk) and the file has no
/// write-ahead log. SQLite cannot read a file with a log without write access.
bool isUnwritable(const std::string& path) {
  namespace fs = std::filesystem;
  constexpr auto kAnyWrite =
      fs::perms::owner_write | fs::perms::group_write | fs::perms::others_write;
  std::error_code error;
  if (fs::exists(path + "-wal", error) || error) return false;
  const auto mayWrite = [&](const fs::path& what) {
    return (fs::status(what, error).permissions() & kAnyWrite) != fs::perms::none;
  };
  struct statvfs disk {};
  const auto folder = fs::absolute(path).parent_path();
  const bool isReadOnlyDisk = statvfs(folder.c_str(), &disk) == 0 && (disk.f_flag & ST_RDONLY) != 0;
  return isReadOnlyDisk || (!mayWrite(path) && !mayWrite(folder) && !error);
}

/// A URI that makes SQLite read the file without locks and without a log ("immutable=1").
std::string immutableUri(const std::string& path) {
  std::string name = "file:";
  for (const char c : std::filesystem::absolute(path).lexically_normal().string()) {
    constexpr std::string_view kReservedInUris = "%?#";
    name += kReservedInUris.find(c) == std::string_view::npos ? std::string(1, c)
            : c == '%'                                        ? "%25"
            : c == '?'                                        ? "%3f"
                                                              : "%23";
  }
  return name + "?immutable=1";
}

/// The errno of a call on the database's files that failed for lack of room; 0: none did.
/// sqlite3_system_errno() has none where a commit fails, but the log and the file have it.
int lackOfRoomIn(sqlite3* database) {
  std::array<int, 3> errors{sqlite3_system_errno(database)};
  sqlite3_file_control(database, "main", SQLITE_FCNTL_LAST_ERRNO, &errors[1]);
  sqlite3_file* log = nullptr;
  sqlite3_file_control(database, "main", SQLITE_FCNTL_JOURNAL_POINTER, static_cast<void*>(&log));
  if (log != nullptr && log->pMethods != nullptr) {
    log->pMethods->xFileControl(log, SQLITE_FCNTL_LAST_ERRNO, &errors[2]);
  }
  const auto* found = std::ranges::find_if(errors, isForLackOfRoom);
  return found == errors.end() ? 0 : *found;
}

bool isTooLong(const std::string& path) {
  const auto* system = sqlite3_vfs_find(nullptr);
  const auto length = std::filesystem::absolute(path).string().size();
  return system != nullptr && length >= static_cast<std::size_t>(system->mxPathname);
}

std::int64_t pragmaNumber(const Database& database, const std::string& name) {
  Statement statement(database, "PRAGMA " + name);
  return statement.step() ? statement.number(0) : 0;
}

/// Whether there is nothing in the file, as in one of 0 bytes.
bool isEmpty(const Database& database) {
  Statement any(database, "SELECT 1 FROM sqlite_schema");
  return !any.step();
}

/// SQLite's busy handler: waits while another program writes; returns 0 to give up. SQLite's own
/// handler waits longer each time, up to 0.1 s, and finds the file busy every time while two other
/// stations write without a pause. The clock decides, because a pause is longer where many programs
/// want the processor.
int waitForOthers(void* /*unused*/, int pauses) {
  thread_local std::chrono::steady_clock::time_point begin;  // a thread waits for one at a time
  const auto now = std::chrono::steady_clock::now();
  if (pauses == 0) begin = now;
  if (now - begin >= kLongestWait) return 0;
  std::this_thread::sleep_for(kBusyPause);
  return 1;
}

/// SQLite's statistics of its memory, which nothing here reads, have one lock for all databases:
/// threads with a database each would wait for each other at every allocation.
void switchMemoryStatisticsOff() {
  // Has no effect once SQLite is initialised.
  [[maybe_unused]] static const int code = sqlite3_config(SQLITE_CONFIG_MEMSTATUS, 0);
}

}  // namespace

Database::Database(std::string path, int flags, Reading reading) : path_(std::move(path)) {
  switchMemoryStatisticsOff();
  const bool isOnlyRead = (flags & SQLITE_OPEN_READONLY) != 0;
  const bool isImmutable = isOnlyRead && (reading == Reading::Immutable || isUnwritable(path_));
  const int code = sqlite3_open_v2(
      (isImmutable ? immutableUri(path_) : path_).c_str(),
      &handle_,
      flags | SQLITE_OPEN_EXRESCODE | SQLITE_OPEN_NOMUTEX | (isImmutable ? SQLITE_OPEN_URI : 0),
      nullptr);
  if (code == SQLITE_OK) {
    sqlite3_busy_handler(handle_, waitForOthers, nullptr);
    return;
  }
  const std::string reason = handle_ != nullptr ? sqlite3_errmsg(handle_) : sqlite3_errstr(code);
  const int error = handle_ != nullptr ? sqlite3_system_errno(handle_) : 0;
  sqlite3_close(handle_);
  handle_ = nullptr;
  throw StorageError(
      path_ + " cannot be opened (" + reason + "). " +
      (isTooLong(path_) ? "Its path is too long: choose a folder with a shorter one."
       : error == EACCES
           ? "This account may not use it, or its folder: ask their owner for the rights."
           : "Check that the folder exists and may be written."));
}

Database::~Database() {
  closeIdleStatements();
  sqlite3_close(handle_);
}

Database::Database(Database&& other) noexcept
    : path_(std::move(other.path_)),
      handle_(std::exchange(other.handle_, nullptr)),
      isRollbackScheduled_(other.isRollbackScheduled_),
      key_(other.key_),
      idleStatements_(std::exchange(other.idleStatements_, {})) {}

Database Database::create(const std::string& path, const Schema& schema) {
  if (std::filesystem::exists(path)) {
    throw StorageError(
        path + " is there already. Nothing is ever overwritten: choose another folder.");
  }
  requireLocalDisk(path);
  Database database(path, SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE);
  database.configure(Access::ReadWrite);
  database.execute("PRAGMA application_id = " + std::to_string(schema.applicationId));
  database.migrateSchema(schema, Access::ReadWrite);
  return database;
}

Database Database::open(const std::string& path, const Schema& schema, Access access) {
  namespace fs = std::filesystem;
  std::error_code whyNot;
  std::error_code ignored;
  if (!fs::exists(path, whyNot)) {
    if (!whyNot)
      throw StorageError("There is no file " + path + ". Is this the folder of a study?");
    throw StorageError(
        path + " cannot be read (" + whyNot.message() + "). Check who may read it and its folder.");
  }
  try {
    return openWithReading(path, schema, access, Reading::SharedLocks);
  } catch (const StorageError& error) {
    if (error.kind() != StorageError::Kind::DiskFull) throw;
  }
  // Even a reader needs some disk space, for the memory that it shares with other programs. If
  // there is none, a file without a log is complete, and no program can write a log to a full disk.
  const bool hasSpace = ReservedSpace(fs::absolute(path).parent_path()).release();
  const bool hasLog =
      fs::exists(path + "-wal", ignored) && fs::file_size(path + "-wal", ignored) > 0;
  const bool isAlone = !hasSpace && !hasLog && access == Access::ReadOnly;
  return openWithReading(path, schema, access, isAlone ? Reading::Immutable : Reading::SharedLocks);
}

Database Database::openWithReading(
    const std::string& path, const Schema& schema, Access access, Reading reading) {
  const bool isReadOnly = access == Access::ReadOnly;
  Database database(path, isReadOnly ? SQLITE_OPEN_READONLY : SQLITE_OPEN_READWRITE, reading);
  database.requireApplicationId(schema);
  database.configure(access);
  database.migrateSchema(schema, access);
  return database;
}

Database Database::inMemory(const Schema& schema) {
  Database database(":memory:", SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE);
  database.execute("PRAGMA foreign_keys = ON");
  database.migrateSchema(schema, Access::ReadWrite);
  return database;
}

void Database::configure(Access access) {
  // A damaged or foreign file must not run functions from its schema or make SQLite read beyond a
  // page. Without a memory map, an I/O error is a return code instead of a signal.
  sqlite3_db_config(handle_, SQLITE_DBCONFIG_DEFENSIVE, 1, nullptr);
  execute("PRAGMA trusted_schema = OFF; PRAGMA cell_size_check = ON; PRAGMA mmap_size = 0");
  requirePragma("foreign_keys", "ON", "1");
  if (access == Access::ReadOnly) return;
  requirePragma("journal_mode", "WAL", "wal");
  requirePragma("synchronous", "FULL", "2");
}

void Database::requirePragma(
    const std::string& name, const std::string& value, const std::string& expected) {
  execute("PRAGMA " + name + " = " + value);
  Statement statement(*this, "PRAGMA " + name);
  if (!statement.step() || statement.text(0) != expected) {
    throw StorageError(
        path_ + " cannot be opened safely (" + name + " is not " + value +
        "). Is the folder on a disk of this computer, and may it be written?");
  }
}

void Database::requireApplicationId(const Schema& schema) const {
  std::int64_t id = 0;
  std::int64_t version = 0;
  try {
    id = pragmaNumber(*this, "application_id");
    version = pragmaNumber(*this, "user_version");
  } catch (const StorageError& error) {
    if (error.kind() != StorageError::Kind::Damaged) throw;
    throw StorageError(
        path_ + " is damaged, or no database at all. Restore it from a copy; do not go on with it.",
        StorageError::Kind::Damaged);
  }
  const std::string name(schema.name);
  if (id == 0 && version == 0 && isEmpty(*this)) {
    throw StorageError(
        path_ +
            " is empty: it was lost, or not finished when it was made. Restore it from a copy; if "
            "the folder is new and there is none, remove the folder and make the study again.",
        StorageError::Kind::Damaged);
  }
  if (id != schema.applicationId) {
    throw StorageError(
        path_ + " is a database, but not " + name + ". Choose the folder of a study.",
        StorageError::Kind::Damaged);
  }
  if (version > static_cast<std::int64_t>(schema.steps.size())) {
    throw StorageError(
        path_ + " was written by a newer version of palpate (format " + std::to_string(version) +
            "; this one knows " + std::to_string(schema.steps.size()) +
            "). Install the newer version; nothing has been changed.",
        StorageError::Kind::Newer);
  }
}

void Database::migrateSchema(const Schema& schema, Access access) {
  const auto newest = static_cast<std::int64_t>(schema.steps.size());
  auto version = pragmaNumber(*this, "user_version");
  if (version == newest) return;
  if (access == Access::ReadOnly) {
    if (version >= static_cast<std::int64_t>(schema.oldestReadable)) return;
    throw StorageError(
        path_ + " is of an older format. Open the study once for writing to bring it up to date.");
  }
  // Read the version again inside the transaction, because another program may have converted the
  // file since.
  Transaction transaction(*this);
  for (version = pragmaNumber(*this, "user_version"); version < newest; ++version) {
    execute(std::string(schema.steps[static_cast<std::size_t>(version)]));
  }
  execute("PRAGMA user_version = " + std::to_string(newest));
  transaction.commit();
}

void Database::execute(const std::string& sql) {
  const int code = sqlite3_exec(handle_, sql.c_str(), nullptr, nullptr, nullptr);
  if (code != SQLITE_OK) fail(code, "write to");
}

void Database::rollBackIfScheduled() {
  // In autocommit mode there is no open transaction, and ROLLBACK would be an error: SQLite rolls
  // back by itself after some errors, for example a full disk.
  if (isRollbackScheduled_ && sqlite3_get_autocommit(handle_) == 0) execute("ROLLBACK");
  isRollbackScheduled_ = false;
}

bool Database::hasTable(const std::string& name) const {
  Statement table(*this, "SELECT 1 FROM sqlite_schema WHERE type = 'table' AND name = ?");
  return table.bindAll(name).step();
}

bool Database::hasColumn(const std::string& table, const std::string& column) const {
  return sqlite3_table_column_metadata(
             handle_,
             "main",
             table.c_str(),
             column.c_str(),
             nullptr,
             nullptr,
             nullptr,
             nullptr,
             nullptr) == SQLITE_OK;
}

std::string Database::integrityCheckProblems() {
  auto problems = problemsFoundBy("PRAGMA integrity_check(20)");
  Statement keys(*this, "PRAGMA foreign_key_check");
  while (keys.step()) {
    problems += path_ + ": a row of '" + keys.text(0) + "' refers to nothing\n";
  }
  return problems;
}

sqlite3_stmt* Database::compiled(const std::string& sql) const {
  if (const auto found = idleStatements_.find(sql); found != idleStatements_.end()) {
    sqlite3_stmt* statement = found->second;
    idleStatements_.erase(found);
    return statement;
  }
  sqlite3_stmt* statement = nullptr;
  const int code = sqlite3_prepare_v3(
      handle_,
      sql.c_str(),
      static_cast<int>(sql.size()),
      SQLITE_PREPARE_PERSISTENT,
      &statement,
      nullptr);
  if (code != SQLITE_OK) fail(code, "read");
  return statement;
}

void Database::giveBack(sqlite3_stmt* statement) const noexcept {
  if (statement == nullptr) return;  // its text contained no statement
  // An idle statement has no lock and no values of rows.
  sqlite3_reset(statement);
  sqlite3_clear_bindings(statement);
  // Some pragmas act when they are compiled.
  const std::string_view sql = sqlite3_sql(statement);
  if (!sql.starts_with("PRAGMA")) {
    if (idleStatements_.size() >= kMostIdleStatements) closeIdleStatements();
    try {
      if (idleStatements_.emplace(sql, statement).second) return;
    } catch (const std::bad_alloc&) {
      // The statement is finalised below instead of being kept.
    }
  }
  sqlite3_finalize(statement);
}

void Database::closeIdleStatements() const noexcept {
  for (const auto& [sql, statement] : idleStatements_) sqlite3_finalize(statement);
  idleStatements_.clear();
}

std::int64_t Database::lastInsertedId() const noexcept {
  return sqlite3_last_insert_rowid(handle_);
}

void Database::fail(int code, const std::string& action) const {
  const std::string reason = sqlite3_errmsg(handle_);
  const std::string could = "Could not " + action + " " + path_ + ": ";
  // The low byte of the code is the primary result code. Some calls report a full disk as an I/O
  // error.
  const int error = (code & 0xff) == SQLITE_IOERR ? lackOfRoomIn(handle_) : 0;
  switch (error != 0 ? SQLITE_FULL : code & 0xff) {
    case SQLITE_BUSY:
    case SQLITE_LOCKED:
      throw StorageError(message("storage.busy", path()), StorageError::Kind::Busy);
    case SQLITE_FULL:
      throw StorageError(
          error == EDQUOT ? message("storage.quota_used_up", path())
                          : message("storage.disk_full", path()),
          StorageError::Kind::DiskFull);
    case SQLITE_READONLY:
    case SQLITE_CANTOPEN:
    case SQLITE_PERM:
      throw StorageError(message("storage.not_writable", path()), StorageError::Kind::Other);
    case SQLITE_CORRUPT:
    case SQLITE_NOTADB:
      throw StorageError(
          could + "the file is damaged (" + reason +
              "). Restore it from a copy; do not go on with it.",
          StorageError::Kind::Damaged);
    case SQLITE_IOERR:
      throw StorageError(message("storage.disk_error", path(), reason), StorageError::Kind::Other);
    case SQLITE_CONSTRAINT:
      throw StorageError(
          could +
          "what was to be stored contradicts what is there. Nothing was changed. This is a "
          "fault of palpate: please report it, with the number " +
          std::to_string(code) + ".");
    case SQLITE_TOOBIG:
      throw StorageError(could + "a value is too large.");
    default:
      throw StorageError(could + reason + ".");
  }
}

}  // namespace study::storage
