#pragma once

#include <cstdint>
#include <string>

struct sqlite3;

namespace tests {

/// A connection of somebody else: no schema is asked for, nothing is set, whatever SQLite lets
/// happen happens. For looking behind the program's back, and for mischief.
class Sql {
 public:
  explicit Sql(const std::string& file);
  ~Sql();
  Sql(const Sql&) = delete;
  Sql& operator=(const Sql&) = delete;

  /// @throws std::runtime_error  with SQLite's own words.
  void run(const std::string& statements);
  /// The first value of the first row; empty where there is none.
  std::string text(const std::string& query);
  std::int64_t number(const std::string& query);
  /// Whether SQLite refuses @p statement.
  bool refuses(const std::string& statement);

 private:
  sqlite3* handle_ = nullptr;
};

}  // namespace tests
