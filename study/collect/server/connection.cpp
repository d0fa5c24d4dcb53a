#include "study/collect/server/connection.h"

#include <libpq-fe.h>
#include <poll.h>

#include <array>
#include <cstdlib>
#include <new>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "study/model/user_error.h"

namespace study::collect {
namespace {

using Kind = ServerError::Kind;

constexpr std::uint32_t kTypeBytea = 17;
struct Setting {
  const char* name;
  const char* value;
};

/// Defaults, which the connection string may override. A lost network is noticed within 60 s, both
/// while the connection is idle (30 s + 3 · 10 s) and while it sends. With the system's defaults a
/// push would wait for hours.
constexpr std::array kSettings{
    Setting{"connect_timeout", "10"},      // [s]: of one attempt
    Setting{"keepalives_idle", "30"},      // [s]
    Setting{"keepalives_interval", "10"},  // [s]
    Setting{"keepalives_count", "3"},
    Setting{"tcp_user_timeout", "60000"},  // [ms]
    Setting{"fallback_application_name", "palpate"}};

/// A message of libpq without its prefix, which says what libpq tried, and without line feeds at
/// its end.
std::string sentence(const char* message) {
  std::string text = message == nullptr ? "" : message;
  // Our messages add their own full stop.
  while (!text.empty() && std::string_view("\n .?").find(text.back()) != std::string_view::npos) {
    text.pop_back();
  }
  for (auto& c : text) c = c == '\n' || c == '\t' ? ' ' : c;
  // libpq's message goes on to recommend switching off the check of the server's certificate: leave
  // that out.
  if (const auto advice = text.find(" Either provide the file"); advice != std::string::npos)
    text.erase(advice);
  return text;
}

void appendNumber(std::string& bytes, std::uint32_t number) {
  for (int shift = 24; shift >= 0; shift -= 8) {
    bytes += static_cast<char>((number >> shift) & 0xFFU);
  }
}

/// The kind of an error, by its SQLSTATE. Too many connections (53300) is temporary.
Kind kindOf(std::string_view state, bool isConnected) {
  const bool isGone = !isConnected || state.starts_with("08") || state.starts_with("57P");
  if (isGone || state == "53300") return Kind::Unreachable;
  if (state.starts_with("28")) return Kind::LoginRefused;
  if (state == "42501") return Kind::Denied;
  if (state == "53100") return Kind::Full;
  return Kind::Other;
}

/// Messages of libpq and OpenSSL on failed logins, and what to tell the operator. They are always
/// English, while messages of a server are in its own language: of those, the SQLSTATE.
struct LoginProblem {
  std::string_view pattern;
  std::string_view words;
};
constexpr std::array kLoginProblems{
    LoginProblem{
        "certificate revoked",
        "The certificate of this computer was revoked. Ask the study's administrator for a new "
        "one."},
    LoginProblem{
        "alert certificate expired",
        "The certificate of this computer has expired. Ask the study's administrator for a new "
        "one."},
    LoginProblem{
        "unknown ca",
        "The server does not accept the authority that issued this computer's certificate."},
    LoginProblem{
        "alert bad certificate", "The server does not accept this computer's certificate."},
    LoginProblem{
        "certificate verify failed",
        "The certificate of the server was issued by somebody else than root.crt says, or it is "
        "not valid on the day that this computer's clock shows: look at the clock first. It may "
        "also be another server in its place."},
    LoginProblem{
        "does not match host name",
        "The certificate of the server is for another name: it may be another server in its "
        "place."},
    LoginProblem{
        "root certificate file",
        "This computer has not the certificate root.crt of the server: ask the server's "
        "administrator for it."},
    LoginProblem{
        "certificate authentication failed",
        "The certificate of this computer is for another role than that of its station: each "
        "station has its own."},
    LoginProblem{"valid client certificate", "The server wants a certificate of this computer."},
    LoginProblem{"alert certificate required", "The server wants a certificate of this computer."},
    LoginProblem{"private key file", "The key of this computer's certificate cannot be used."},
    LoginProblem{
        "no encryption",
        "The server does not take this role without encryption: whoever enrols the station writes "
        "sslmode=verify-full into --address."},
    LoginProblem{"server does not support SSL", "The server cannot encrypt."},
    LoginProblem{
        "no password supplied", "A password is needed, and ~/.pgpass has none for this server."},
    LoginProblem{
        "28P01",
        "The server has another password for this role, or none: look at the line in ~/.pgpass."},
    LoginProblem{"SSL error", "The encryption does not come about."}};

/// The text for the operator; empty if @p said contains no known message.
std::string_view loginProblemIn(std::string_view said) {
  for (const auto& problem : kLoginProblems) {
    if (said.find(problem.pattern) != std::string_view::npos) return problem.words;
  }
  return {};
}

std::string wordsFor(Kind kind, const std::string& where, const std::string& said) {
  switch (kind) {
    case Kind::Unreachable:
      return "The server (" + where + ") cannot be reached: " + said +
             ". Nothing is lost: everything stays on this computer. Try again when the network "
             "works.";
    case Kind::LoginRefused:
      return fmt::format(
          "The server ({}) does not let this computer in. {}{}Nothing is lost: everything stays on "
          "this computer. Show the server's administrator (role, certificate and pg_hba.conf "
          "belong "
          "together): {}",
          where,
          loginProblemIn(said),
          loginProblemIn(said).empty() ? "" : " ",
          said);
    case Kind::Denied:
      return "The server (" + where +
             ") refuses that to this role. The page on collecting says which role may do what "
             "(\"Roles\"); the server's administrator gives it. It says: " +
             said + ".";
    case Kind::Full:
      return "The disk of the server (" + where +
             ") is full. Nothing is lost: everything stays on this computer. Tell whoever runs the "
             "server.";
    case Kind::Release:
    case Kind::Other:
      break;
  }
  return "The server (" + where + ") says: " + said + ".";
}

/// The SQLSTATE in a message of PQERRORS_SQLSTATE: "… failed: FATAL:  28000". Two spaces follow the
/// word for "fatal" of any language.
std::string sqlStateIn(const std::string& said) {
  constexpr std::size_t kDigits = 5;
  const auto at = said.rfind(":  ");
  return at == std::string::npos ? std::string() : said.substr(at + 3, kDigits);
}

}  // namespace

void requireAddress(const std::string& server) {
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
    const std::string_view name = option->keyword;
    const bool isPassword = name == "password" || name == "sslpassword";
    hasPassword = hasPassword || (isPassword && option->val != nullptr);
  }
  PQconninfoFree(options);
  if (hasPassword) {
    throw UserError(
        "A password does not belong where others can read it. Put it into ~/.pgpass (chmod 600), "
        "and leave it out here. The key "
        "of a certificate has none, and is readable for this account alone (chmod 600).");
  }
}

