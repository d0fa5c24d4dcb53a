#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>

#include "study/model/storage_error.h"
#include "study/storage/keys/sealing_key.h"

struct sqlite3;

namespace study::storage {

/// The kind of a database file. It is written into the file's header, so that one kind is not taken
/// for another.
struct Schema {
  std::int32_t applicationId = 0;
  std::string_view name;                    ///< for people: "a palpate study"
  std::span<const std::string_view> steps;  ///< step n takes a file from version n to n + 1
  /// The oldest version with all tables and columns of the newest: such a file can be read without
  /// a conversion.
  std::size_t oldestReadable = steps.size();
};

/// A connection to a SQLite file. An object that exists is open and has the right kind and version.
/// Its settings have been read back: write-ahead log, synchronous=FULL, foreign keys; with them a
/// commit that returned is on the disk. Belongs to one thread.
class Database {
 public:
  enum class Access { ReadWrite, ReadOnly };

  /// Creates a file. @throws StorageError  if it exists already, it cannot be written, or it would
  ///     lie on a network drive.
  static Database create(const std::string& path, const Schema& schema);

  /// Opens an existing file; older formats are first converted to the present one.
  /// A full disk can be read: where a reader finds no space, the reserved space beside the file is
  /// released.
  /// @throws StorageError  if it is missing, in use, damaged, of another kind, or newer than this
  ///     program.
  static Database open(const std::string& path, const Schema& schema, Access access);

  /// For tests: the same schema in memory only.
  static Database inMemory(const Schema& schema);

  ~Database();
  Database(Database&& other) noexcept;
  Database& operator=(Database&&) = delete;

  /// Runs one or more statements without results. @throws StorageError
  void execute(const std::string& sql);

  /// Marks the open transaction to be rolled back by rollBackIfScheduled(): by the destructor of
  /// the transaction or, if that fails, before the next one begins.
  void scheduleRollback() noexcept { isRollbackScheduled_ = true; }
  void rollBackIfScheduled();

  /// False in a file of an older format that was opened for reading only.
  bool hasTable(const std::string& name) const;
  bool hasColumn(const std::string& table, const std::string& column) const;

  /// The problems that SQLite's integrity check and the foreign keys find; empty if none.
  std::string integrityProblems();

  /// Like integrityProblems() without checking indices and references, in a fraction of the time.
  std::string quickProblems();

  /// Begins a read transaction: this connection sees the file as it is now, whatever others write,
  /// until it is closed.
  void beginSnapshot();

  /// Writes the file, as this connection sees it, to @p path, which must not exist. Others may
  /// write meanwhile; after beginSnapshot() the copy has the state of that moment.
  /// @param progress  called with the share that is done, 0 to 1; an exception that it throws ends
  ///     the copying.
  /// @throws StorageError
  void copyTo(const std::string& path, const std::function<void(double share)>& progress) const;

  /// Gives this connection the key of the study, with which conditions and measurements are
  /// sealed and opened (docs/decisions/0049). Studies in which nothing is sealed have none.
  void setKey(const SealingKey& key) { key_ = key; }
  /// nullptr if this connection has no key.
  const SealingKey* key() const noexcept { return key_ ? &*key_ : nullptr; }

  std::int64_t lastInsertedId() const noexcept;
  const std::string& path() const noexcept { return path_; }
  sqlite3* handle() const noexcept { return handle_; }

  /// Throws a StorageError that explains @p code of SQLite.
  [[noreturn]] void fail(int code, const std::string& action) const;

 private:
  /// WithOthers: with locks and memory shared with other programs. Immutable: as an immutable file,
  /// without locks and log.
  enum class Reading { WithOthers, Immutable };

  Database(std::string path, int flags, Reading reading = Reading::WithOthers);
  static Database openNow(
      const std::string& path, const Schema& schema, Access access, Reading reading);
  void configure(Access access);
  void requireKind(const Schema& schema) const;
  void bringUpToDate(const Schema& schema, Access access);
  void requirePragma(
      const std::string& name, const std::string& value, const std::string& expected);

  std::string path_;
  sqlite3* handle_ = nullptr;
  bool isRollbackScheduled_ = false;
  std::optional<SealingKey> key_;
};

}  // namespace study::storage
