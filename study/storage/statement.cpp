#include "study/storage/statement.h"

#include <cstring>

#include <sqlite3.h>

namespace study::storage {

Statement::Statement(const Database& database, const std::string& sql)
    : database_(database), statement_(database.compiled(sql)) {}

Statement::~Statement() {
  database_.giveBack(statement_);
}

Statement& Statement::bind(int index, std::int64_t value) {
  const int code = sqlite3_bind_int64(statement_, index, value);
  if (code != SQLITE_OK) database_.fail(code, "write to");
  return *this;
}

Statement& Statement::bind(int index, double value) {
  const int code = sqlite3_bind_double(statement_, index, value);
  if (code != SQLITE_OK) database_.fail(code, "write to");
  return *this;
}

Statement& Statement::bind(int index, std::string_view value) {
  const int code = sqlite3_bind_text64(
      statement_,
      index,
      value.data() != nullptr ? value.data() : "",
      value.size(),
      SQLITE_TRANSIENT,
      SQLITE_UTF8);
  if (code != SQLITE_OK) database_.fail(code, "write to");
  return *this;
}

Statement& Statement::bind(int index, std::span<const std::byte> value) {
  const int code =
      sqlite3_bind_blob64(statement_, index, value.data(), value.size(), SQLITE_TRANSIENT);
  if (code != SQLITE_OK) database_.fail(code, "write to");
  return *this;
}

Statement& Statement::bind(int first, const VisitKey& visit) {
  return bind(first, static_cast<std::int64_t>(visit.session))
      .bind(first + 1, std::int64_t{visit.step})
      .bind(first + 2, std::int64_t{visit.attempt});
}

Statement& Statement::bindNull(int index) {
  const int code = sqlite3_bind_null(statement_, index);
  if (code != SQLITE_OK) database_.fail(code, "write to");
  return *this;
}

bool Statement::step() {
  const int code = sqlite3_step(statement_);
  if (code == SQLITE_ROW) return true;
  if (code == SQLITE_DONE) return false;
  sqlite3_reset(statement_);
  database_.fail(code, "use");
}

void Statement::run() {
  while (step()) {
  }
  reset();
}

void Statement::reset() {
  sqlite3_reset(statement_);
  sqlite3_clear_bindings(statement_);
}

bool Statement::isNull(int column) const noexcept {
  return sqlite3_column_type(statement_, column) == SQLITE_NULL;
}

std::int64_t Statement::number(int column) const noexcept {
  return sqlite3_column_int64(statement_, column);
}

double Statement::real(int column) const noexcept {
  return sqlite3_column_double(statement_, column);
}

/// SQLite returns a null pointer for an empty value, and also when it is out of memory.
/// @throws StorageError  in the second case
void Statement::requireMemory(const void* value) const {
  if (value == nullptr && sqlite3_errcode(database_.handle()) == SQLITE_NOMEM) {
    database_.fail(SQLITE_NOMEM, "read");
  }
}

std::string Statement::text(int column) const {
  const auto* text = sqlite3_column_text(statement_, column);
  requireMemory(text);
  const auto size = static_cast<std::size_t>(sqlite3_column_bytes(statement_, column));
  return text == nullptr ? std::string() : std::string(reinterpret_cast<const char*>(text), size);
}

std::vector<std::byte> Statement::blob(int column) const {
  const auto* data = static_cast<const std::byte*>(sqlite3_column_blob(statement_, column));
  requireMemory(data);
  const auto size = static_cast<std::size_t>(sqlite3_column_bytes(statement_, column));
  return data == nullptr ? std::vector<std::byte>() : std::vector<std::byte>(data, data + size);
}

std::optional<std::int64_t> Statement::optionalNumber(int column) const {
  return isNull(column) ? std::nullopt : std::optional(number(column));
}

std::optional<double> Statement::optionalReal(int column) const {
  return isNull(column) ? std::nullopt : std::optional(real(column));
}

std::optional<std::string> Statement::optionalText(int column) const {
  return isNull(column) ? std::nullopt : std::optional(text(column));
}

int Statement::columnCount() const noexcept {
  return sqlite3_column_count(statement_);
}

std::string Statement::exactBytes(int column) const {
  switch (sqlite3_column_type(statement_, column)) {
    case SQLITE_INTEGER:
      return "i" + std::to_string(number(column));
    case SQLITE_FLOAT: {
      const double value = real(column);
      std::string bytes(1 + sizeof value, 'r');
      std::memcpy(bytes.data() + 1, &value, sizeof value);
      return bytes;
    }
    case SQLITE_NULL:
      return "n";
    case SQLITE_BLOB: {
      const auto bytes = blob(column);
      return "b" + std::string(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    }
    default:
      return "t" + text(column);
  }
}

Transaction::Transaction(Database& database) : database_(database) {
  database_.rollBackIfScheduled();
  database_.execute("BEGIN IMMEDIATE");
}

Transaction::~Transaction() {
  if (!isOpen_) return;
  try {
    database_.scheduleRollback();
    database_.rollBackIfScheduled();
  } catch (const StorageError&) {
    // The transaction is still marked: it is rolled back before the next one begins.
  }
}

void Transaction::commit() {
  // If COMMIT throws, the transaction is still open, and the destructor rolls it back unless SQLite
  // has ended it already (see Database::rollBackIfScheduled()).
  database_.execute("COMMIT");
  isOpen_ = false;
}

}  // namespace study::storage
