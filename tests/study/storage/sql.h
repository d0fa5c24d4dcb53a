#pragma once

#include <cstdint>
#include <string>

struct sqlite3;

namespace tests {

/// A plain SQLite connection without our schema and settings. Tests use it to look at files and to
/// damage them.
class Sql {
 public:
  explicit Sql(const std::string& file);
  ~Sql();
  Sql(const Sql&) = delete;
  Sql& operator=(const Sql&) = delete;

  /// @throws std::runtime_error  with SQLite's message.
  void run(const std::string& statements);
  /// The first value of the first row; empty if there is none.
  std::string text(const std::string& query);
  std::int64_t number(const std::string& query);
  /// Whether SQLite refuses @p statement.
  bool refuses(const std::string& statement);

 private:
  sqlite3* handle_ = nullptr;
};

}  // namespace tests
