#include "study/collect/server/connection.h"

#include <libpq-fe.h>

#include <array>
#include <cstdlib>
#include <cstring>
#include <new>
#include <string_view>
#include <utility>

#include "study/model/user_error.h"

namespace study::collect {
namespace {

using Kind = ServerError::Kind;

constexpr std::uint32_t kTypeBytea = 17;
constexpr const char* kTimeout = "10";  // [s]: of one attempt to connect

/// libpq's messages end with line feeds, and begin with what it tried.
std::string sentence(const char* message) {
  std::string text = message == nullptr ? "" : message;
  while (!text.empty() && (text.back() == '\n' || text.back() == ' ')) text.pop_back();
  for (auto& c : text) c = c == '\n' ? ' ' : c;
  return text;
}

void appendNumber(std::string& bytes, std::uint32_t number) {
  for (int shift = 24; shift >= 0; shift -= 8) {
    bytes += static_cast<char>((number >> shift) & 0xFFU);
  }
}

/// What is wrong, by the SQLSTATE.
Kind kindOf(std::string_view state, bool isConnected) {
  if (!isConnected || state.starts_with("08") || state.starts_with("57P")) return Kind::Unreachable;
  if (state.starts_with("28")) return Kind::NotLetIn;
  if (state == "42501") return Kind::Denied;
  if (state == "53100") return Kind::Full;
  return Kind::Other;
}

std::string wordsFor(Kind kind, const std::string& where, const std::string& said) {
  switch (kind) {
    case Kind::Unreachable:
      return "The server (" + where + ") cannot be reached: " + said +
             ". Nothing is lost: everything stays on this computer. Try again when the network "
             "works.";
    case Kind::NotLetIn:
      return "The server (" + where + ") does not let this computer in: " + said +
             ". Show this to whoever runs the server: role, certificate and pg_hba.conf belong "
             "together.";
    case Kind::Denied:
      return "The server (" + where + ") refuses that to this role: " + said + ".";
    case Kind::Full:
      return "The disk of the server (" + where +
             ") is full. Nothing is lost: everything stays on this computer. Tell whoever runs the "
             "server.";
    case Kind::Other:
      break;
  }
  return "The server (" + where + ") says: " + said + ".";
}

/// Whether @p said is about the role, its password or its certificate.
bool isAboutLettingIn(std::string_view said) {
  constexpr std::array<std::string_view, 6> kSigns{
      "authentication",
      "no pg_hba.conf entry",
      "certificate",
      "password",
      "role \"",
      "no password"};
  for (const auto sign : kSigns) {
    if (said.find(sign) != std::string_view::npos) return true;
  }
  return false;
}

/// @throws UserError
void requireReadable(const std::string& server) {
  char* problem = nullptr;
  auto* options = PQconninfoParse(server.c_str(), &problem);
  const std::string why = sentence(problem);
  PQfreemem(problem);
  if (options == nullptr) {
    throw UserError(
        "'" + server + "' does not say where the server is: " + why +
        ". Write \"service=NAME\" or \"host=… dbname=… user=…\".");
  }
  bool hasPassword = false;
  for (const auto* option = options; option->keyword != nullptr; ++option) {
    if (std::strcmp(option->keyword, "password") == 0 && option->val != nullptr) hasPassword = true;
  }
  PQconninfoFree(options);
  if (hasPassword) {
    throw UserError(
        "A password does not belong where others can read it. Put it into ~/.pgpass (chmod 600), "
        "and leave it out here.");
  }
}

}  // namespace

Parameter Parameter::bytes(std::span<const std::byte> bytes) {
  Parameter parameter;
  parameter.value_.emplace(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  parameter.isBinary_ = true;
  return parameter;
}

Parameter Parameter::arrayOfBytes(const std::vector<std::vector<std::byte>>& elements) {
  // The binary format of an array: dimensions, flags, type; size and first index; then elements.
  std::string value;
  appendNumber(value, elements.empty() ? 0 : 1);
  appendNumber(value, 0);
  appendNumber(value, kTypeBytea);
  if (!elements.empty()) {
    appendNumber(value, static_cast<std::uint32_t>(elements.size()));
    appendNumber(value, 1);
  }
  for (const auto& element : elements) {
    appendNumber(value, static_cast<std::uint32_t>(element.size()));
    value.append(reinterpret_cast<const char*>(element.data()), element.size());
  }
  Parameter parameter;
  parameter.value_ = std::move(value);
  parameter.isBinary_ = true;
  return parameter;
}

Rows::Rows(pg_result* result) : result_(result) {}

void Rows::Clear::operator()(pg_result* result) const noexcept {
  PQclear(result);
}

int Rows::count() const noexcept {
  return PQntuples(result_.get());
}

bool Rows::isNull(int row, int column) const noexcept {
  return PQgetisnull(result_.get(), row, column) != 0;
}

std::string Rows::text(int row, int column) const {
  const auto size = static_cast<std::size_t>(PQgetlength(result_.get(), row, column));
  return {PQgetvalue(result_.get(), row, column), size};
}

std::optional<std::string> Rows::optionalText(int row, int column) const {
  return isNull(row, column) ? std::nullopt : std::optional(text(row, column));
}

std::int64_t Rows::number(int row, int column) const {
  return std::strtoll(PQgetvalue(result_.get(), row, column), nullptr, 10);
}

std::optional<std::int64_t> Rows::optionalNumber(int row, int column) const {
  return isNull(row, column) ? std::nullopt : std::optional(number(row, column));
}

std::vector<std::byte> Rows::bytes(int row, int column) const {
  std::size_t size = 0;
  const auto* value =
      reinterpret_cast<const unsigned char*>(PQgetvalue(result_.get(), row, column));
  auto* plain = PQunescapeBytea(value, &size);
  if (plain == nullptr) throw std::bad_alloc();
  const auto* first = reinterpret_cast<const std::byte*>(plain);
  std::vector<std::byte> bytes(first, first + size);
  PQfreemem(plain);
  return bytes;
}

void Connection::Finish::operator()(pg_conn* connection) const noexcept {
  PQfinish(connection);
}

Connection::Connection(const std::string& server, const std::string& user) {
  requireReadable(server);
  std::vector<const char*> names{"connect_timeout", "fallback_application_name", "dbname"};
  std::vector<const char*> values{kTimeout, "palpate", server.c_str()};
  if (!user.empty()) {
    names.push_back("user");
    values.push_back(user.c_str());
  }
  names.push_back(nullptr);
  values.push_back(nullptr);
  connection_.reset(PQconnectdbParams(names.data(), values.data(), 1));
  if (connection_ == nullptr) throw std::bad_alloc();
  if (PQstatus(connection_.get()) != CONNECTION_OK) {
    const auto said = sentence(PQerrorMessage(connection_.get()));
    const auto kind = isAboutLettingIn(said) ? Kind::NotLetIn : Kind::Unreachable;
    throw ServerError(kind, wordsFor(kind, description(), said));
  }
  PQsetNoticeProcessor(
      connection_.get(), [](void*, const char*) {}, nullptr);
}

void Connection::execute(const std::string& statements) {
  checked(PQexec(connection_.get(), statements.c_str()));
}

Rows Connection::query(const std::string& statement, const std::vector<Parameter>& parameters) {
  std::vector<const char*> values;
  std::vector<int> sizes;
  std::vector<int> formats;
  for (const auto& parameter : parameters) {
    const auto& value = parameter.value();
    values.push_back(value ? value->data() : nullptr);
    sizes.push_back(value ? static_cast<int>(value->size()) : 0);
    formats.push_back(parameter.isBinary() ? 1 : 0);
  }
  return checked(PQexecParams(
      connection_.get(),
      statement.c_str(),
      static_cast<int>(parameters.size()),
      nullptr,
      values.data(),
      sizes.data(),
      formats.data(),
      0));
}

Rows Connection::checked(pg_result* result) {
  Rows rows(result);
  const auto status = PQresultStatus(result);
  if (status == PGRES_COMMAND_OK || status == PGRES_TUPLES_OK) return rows;
  const char* state = result == nullptr ? nullptr : PQresultErrorField(result, PG_DIAG_SQLSTATE);
  const char* message =
      result == nullptr ? nullptr : PQresultErrorField(result, PG_DIAG_MESSAGE_PRIMARY);
  const bool isConnected = PQstatus(connection_.get()) == CONNECTION_OK;
  const auto kind = kindOf(state == nullptr ? "" : state, isConnected);
  const auto said = sentence(message == nullptr ? PQerrorMessage(connection_.get()) : message);
  throw ServerError(kind, wordsFor(kind, description(), said));
}

std::string Connection::quotedName(const std::string& name) const {
  char* quoted = PQescapeIdentifier(connection_.get(), name.data(), name.size());
  if (quoted == nullptr) throw UserError("'" + name + "' cannot be a name on the server.");
  std::string result = quoted;
  PQfreemem(quoted);
  return result;
}

std::string Connection::quotedText(const std::string& text) const {
  char* quoted = PQescapeLiteral(connection_.get(), text.data(), text.size());
  if (quoted == nullptr) throw UserError("'" + text + "' is no sound text.");
  std::string result = quoted;
  PQfreemem(quoted);
  return result;
}

std::string Connection::address() const {
  auto* connection = connection_.get();
  return std::string("host=") + PQhost(connection) + " port=" + PQport(connection) +
         " dbname=" + PQdb(connection);
}

std::string Connection::description() const {
  const auto part = [](const char* value) { return std::string(value == nullptr ? "" : value); };
  return part(PQuser(connection_.get())) + "@" + part(PQdb(connection_.get())) + " on " +
         part(PQhost(connection_.get()));
}

}  // namespace study::collect
