#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "base/message.h"
#include "study/model/ids.h"
#include "study/storage/database.h"
#include "study/storage/statement.h"

// Rows by the names of their columns, for copying to other files (docs/decisions/0054).
namespace study::storage {

/// A value of any SQLite type but BLOB.
using NamedRowValue = std::variant<std::monostate, std::int64_t, double, std::string>;

/// The values of a row, by column name.
using NamedRow = std::map<std::string, NamedRowValue>;

/// The column names in a list. @param columns  "step, attempt"
std::vector<std::string> namesIn(std::string_view columns);

/// The values of the present row of a statement, from column @p first on.
NamedRow rowIn(const Statement& row, const std::vector<std::string>& names, int first);

/// The values of these columns; missing values are left out.
base::NamedArguments presentValues(const NamedRow& row, const std::vector<std::string>& names);

/// @param sql  selects @p columns; its only parameter is the number of the session
std::vector<NamedRow> rowsOf(
    const Database& database, const std::string& sql, std::string_view columns, SessionId session);

void bind(Statement& statement, int index, const NamedRowValue& value);

/// @throws StorageError  if the columns of @p row are not exactly @p columns.
void requireColumns(std::string_view table, std::string_view columns, const NamedRow& row);

/// Inserts rows. @param keys  further columns with the same value in all rows
/// @throws StorageError  as requireColumns(), or if the database refuses a row
void insertRows(
    Database& database,
    std::string_view table,
    std::string_view columns,
    const std::vector<NamedRow>& rows,
    const std::vector<std::pair<std::string, std::int64_t>>& keys);

/// Throws a StorageError: rows from another file are not in the form that this program knows.
[[noreturn]] void refuseRows(const std::string& what);

}  // namespace study::storage
