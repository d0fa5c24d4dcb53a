#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>

#include "study/model/storage_error.h"
#include "study/storage/keys/sealing_key.h"

struct sqlite3;
struct sqlite3_stmt;

namespace study::storage {

/// The type of a database file. Its application id is in the header of the file, so that a file of
/// another type is refused.
struct Schema {
  std::int32_t applicationId = 0;
  std::string_view name;                    ///< name in messages: "a palpate study"
  std::span<const std::string_view> steps;  ///< step n converts a file from version n to n + 1
  /// The oldest version with all tables and columns of the newest. A file of this version or a
  /// later one can be read without conversion.
  std::size_t oldestReadable = steps.size();
};

/// An open connection to a SQLite file of the expected type and version. These settings were read
/// back: write-ahead log, synchronous=FULL, foreign keys; with them, a commit that has returned is
/// on the disk. May be used by one thread only.
class Database {
 public:
  enum class Access { ReadWrite, ReadOnly };

  /// Creates a file. @throws StorageError  if the file exists already, cannot be written, or would
  /// be on a network drive.
  static Database create(const std::string& path, const Schema& schema);

  /// Opens an existing file; converts a file of an older format to the present one first. If the
  /// disk is too full for reading, frees the reserved space beside the file.
  /// @throws StorageError  if the file is missing, in use, damaged, of another type, or newer than
  ///     this program.
  static Database open(const std::string& path, const Schema& schema, Access access);

  /// For tests: a database in memory.
  static Database inMemory(const Schema& schema);

  ~Database();
  Database(Database&& other) noexcept;
  Database& operator=(Database&&) = delete;

  /// Runs one or more statements without results. @throws StorageError
  void execute(const std::string& sql);

  /// Marks the open transaction for rollBackIfScheduled(), which rolls it back: in the destructor
  /// of the transaction or, if that fails, before the next transaction begins.
  void scheduleRollback() noexcept { isRollbackScheduled_ = true; }
  void rollBackIfScheduled();

  /// False for tables and columns of later formats, in a file of an older format that was opened
  /// for reading only.
  bool hasTable(const std::string& name) const;
  bool hasColumn(const std::string& table, const std::string& column) const;

  /// The problems that SQLite's integrity check and its check of foreign keys find; empty if none.
  std::string integrityCheckProblems();

  /// Like integrityCheckProblems(), but without checking indexes and references; much faster.
  std::string quickCheckProblems();

  /// Begins a read transaction: until this transaction ends, the connection sees the file in its
  /// present state, even if other connections write.
  void beginSnapshot();

  /// Writes the file in the state that this connection sees to @p path, which must not exist. Other
  /// connections may write meanwhile; after beginSnapshot() the copy has the state of that moment.
  /// @param progress  called with the share that is copied, 0 to 1; an exception that it throws
  ///     ends the copying.
  /// @throws StorageError
  void copyTo(const std::string& path, const std::function<void(double share)>& progress) const;

  /// Sets the study's key, with which conditions and measurements are sealed and unsealed
  /// (docs/decisions/0049). Not called for studies without sealed data.
  void setKey(const SealingKey& key) { key_ = key; }
  /// nullptr if no key was set.
  const SealingKey* key() const noexcept { return key_ ? &*key_ : nullptr; }

  /// For Statement: a compiled statement, which is given back with giveBack(). Compiling takes many
  /// times as long as running a statement on one row, so those that were given back are used again.
  /// @throws StorageError
  sqlite3_stmt* compiled(const std::string& sql) const;
  void giveBack(sqlite3_stmt* statement) const noexcept;

  std::int64_t lastInsertedId() const noexcept;
  const std::string& path() const noexcept { return path_; }
  sqlite3* handle() const noexcept { return handle_; }

  /// Throws a StorageError that describes SQLite's result code @p code. @param action  "read"
  [[noreturn]] void fail(int code, const std::string& action) const;

 private:
  /// SharedLocks: with locks and with memory that is shared with other programs. Immutable: without
  /// locks and log, as SQLite reads an immutable file.
  enum class Reading { SharedLocks, Immutable };

  Database(std::string path, int flags, Reading reading = Reading::SharedLocks);
  /// Opens the file with or without locks; open() has chosen which.
  static Database openWithReading(
      const std::string& path, const Schema& schema, Access access, Reading reading);
  std::string problemsFoundBy(const char* pragma);
  void closeIdleStatements() const noexcept;
  void configure(Access access);
  /// @throws StorageError  if the application id is not that of @p schema.
  void requireApplicationId(const Schema& schema) const;
  /// Applies the missing steps of the schema, or refuses a newer version.
  void migrateSchema(const Schema& schema, Access access);
  /// Sets a pragma and reads it back. @throws StorageError  if it is not @p expected
  void requirePragma(
      const std::string& name, const std::string& value, const std::string& expected);

  std::string path_;
  sqlite3* handle_ = nullptr;
  bool isRollbackScheduled_ = false;
  std::optional<SealingKey> key_;
  /// Compiled statements that nothing uses, by the text that they keep.
  mutable std::unordered_map<std::string_view, sqlite3_stmt*> idleStatements_;
};

}  // namespace study::storage
