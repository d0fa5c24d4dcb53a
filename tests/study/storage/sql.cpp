#include "tests/study/storage/sql.h"

#include <stdexcept>

#include <sqlite3.h>

namespace tests {

Sql::Sql(const std::string& file) {
  if (sqlite3_open_v2(
          file.c_str(), &handle_, SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE, nullptr) !=
      SQLITE_OK) {
    throw std::runtime_error("cannot open " + file);
  }
}

Sql::~Sql() {
  sqlite3_close(handle_);
}

void Sql::run(const std::string& statements) {
  if (sqlite3_exec(handle_, statements.c_str(), nullptr, nullptr, nullptr) != SQLITE_OK) {
    throw std::runtime_error(sqlite3_errmsg(handle_));
  }
}

std::string Sql::text(const std::string& query) {
  sqlite3_stmt* statement = nullptr;
  if (sqlite3_prepare_v2(handle_, query.c_str(), -1, &statement, nullptr) != SQLITE_OK) {
    throw std::runtime_error(sqlite3_errmsg(handle_));
  }
  std::string value;
  if (sqlite3_step(statement) == SQLITE_ROW && sqlite3_column_text(statement, 0) != nullptr) {
    value = reinterpret_cast<const char*>(sqlite3_column_text(statement, 0));
  }
  sqlite3_finalize(statement);
  return value;
}

std::int64_t Sql::number(const std::string& query) {
  const std::string value = text(query);
  return value.empty() ? 0 : std::stoll(value);
}

bool Sql::refuses(const std::string& statement) {
  return sqlite3_exec(handle_, statement.c_str(), nullptr, nullptr, nullptr) != SQLITE_OK;
}

}  // namespace tests
