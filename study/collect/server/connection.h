#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

struct pg_conn;
struct pg_result;

namespace study::collect {

/// The server cannot be reached, or refused a request. what() tells the operator what to do.
class ServerError : public std::runtime_error {
 public:
  enum class Kind {
    Unreachable,   ///< no network, no server, or the server was stopped meanwhile: try again later
    LoginRefused,  ///< the server rejects this role, password or certificate
    Denied,        ///< this role may not do that
    Full,          ///< the server's disk is full
    Release,       ///< the server's schema is older or newer than this program
    Other,
  };

  ServerError(Kind kind, const std::string& what) : std::runtime_error(what), kind_(kind) {}

  Kind kind() const noexcept { return kind_; }

 private:
  Kind kind_;
};

/// "unreachable", "not_let_in", "denied", "full", "release", "other": the name that a station
/// notes.
std::string_view nameOf(ServerError::Kind kind) noexcept;

/// A parameter of a statement. Bytes are sent in binary format, all others as text.
class Parameter {
 public:
  Parameter(std::string text) : value_(std::move(text)) {}  // NOLINT(google-explicit-constructor)
  Parameter(const char* text) : value_(text) {}             // NOLINT(google-explicit-constructor)
  Parameter(std::int64_t number)                            // NOLINT(google-explicit-constructor)
      : value_(std::to_string(number)) {}
  static Parameter null() { return Parameter(); }
  static Parameter bytes(std::span<const std::byte> bytes);
  /// An array of byte strings (bytea[]).
  static Parameter arrayOfBytes(const std::vector<std::vector<std::byte>>& elements);

  const std::optional<std::string>& value() const noexcept { return value_; }
  bool isBinary() const noexcept { return isBinary_; }

 private:
  Parameter() = default;

  std::optional<std::string> value_;
  bool isBinary_ = false;
};

/// The result rows of a statement.
class Rows {
 public:
  explicit Rows(pg_result* result);

  int count() const noexcept;
  bool isEmpty() const noexcept { return count() == 0; }
  bool isNull(int row, int column) const noexcept;
  std::string text(int row, int column) const;
  std::int64_t number(int row, int column) const;
  std::optional<std::int64_t> optionalNumber(int row, int column) const;
  /// A column of the type bytea.
  std::vector<std::byte> bytes(int row, int column) const;

 private:
  struct ResultDeleter {
    void operator()(pg_result* result) const noexcept;
  };
  std::unique_ptr<pg_result, ResultDeleter> result_;
};

/// A connection to PostgreSQL. Belongs to one thread.
///
/// The server is given as a connection string of libpq: "service=study" (a section of
/// ~/.pg_service.conf), "host=… dbname=… user=…" or a postgresql:// address. It must not contain a
/// password: libpq finds that in ~/.pgpass. docs/collecting.md explains both.
class Connection {
 public:
  /// @throws UserError  if @p server is malformed, or contains a password.
  /// @throws ServerError  if the server cannot be reached, or does not let this role in.
  explicit Connection(const std::string& server, const std::string& user = {});

  /// Sets how long the server may be silent during a statement before that fails as Unreachable
  /// (default: 10 minutes). This is for a server that hangs; a lost network is noticed within a
  /// minute in any case. After such a failure the connection cannot be used any more.
  void setResponseTimeout(std::chrono::milliseconds timeout) noexcept {
    responseTimeout_ = timeout;
  }

  /// One or more statements without parameters and rows. @throws ServerError
  void execute(const std::string& statements);

  /// One statement with parameters $1, $2, … @throws ServerError
  Rows query(const std::string& statement, const std::vector<Parameter>& parameters = {});

  /// @p name as an SQL identifier, quoted.
  std::string quotedName(const std::string& name) const;
  /// @p text as an SQL string literal.
  std::string quotedText(const std::string& text) const;

  /// Connection string for another computer: host, port and database, without a role.
  std::string address() const;

  /// "postgres@study on /run/postgresql", for messages.
  std::string description() const;
  /// The account on the server.
  std::string user() const;

 private:
  struct ConnectionDeleter {
    void operator()(pg_conn* connection) const noexcept;
  };
  void connectAgain();
  bool isBusy();
  Rows receiveResult(bool wasSent);
  Rows checked(pg_result* result);

  std::unique_ptr<pg_conn, ConnectionDeleter> connection_;
  std::chrono::milliseconds responseTimeout_ = std::chrono::minutes(10);
};

/// Checks a connection string. @throws UserError  if @p server is malformed, or contains a
/// password, which belongs in ~/.pgpass.
void requireAddress(const std::string& server);

/// The error that the account on @p server lacks @p role, with how to grant it.
ServerError missingRoleError(const Connection& server, std::string_view role);

/// Performs @p action, which needs @p role.
/// @throws ServerError  by missingRoleError(), if the server denies it.
template <typename Action>
auto withRole(const Connection& server, std::string_view role, Action action) {
  try {
    return action();
  } catch (const ServerError& error) {
    if (error.kind() != ServerError::Kind::Denied) throw;
    throw missingRoleError(server, role);
  }
}

}  // namespace study::collect
