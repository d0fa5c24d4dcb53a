#include "study/collect/exchange/server_reader.h"

#include "base/text_table.h"
#include "study/collect/exchange/protocol_files.h"
#include "study/collect/server/schema.h"
#include "study/model/user_error.h"
#include "study/storage/hasher.h"
#include "study/storage/protocol_repository.h"

namespace study::collect {
namespace {

using storage::StorageError;

constexpr std::int64_t kEventsAtATime = 5000;
constexpr std::int64_t kSessionsAtATime = 50;

[[noreturn]] void refuseStudy(const std::string& what) {
  throw StorageError(
      "What the server has of this study is damaged: " + what + ". Nothing was made of it.",
      StorageError::Kind::Damaged);
}

storage::StoredEvent eventIn(const Rows& rows, int row) {
  const auto bytesOr = [&](int column) {
    return rows.isNull(row, column) ? std::vector<std::byte>() : rows.bytes(row, column);
  };
  return {
      .seq = rows.number(row, 0),
      .session = rows.optionalNumber(row, 1),
      .step = rows.optionalNumber(row, 2),
      .attempt = rows.optionalNumber(row, 3),
      .utc = rows.text(row, 4),
      .monotonic = rows.number(row, 5),
      .actor = rows.text(row, 6),
      .kind = rows.text(row, 7),
      .detail = rows.text(row, 8),
      .content = bytesOr(10),
      .sealed = bytesOr(9),
      .hash = rows.bytes(row, 11)};
}

}  // namespace

ServerReader::ServerReader(Connection& server, const std::string& name, const std::string& reason)
    : server_(server) {
  if (base::isBlank(reason)) {
    throw UserError(
        "What is pulled has the map of conditions in it. Say why it is needed: --reason \"…\".");
  }
  ticket_ = withRole(server, "palpate_unblinder", [&] {
    requireSchema(server);
    const auto rows = server.query(
        "SELECT DISTINCT study, study_name FROM palpate.stations WHERE $1 IN ('', study_name)",
        {name});
    if (rows.isEmpty()) {
      throw UserError(
          (name.empty() ? "The server has no study that has a station."
                        : "The server has no study '" + name + "' that has a station.") +
          std::string(" 'palpate collect status' lists what it has."));
    }
    if (rows.count() > 1) {
      throw UserError("There are several studies on this server. Say which one: --study NAME.");
    }
    return server.query("SELECT palpate.unblind($1, $2)", {rows.text(0, 0), reason}).text(0, 0);
  });
}

Snapshot::Snapshot(Connection& server) : server_(server) {
  server_.execute("BEGIN ISOLATION LEVEL REPEATABLE READ READ ONLY");
}

Snapshot::~Snapshot() {
  try {
    server_.execute("ROLLBACK");
  } catch (const ServerError&) {
    return;  // the connection is lost, which ended its transaction
  }
}

Rows ServerReader::query(const std::string& statement, const std::vector<Parameter>& parameters) {
  const std::lock_guard lock(queryMutex_);
  return server_.query(statement, parameters);
}

CollectedStudy::Origin ServerReader::origin() {
  const auto rows =
      query("SELECT uuid, seed, secret, created FROM palpate.pull_study($1)", {ticket_});
  const auto secret = storage::fixedBytes<storage::BlindingSecret::Bytes>(rows.bytes(0, 2));
  if (!secret) refuseStudy("the secret of its orders");
  return {
      .uuid = rows.text(0, 0),
      .seed = std::strtoull(rows.text(0, 1).c_str(), nullptr, 10),
      .secret = storage::BlindingSecret(*secret),
      .createdUtc = rows.text(0, 3),
      .protocols = protocols()};
}

std::vector<StationRow> ServerReader::stations() {
  const auto rows =
      query("SELECT id, uuid, site, label, key, have FROM palpate.pull_stations($1)", {ticket_});
  std::vector<StationRow> stations;
  for (int i = 0; i < rows.count(); ++i) {
    stations.push_back(
        {.id = rows.number(i, 0),
         .station = {.site = rows.text(i, 2), .label = rows.text(i, 3), .uuid = rows.text(i, 1)},
         .key = rows.text(i, 4),
         .lastEvent = rows.number(i, 5)});
  }
  return stations;
}

std::vector<storage::StoredEvent> ServerReader::events(const StationRow& station) {
  std::vector<storage::StoredEvent> events;
  for (std::int64_t after = 0;;) {
    const auto rows = query(
        "SELECT * FROM palpate.pull_events($1, $2, $3, $4)",
        {ticket_, station.id, after, kEventsAtATime});
    if (rows.isEmpty()) return events;
    for (int i = 0; i < rows.count(); ++i) events.push_back(eventIn(rows, i));
    after = events.back().seq;
  }
}

void ServerReader::forEachSession(
    const StationRow& station, const std::function<void(const SessionOnServer&)>& take) {
  for (std::int64_t after = 0;;) {
    const auto rows = query(
        "SELECT number, as_of, sha256, facts, has_samples "
        "FROM palpate.pull_sessions($1, $2, $3, $4)",
        {ticket_, station.id, after, kSessionsAtATime});
    if (rows.isEmpty()) return;
    for (int i = 0; i < rows.count(); ++i) {
      after = rows.number(i, 0);
      take(
          {.number = after,
           .lastEvent = rows.number(i, 1),
           .sha256 = storage::inHexadecimal(rows.bytes(i, 2)),
           .facts = rows.text(i, 3),
           .hasSamples = rows.text(i, 4) == "t"});
    }
  }
}

std::vector<SentKey> ServerReader::keys(const StationRow& station) {
  const auto rows =
      query("SELECT participant, key FROM palpate.pull_keys($1, $2)", {ticket_, station.id});
  std::vector<SentKey> keys;
  for (int i = 0; i < rows.count(); ++i) {
    // Nothing can be opened with a damaged key.
    const auto bytes = storage::fixedBytes<storage::SealingKey::Bytes>(rows.bytes(i, 1));
    keys.push_back(
        {.participant = rows.text(i, 0),
         .key = storage::SealingKey(bytes.value_or(storage::SealingKey::Bytes{}))});
  }
  return keys;
}

std::vector<storage::TraceChunk> ServerReader::chunks(
    const StationRow& station, std::int64_t session) {
  const auto rows = query(
      "SELECT step, attempt, number, samples, layout, data, hash "
      "FROM palpate.pull_traces($1, $2, $3)",
      {ticket_, station.id, session});
  std::vector<storage::TraceChunk> chunks;
  for (int i = 0; i < rows.count(); ++i) {
    chunks.push_back(
        {.step = static_cast<int>(rows.number(i, 0)),
         .attempt = static_cast<int>(rows.number(i, 1)),
         .number = rows.number(i, 2),
         .samples = rows.number(i, 3),
         .layout = rows.number(i, 4),
         .data = rows.bytes(i, 5),
         .hash = rows.bytes(i, 6)});
  }
  return chunks;
}

std::vector<protocols::LoadedProtocol> ServerReader::protocols() {
  const auto rows = query("SELECT sha256, text, files FROM palpate.pull_protocols($1)", {ticket_});
  std::vector<protocols::LoadedProtocol> loaded;
  for (int i = 0; i < rows.count(); ++i) {
    loaded.push_back(protocolOf(rows.text(i, 1), filesIn(rows.text(i, 2))));
    const auto& protocol = loaded.back();
    if (storage::sha256(protocol.text, protocol.files) != rows.text(i, 0)) {
      refuseStudy("a protocol differs from its hash");
    }
  }
  if (loaded.empty()) refuseStudy("it has no protocol");
  return loaded;
}

}  // namespace study::collect