std::string_view nameOf(ServerError::Kind kind) noexcept {
  switch (kind) {
    case ServerError::Kind::Unreachable:
      return "unreachable";
    case ServerError::Kind::LoginRefused:
      return "not_let_in";
    case ServerError::Kind::Denied:
      return "denied";
    case ServerError::Kind::Full:
      return "full";
    case ServerError::Kind::Release:
      return "release";
    case ServerError::Kind::Other:
      break;
  }
  return "other";
}

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

void Rows::ResultDeleter::operator()(pg_result* result) const noexcept {
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

void Connection::ConnectionDeleter::operator()(pg_conn* connection) const noexcept {
  PQfinish(connection);
}

Connection::Connection(const std::string& server, const std::string& user) {
  requireAddress(server);
  std::vector<const char*> names;
  std::vector<const char*> values;
  for (const auto& setting : kSettings) {
    names.push_back(setting.name);
    values.push_back(setting.value);
  }
  names.push_back("dbname");
  values.push_back(server.c_str());
  if (!user.empty()) {
    names.push_back("user");
    values.push_back(user.c_str());
  }
  names.push_back(nullptr);
  values.push_back(nullptr);
  connection_.reset(PQconnectdbParams(names.data(), values.data(), 1));
  if (connection_ == nullptr) throw std::bad_alloc();
  if (PQstatus(connection_.get()) != CONNECTION_OK) connectAgain();
  PQsetNoticeProcessor(
      connection_.get(), [](void*, const char*) {}, nullptr);
  PQsetnonblocking(connection_.get(), 1);
}

/// After a refused login: libpq gives the server's message, in the server's language, without a
/// code. Connects once more with messages that consist of the SQLSTATE.
void Connection::connectAgain() {
  auto* connection = connection_.get();
  auto said = sentence(PQerrorMessage(connection));
  const bool serverSpoke = !sqlStateIn(said).empty();
  auto kind = loginProblemIn(said).empty() ? Kind::Unreachable : Kind::LoginRefused;
  if (serverSpoke) {
    PQsetErrorVerbosity(connection, PQERRORS_SQLSTATE);
    PQreset(connection);
    PQsetErrorVerbosity(connection, PQERRORS_DEFAULT);
    if (PQstatus(connection) == CONNECTION_OK) return;
    const auto state = sqlStateIn(sentence(PQerrorMessage(connection)));
    kind = kindOf(state, true);
    if (kind == Kind::LoginRefused) said += " (" + state + ")";
  }
  throw ServerError(kind, wordsFor(kind, description(), said));
}

void Connection::execute(const std::string& statements) {
  receiveResult(PQsendQuery(connection_.get(), statements.c_str()) == 1);
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
  return receiveResult(
      PQsendQueryParams(
          connection_.get(),
          statement.c_str(),
          static_cast<int>(parameters.size()),
          nullptr,
          values.data(),
          sizes.data(),
          formats.data(),
          0) == 1);
}

/// Waits for the network. Returns whether data are still to be sent or received before there is a
/// result.
bool Connection::isBusy() {
  auto* connection = connection_.get();
  const int unsent = PQflush(connection);
  if (unsent < 0 || (unsent == 0 && PQisBusy(connection) == 0)) return false;
  pollfd network{
      .fd = PQsocket(connection),
      .events = static_cast<short>(unsent > 0 ? POLLIN | POLLOUT : POLLIN),
      .revents = 0};
  const int ready = poll(&network, 1, static_cast<int>(responseTimeout_.count()));
  if (ready == 0) {
    const auto where = description();
    connection_.reset();  // a late result must not be taken for that of another statement
    throw ServerError(
        Kind::Unreachable,
        wordsFor(
            Kind::Unreachable,
            where,
            fmt::format(
                "it has not answered for {} s",
                static_cast<double>(responseTimeout_.count()) / 1e3)));
  }
  const bool hasCome = ready > 0 && (network.revents & ~POLLOUT) != 0;
  return !hasCome || PQconsumeInput(connection) == 1;
}

/// Waits for the result: the rows of the last statement. Throws the first error.
Rows Connection::receiveResult(bool wasSent) {
  std::unique_ptr<pg_result, decltype(&PQclear)> last(nullptr, &PQclear);
  while (wasSent) {
    while (isBusy()) continue;
    auto* next = PQgetResult(connection_.get());
    if (next == nullptr) break;
    last.reset(next);
  }
  return checked(last.release());
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

std::string Connection::user() const {
  const char* user = PQuser(connection_.get());
  return user == nullptr ? "" : user;
}

ServerError missingRoleError(const Connection& server, std::string_view role) {
  return {
      Kind::Denied,
      fmt::format(
          "The account '{0}' may not do that on the server ({1}): it needs the role {2}. The "
          "server's administrator gives it: GRANT {2} TO \"{0}\";",
          server.user(),
          server.description(),
          role)};
}

}  // namespace study::collect
