#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "study/model/ids.h"
#include "study/storage/database.h"
#include "study/storage/statement.h"

// Rows by the names of their columns, as they travel to other files (docs/decisions/0054).
namespace study::storage {

/// A value of a column.
using FactValue = std::variant<std::monostate, std::int64_t, double, std::string>;

/// A row, by the names of its columns.
using FactRow = std::map<std::string, FactValue>;

/// @param columns  "step, attempt"
std::vector<std::string> namesIn(std::string_view columns);

/// @param sql  selects @p columns; its only parameter is the session
std::vector<FactRow> rowsOf(
    const Database& database, const std::string& sql, std::string_view columns, SessionId session);

void bind(Statement& statement, int index, const FactValue& value);

/// @throws StorageError  if the row has not these columns and no others.
void requireColumns(std::string_view table, std::string_view columns, const FactRow& row);

/// Inserts rows that have these columns. @param keys  more columns, the same for all rows
/// @throws StorageError  also as requireColumns()
void insertRows(
    Database& database,
    std::string_view table,
    std::string_view columns,
    const std::vector<FactRow>& rows,
    const std::vector<std::pair<std::string, std::int64_t>>& keys);

/// Throws a StorageError: rows that came from elsewhere are not as this program knows them.
[[noreturn]] void refuseFacts(const std::string& what);

}  // namespace study::storage
