#include "study/storage/named_rows.h"

#include <map>
#include <type_traits>

namespace study::storage {
namespace {

NamedRowValue valueIn(const Statement& row, int column) {
  // The first byte is the type (Statement::exactBytes).
  switch (row.exactBytes(column).front()) {
    case 'i':
      return row.number(column);
    case 'r':
      return row.real(column);
    case 't':
      return row.text(column);
    default:
      return std::monostate();
  }
}

}  // namespace

std::vector<std::string> namesIn(std::string_view columns) {
  std::vector<std::string> names(1);
  for (const char c : columns) {
    if (c == ',') {
      names.emplace_back();
    } else if (c != ' ') {
      names.back() += c;
    }
  }
  return names;
}

NamedRow rowIn(const Statement& row, const std::vector<std::string>& names, int first) {
  NamedRow values;
  for (const auto& name : names) values[name] = valueIn(row, first++);
  return values;
}

base::NamedArguments presentValues(const NamedRow& row, const std::vector<std::string>& names) {
  base::NamedArguments values;
  for (const auto& name : names) {
    std::visit(
        [&, &column = name](const auto& held) {
          if constexpr (!std::is_same_v<std::decay_t<decltype(held)>, std::monostate>) {
            values.emplace_back(column, held);
          }
        },
        row.at(name));
  }
  return values;
}

std::vector<NamedRow> rowsOf(
    const Database& database, const std::string& sql, std::string_view columns, SessionId session) {
  Statement select(database, sql);
  select.bindAll(session);
  const auto names = namesIn(columns);
  std::vector<NamedRow> rows;
  while (select.step()) rows.push_back(rowIn(select, names, 0));
  return rows;
}

void bind(Statement& statement, int index, const NamedRowValue& value) {
  if (const auto* number = std::get_if<std::int64_t>(&value)) {
    statement.bind(index, *number);
  } else if (const auto* real = std::get_if<double>(&value)) {
    statement.bind(index, *real);
  } else if (const auto* text = std::get_if<std::string>(&value)) {
    statement.bind(index, std::string_view(*text));
  } else {
    statement.bindNull(index);
  }
}

void requireColumns(std::string_view table, std::string_view columns, const NamedRow& row) {
  const auto names = namesIn(columns);
  if (row.size() != names.size()) {
    refuseRows("a row of " + std::string(table) + " has other columns");
  }
  for (const auto& name : names) {
    if (!row.contains(name)) refuseRows("a row of " + std::string(table) + " has no " + name);
  }
}

void insertRows(
    Database& database,
    std::string_view table,
    std::string_view columns,
    const std::vector<NamedRow>& rows,
    const std::vector<std::pair<std::string, std::int64_t>>& keys) {
  const auto names = namesIn(columns);
  std::string all;
  std::string marks;
  for (const auto& [name, value] : keys) {
    all += name + ", ";
    marks += "?,";
  }
  for (std::size_t i = 0; i < names.size(); ++i) marks += i == 0 ? "?" : ",?";
  Statement statement(
      database,
      "INSERT INTO " + std::string(table) + " (" + all + std::string(columns) + ") VALUES (" +
          marks + ")");
  int index = 1 + static_cast<int>(keys.size());
  std::map<std::string_view, int> parameters;  // in the order of a row's columns
  for (const auto& name : names) parameters[name] = index++;
  for (const auto& row : rows) {
    index = 1;
    for (const auto& [name, value] : keys) statement.bind(index++, value);
    auto parameter = parameters.begin();
    for (const auto& [name, value] : row) {
      if (parameter == parameters.end() || parameter->first != name) break;
      bind(statement, parameter++->second, value);
    }
    if (parameter != parameters.end() || row.size() != parameters.size()) {
      requireColumns(table, columns, row);
    }
    statement.run();
  }
}

void refuseRows(const std::string& what) {
  throw StorageError(
      "A session that was collected cannot be kept: " + what +
          ". It was written by a later release, or it is damaged.",
      StorageError::Kind::Damaged);
}

}  // namespace study::storage
