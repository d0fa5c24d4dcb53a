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

/// The server cannot be reached, or does not do what was asked. what() tells the person at the desk
/// what to do.
class ServerError : public std::runtime_error {
 public:
  enum class Kind {
    Unreachable,  ///< no network, no server, or it was stopped in between: try again later
    NotLetIn,     ///< it does not know this role, password or certificate
    Denied,       ///< this role may not do that
    Full,         ///< its disk
    Release,      ///< its schema is older or newer than this program
    Other,
  };

  ServerError(Kind kind, const std::string& what) : std::runtime_error(what), kind_(kind) {}

  Kind kind() const noexcept { return kind_; }

 private:
  Kind kind_;
};

/// "unreachable", "not_let_in", "denied", "full", "release", "other": as a station notes it.
std::string_view nameOf(ServerError::Kind kind) noexcept;

/// A parameter of a statement. Bytes travel as they are, everything else as text.
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

/// The rows that a statement gave.
class Rows {
 public:
  explicit Rows(pg_result* result);

  int count() const noexcept;
  bool isEmpty() const noexcept { return count() == 0; }
  bool isNull(int row, int column) const noexcept;
  std::string text(int row, int column) const;
  std::optional<std::string> optionalText(int row, int column) const;
  std::int64_t number(int row, int column) const;
  std::optional<std::int64_t> optionalNumber(int row, int column) const;
  /// A column of the type bytea.
  std::vector<std::byte> bytes(int row, int column) const;

 private:
  struct Clear {
    void operator()(pg_result* result) const noexcept;
  };
  std::unique_ptr<pg_result, Clear> result_;
};

/// A connection to PostgreSQL. Belongs to one thread.
///
/// Where the server is, is said as libpq reads it: "service=study" (a section of
/// ~/.pg_service.conf), "host=… dbname=… user=…" or a postgresql:// address. A password is no part
/// of it: libpq finds it in ~/.pgpass. docs/collecting.md explains both.
class Connection {
 public:
  /// @throws UserError  if @p server cannot be read, or holds a password.
  /// @throws ServerError  if the server cannot be reached, or does not let this role in.
  explicit Connection(const std::string& server, const std::string& user = {});

  /// How long the server may be silent while it takes, computes or sends something, before it is
  /// given up as unreachable (10 minutes at first). A network that is gone is noticed within a
  /// minute in any case; this is for a server that stands still. Afterwards nothing more can be
  /// asked.
  void setPatience(std::chrono::milliseconds patience) noexcept { patience_ = patience; }

  /// One or more statements without parameters and rows. @throws ServerError
  void execute(const std::string& statements);

  /// One statement with parameters $1, $2, … @throws ServerError
  Rows query(const std::string& statement, const std::vector<Parameter>& parameters = {});

  /// @p name as SQL wants it, in quotation marks if need be.
  std::string quotedName(const std::string& name) const;
  /// @p text as a literal.
  std::string quotedText(const std::string& text) const;

  /// Host, port and database, as another computer would name them: without a role.
  std::string address() const;

  /// "postgres@study on /run/postgresql", for messages.
  std::string description() const;
  /// The account on the server.
  std::string user() const;

 private:
  struct Finish {
    void operator()(pg_conn* connection) const noexcept;
  };
  void connectAgain();
  bool isBusy();
  Rows answer(bool wasSent);
  Rows checked(pg_result* result);

  std::unique_ptr<pg_conn, Finish> connection_;
  std::chrono::milliseconds patience_ = std::chrono::minutes(10);
};

/// @throws UserError  if @p server cannot be read as libpq does, or holds a password: that belongs
///     where no other account can read it.
void requireAddress(const std::string& server);

/// That @p server's account needs @p role, and how it is given.
ServerError lacksRole(const Connection& server, std::string_view role);

/// Performs @p action, which needs @p role.
/// @throws ServerError  by lacksRole(), if the server denies it.
template <typename Action>
auto withRole(const Connection& server, std::string_view role, Action action) {
  try {
    return action();
  } catch (const ServerError& error) {
    if (error.kind() != ServerError::Kind::Denied) throw;
    throw lacksRole(server, role);
  }
}

}  // namespace study::collect
