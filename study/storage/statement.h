#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "study/model/ids.h"
#include "study/storage/database.h"

struct sqlite3_stmt;

namespace study::storage {

/// A prepared statement. As in SQLite, parameters are numbered from 1 and columns from 0. The
/// database must outlive it.
class Statement {
 public:
  /// @throws StorageError  like all functions here.
  Statement(const Database& database, const std::string& sql);
  ~Statement();
  Statement(const Statement&) = delete;
  Statement& operator=(const Statement&) = delete;

  Statement& bind(int index, std::int64_t value);
  Statement& bind(int index, double value);
  Statement& bind(int index, std::string_view value);
  Statement& bind(int index, std::span<const std::byte> value);
  /// Three parameters: session, step, attempt.
  Statement& bind(int first, const VisitKey& visit);
  Statement& bindNull(int index);
  template <typename T>
  Statement& bind(int index, const std::optional<T>& value) {
    return value ? bind(index, *value) : bindNull(index);
  }

  /// True if there is another row, false at the end.
  bool step();
  /// Runs a statement without results.
  void run();
  void reset();

  bool isNull(int column) const noexcept;
  std::int64_t number(int column) const noexcept;
  double real(int column) const noexcept;
  std::string text(int column) const;
  std::vector<std::byte> blob(int column) const;
  std::optional<std::int64_t> optionalNumber(int column) const;
  std::optional<double> optionalReal(int column) const;
  std::optional<std::string> optionalText(int column) const;

  int columnCount() const noexcept;
  /// A value with its type, bit by bit: different values always give different bytes.
  std::string exactBytes(int column) const;

 private:
  void requireMemory(const void* value) const;

  const Database& database_;
  sqlite3_stmt* statement_ = nullptr;
};

/// A transaction: all of its changes are written, or none. It takes the write lock at once, so that
/// it cannot fail halfway because another program holds it.
class Transaction {
 public:
  /// @throws StorageError  (Busy) if another program holds the write lock for too long.
  explicit Transaction(Database& database);
  /// Rolls back what was not committed.
  ~Transaction();
  Transaction(const Transaction&) = delete;
  Transaction& operator=(const Transaction&) = delete;

  /// On return everything is on the disk.
  /// @throws StorageError  and then the outcome is *unknown*: the caller reads the data back before
  ///     reporting anything.
  void commit();

 private:
  Database& database_;
  bool isOpen_ = true;
};

}  // namespace study::storage
