#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "study/model/ids.h"
#include "study/storage/database.h"

struct sqlite3_stmt;

namespace study::storage {

/// A prepared statement. As in SQLite, parameters are numbered from 1 and columns from 0. The
/// database must outlive the statement.
class Statement {
 public:
  /// @throws StorageError  as do all functions of this class.
  Statement(const Database& database, const std::string& sql);
  ~Statement();
  Statement(const Statement&) = delete;
  Statement& operator=(const Statement&) = delete;

  Statement& bind(int index, std::int64_t value);
  Statement& bind(int index, double value);
  Statement& bind(int index, std::string_view value);
  Statement& bind(int index, std::span<const std::byte> value);
  /// Binds three parameters from @p first: session, step, attempt.
  Statement& bind(int first, const VisitKey& visit);
  Statement& bindNull(int index);
  template <typename T>
  Statement& bind(int index, const std::optional<T>& value) {
    return value ? bind(index, *value) : bindNull(index);
  }
  /// Binds the parameters in their order, from the first on; a visit is three.
  template <typename... Values>
  Statement& bindAll(const Values&... values) {
    int index = 1;
    (bindNext(index, values), ...);
    return *this;
  }

  /// Advances to the next row. @return  false at the end
  bool step();
  /// Runs a statement that returns no rows.
  void run();
  void reset();

  bool isNull(int column) const noexcept;
  /// The value of a column in the current row.
  std::int64_t number(int column) const noexcept;
  double real(int column) const noexcept;
  std::string text(int column) const;
  std::vector<std::byte> blob(int column) const;
  std::optional<std::int64_t> optionalNumber(int column) const;
  std::optional<double> optionalReal(int column) const;
  std::optional<std::string> optionalText(int column) const;

  int columnCount() const noexcept;
  /// A value with its type as bytes; different values have different bytes.
  std::string exactBytes(int column) const;

 private:
  template <typename Value>
  void bindNext(int& index, const Value& value) {
    if constexpr (std::is_integral_v<Value> || std::is_enum_v<Value>) {
      bind(index++, static_cast<std::int64_t>(value));
    } else {
      bind(index, value);
      index += std::is_same_v<Value, VisitKey> ? 3 : 1;
    }
  }

  /// @throws StorageError  if @p value is null because SQLite is out of memory.
  void requireMemory(const void* value) const;

  const Database& database_;
  sqlite3_stmt* statement_ = nullptr;
};

/// A transaction: all of its changes are written, or none. It takes the write lock at its
/// beginning, so that it cannot fail later because another program holds the lock.
class Transaction {
 public:
  /// @throws StorageError  (Busy) if another program holds the write lock for too long.
  explicit Transaction(Database& database);
  /// Rolls back unless commit() has succeeded.
  ~Transaction();
  Transaction(const Transaction&) = delete;
  Transaction& operator=(const Transaction&) = delete;

  /// On return all changes are on the disk.
  /// @throws StorageError  and then the outcome is *unknown*: the caller must read the data back
  ///     before reporting anything.
  void commit();

 private:
  Database& database_;
  bool isOpen_ = true;
};

}  // namespace study::storage
