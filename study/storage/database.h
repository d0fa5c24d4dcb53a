#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>

#include "study/model/storage_error.h"

struct sqlite3;

namespace study::storage {

/// What a database file is for: written into its head, so that one is not taken for another.
struct Schema {
  std::int32_t applicationId = 0;
  std::string_view name;                    ///< for people: "a palpate study"
  std::span<const std::string_view> steps;  ///< step n takes a file from version n to n + 1
  /// The oldest version with all of today's tables and columns: such a file is read as it is.
  std::size_t oldestReadable = steps.size();
};

/// A connection to a SQLite file. An object that exists is open, is of the right kind and version,
/// and has been asked whether it really keeps what it acknowledges: write-ahead log,
/// synchronous=FULL, foreign keys, all read back. Belongs to one thread.
class Database {
 public:
  enum class Access { ReadWrite, ReadOnly };

  /// A new file. @throws StorageError  if there is one already, or it cannot be written.
  static Database create(const std::string& path, const Schema& schema);

  /// A file that is there; older ones are taken to the present version first.
  /// @throws StorageError  if it is missing, in use, damaged, foreign, or newer than this program.
  static Database open(const std::string& path, const Schema& schema, Access access);

  /// For tests: the same schema, kept nowhere.
  static Database inMemory(const Schema& schema);

  ~Database();
  Database(Database&& other) noexcept;
  Database& operator=(Database&&) = delete;

  /// One or more statements without results. @throws StorageError
  void execute(const std::string& sql);

  /// What a transaction began and did not commit is to be undone: now if it can be, before the next
  /// one begins if it cannot.
  void owesRollback() noexcept { owesRollback_ = true; }
  void undoWhatIsLeft();

  /// What is wrong with the file, by SQLite's own integrity check and the foreign keys; empty if
  /// nothing.
  std::string integrityProblems();

  /// The same, without looking at indices and references: a fraction of the time.
  std::string quickProblems();

  /// Keeps seeing the file as it is now, whatever others write, until this object goes.
  void holdStill();

  /// Writes the file, as this connection sees it, to @p path, where none is. Others may go on
  /// writing; a connection that holds still copies what it holds.
  /// @param progress  told the share that is done, 0 to 1; whatever it throws ends the copying.
  /// @throws StorageError
  void copyTo(const std::string& path, const std::function<void(double share)>& progress) const;

  std::int64_t lastInsertedId() const noexcept;
  const std::string& path() const noexcept { return path_; }
  sqlite3* handle() const noexcept { return handle_; }

  /// What @p code of SQLite means for the person at the desk.
  [[noreturn]] void fail(int code, const std::string& action) const;

 private:
  Database(std::string path, int flags);
  void configure(Access access);
  void requireKind(const Schema& schema) const;
  void bringUpToDate(const Schema& schema, Access access);
  void requirePragma(
      const std::string& name, const std::string& value, const std::string& expected);

  std::string path_;
  sqlite3* handle_ = nullptr;
  bool owesRollback_ = false;
};

}  // namespace study::storage
