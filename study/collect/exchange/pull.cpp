#include "study/collect/exchange/pull.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "protocols/load_protocol.h"
#include "study/collect/exchange/batch.h"
#include "study/collect/exchange/hexadecimal.h"
#include "study/collect/exchange/protocol_files.h"
#include "study/collect/exchange/station_trail.h"
#include "study/collect/server/schema.h"
#include "study/model/user_error.h"
#include "study/session/collected_study.h"
#include "study/storage/erasure/erasure_list.h"
#include "study/storage/hasher.h"
#include "study/storage/protocol_repository.h"

namespace study::collect {
namespace {

using storage::StorageError;

constexpr std::int64_t kEventsAtATime = 5000;
constexpr std::int64_t kSessionsAtATime = 50;

struct StationRow {
  std::int64_t id = 0;
  Station station;
  std::string key;
  std::int64_t have = 0;
};

[[noreturn]] void refuseData(const std::string& what) {
  throw StorageError(
      "The server's data are not what a station sent: " + what +
          ". Nothing was made of them. 'palpate collect check' lists all that is wrong.",
      StorageError::Kind::Damaged);
}

/// Reads a study from the server, as it is at one moment.
class Reader {
 public:
  /// @throws UserError  if there is no reason, or no such study
  Reader(Connection& server, const std::string& name, const std::string& reason) : server_(server) {
    requireSchema(server);
    if (reason.empty()) {
      throw UserError(
          "What is pulled has the map of conditions in it. Say why it is needed: --reason \"…\".");
    }
    const auto rows = server.query(
        "SELECT DISTINCT study, study_name FROM palpate.stations WHERE $1 IN ('', study_name)",
        {name});
    if (rows.count() != 1) {
      throw UserError(
          rows.isEmpty()
              ? "The server has no study of that name that has a station."
              : "There are several studies on this server. Say which one: --study NAME.");
    }
    const auto id =
        server.query("SELECT palpate.unblind($1, $2)", {rows.text(0, 0), reason}).text(0, 0);
    ticket_ = id;
    server.execute("BEGIN ISOLATION LEVEL REPEATABLE READ READ ONLY");
  }
  ~Reader() {
    try {
      server_.execute("ROLLBACK");
    } catch (const ServerError&) {
      return;  // the connection is gone, and its transaction with it
    }
  }
  Reader(const Reader&) = delete;
  Reader& operator=(const Reader&) = delete;

  CollectedStudy::Beginning beginning() {
    const auto rows =
        server_.query("SELECT uuid, seed, secret, created FROM palpate.pull_study($1)", {ticket_});
    const auto secret = rows.bytes(0, 2);
    storage::BlindingSecret::Bytes bytes{};
    if (secret.size() != bytes.size()) refuseData("the secret of its orders is damaged");
    std::transform(secret.begin(), secret.end(), bytes.begin(), [](std::byte b) {
      return std::to_integer<unsigned char>(b);
    });
    return {
        .uuid = rows.text(0, 0),
        .seed = std::strtoull(rows.text(0, 1).c_str(), nullptr, 10),
        .secret = storage::BlindingSecret(bytes),
        .createdUtc = rows.text(0, 3),
        .protocols = protocols()};
  }

  std::vector<StationRow> stations() {
    const auto rows = server_.query(
        "SELECT id, uuid, site, label, key, have FROM palpate.pull_stations($1)", {ticket_});
    std::vector<StationRow> stations;
    for (int i = 0; i < rows.count(); ++i) {
      stations.push_back(
          {.id = rows.number(i, 0),
           .station = {.site = rows.text(i, 2), .label = rows.text(i, 3), .uuid = rows.text(i, 1)},
           .key = rows.text(i, 4),
           .have = rows.number(i, 5)});
    }
    return stations;
  }

  std::vector<storage::StoredEvent> events(const StationRow& station) {
    std::vector<storage::StoredEvent> events;
    for (std::int64_t after = 0;;) {
      const auto rows = server_.query(
          "SELECT * FROM palpate.pull_events($1, $2, $3, $4)",
          {ticket_, station.id, after, kEventsAtATime});
      for (int i = 0; i < rows.count(); ++i) events.push_back(eventIn(rows, i));
      if (rows.isEmpty()) break;
      after = events.back().seq;
    }
    if (static_cast<std::int64_t>(events.size()) != station.have) {
      refuseData(station.station.label + " has not all events that it acknowledged");
    }
    return events;
  }

  /// Calls @p take with each session: its number, the event as of which it is, its facts.
  template <typename Take>
  void forEachSession(const StationRow& station, const Take& take) {
    for (std::int64_t after = 0;;) {
      const auto rows = server_.query(
          "SELECT number, as_of, sha256, facts FROM palpate.pull_sessions($1, $2, $3, $4)",
          {ticket_, station.id, after, kSessionsAtATime});
      if (rows.isEmpty()) return;
      for (int i = 0; i < rows.count(); ++i) {
        after = rows.number(i, 0);
        const auto facts = rows.text(i, 3);
        if (storage::sha256(facts) != hexadecimalOf(rows.bytes(i, 2))) {
          refuseData(station.station.label + ", session " + std::to_string(after));
        }
        take(after, rows.number(i, 1), factsIn(facts));
      }
    }
  }

  std::vector<SentKey> keys(const StationRow& station) {
    const auto rows = server_.query(
        "SELECT participant, key FROM palpate.pull_keys($1, $2)", {ticket_, station.id});
    std::vector<SentKey> keys;
    for (int i = 0; i < rows.count(); ++i) {
      storage::SealingKey::Bytes bytes{};
      const auto stored = rows.bytes(i, 1);
      for (std::size_t at = 0; at < std::min(bytes.size(), stored.size()); ++at) {
        bytes[at] = std::to_integer<unsigned char>(stored[at]);
      }
      keys.push_back({.participant = rows.text(i, 0), .key = storage::SealingKey(bytes)});
    }
    return keys;
  }

  std::vector<storage::TraceChunk> chunks(const StationRow& station, std::int64_t session) {
    const auto rows = server_.query(
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

 private:
  std::vector<protocols::LoadedProtocol> protocols() {
    const auto rows =
        server_.query("SELECT sha256, text, files FROM palpate.pull_protocols($1)", {ticket_});
    std::vector<protocols::LoadedProtocol> loaded;
    for (int i = 0; i < rows.count(); ++i) {
      loaded.push_back(protocolOf(rows.text(i, 1), filesIn(rows.text(i, 2))));
      const auto& protocol = loaded.back();
      if (storage::sha256(protocol.text, protocol.files) != rows.text(i, 0)) {
        refuseData("a protocol differs from its hash");
      }
    }
    if (loaded.empty()) refuseData("it has no protocol");
    return loaded;
  }

  static storage::StoredEvent eventIn(const Rows& rows, int row) {
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

  Connection& server_;
  std::string ticket_;
};

std::string textIn(const storage::SessionFacts& facts, const char* table, const char* column) {
  const auto rows = facts.find(table);
  if (rows == facts.end() || rows->second.empty()) return {};
  const auto found = rows->second.front().find(column);
  const auto* text =
      found == rows->second.front().end() ? nullptr : std::get_if<std::string>(&found->second);
  return text == nullptr ? std::string() : *text;
}

/// The last event of each session.
std::map<std::int64_t, std::int64_t> lastEvents(const std::vector<storage::StoredEvent>& events) {
  std::map<std::int64_t, std::int64_t> last;
  for (const auto& event : events) {
    if (event.session) last[*event.session] = event.seq;
  }
  return last;
}

/// Other copies on this computer, from earlier pulls, forget whom a station erased: they are erased
/// from when they are opened next.
void listErasure(
    const std::string& study, const storage::SessionFacts& facts, const std::string& utc) {
  storage::list(
      {.study = study,
       .participant = textIn(facts, "participant", "code"),
       .enrolledUtc = textIn(facts, "participant", "created_utc"),
       .level = storage::ErasureLevel::Answers,
       .utc = utc});
}

/// Brings one station into the study.
class StationPull {
 public:
  StationPull(Reader& reader, const StationRow& station, CollectedStudy& study, Pulled& pulled)
      : reader_(reader), station_(station), study_(study), pulled_(pulled) {}

  void run(const std::string& studyUuid) {
    auto events = reader_.events(station_);
    const auto head = headOf(events);
    const auto problems = problemsIn(events, studyUuid, station_.key);
    if (!problems.empty()) refuseData(station_.station.label + ": " + problems.front());
    const auto last = lastEvents(events);
    std::set<std::int64_t> there;
    reader_.forEachSession(
        station_, [&](std::int64_t number, std::int64_t asOf, const storage::SessionFacts& facts) {
          const auto found = last.find(number);
          const bool isComplete = found != last.end() && found->second == asOf;
          if (!isComplete) return;  // as of an earlier event: what it says is not all there
          there.insert(number);
          takeSession(studyUuid, number, facts);
        });
    for (const auto& [number, seq] : last) {
      if (there.count(number) > 0) continue;
      pulled_.incomplete.push_back(station_.station.label + ", session " + std::to_string(number));
    }
    for (const auto& key : reader_.keys(station_)) study_.addKey(key.participant, key.key);
    std::erase_if(events, [&](const storage::StoredEvent& event) {
      return event.session && there.count(*event.session) == 0;
    });
    pulled_.events += station_.have;
    ++pulled_.stations;
    study_.add(
        {.station = station_.station, .events = station_.have, .head = head}, std::move(events));
  }

 private:
  static std::string headOf(const std::vector<storage::StoredEvent>& events) {
    return events.empty() ? std::string("-") : hexadecimalOf(events.back().hash);
  }

  void takeSession(
      const std::string& studyUuid, std::int64_t number, const storage::SessionFacts& facts) {
    study_.add(number, facts);
    for (const auto& chunk : reader_.chunks(station_, number)) {
      pulled_.traceBytes += chunk.data.size();
      study_.add(number, chunk);
    }
    ++pulled_.sessions;
    if (textIn(facts, "session", "state") == "erased") {
      ++pulled_.erased;
      listErasure(studyUuid, facts, textIn(facts, "session", "ended_utc"));
    }
  }

  Reader& reader_;
  const StationRow& station_;
  CollectedStudy& study_;
  Pulled& pulled_;
};

}  // namespace

Pulled pull(
    Connection& server, const PullRequest& request, Clock& clock, const Progress& progress) {
  std::error_code error;
  if (std::filesystem::exists(request.folder, error)) {
    throw UserError(
        request.folder.string() +
        " is there already. Nothing is ever overwritten: choose another folder.");
  }
  Reader reader(server, request.study, request.reason);
  const auto beginning = reader.beginning();
  CollectedStudy study(request.folder, clock, beginning);
  Pulled pulled;
  const auto stations = reader.stations();
  for (std::size_t i = 0; i < stations.size(); ++i) {
    tell(
        progress,
        static_cast<double>(i) / static_cast<double>(stations.size()),
        stations[i].station.label);
    StationPull(reader, stations[i], study, pulled).run(beginning.uuid);
  }
  study.finish(request.reason);
  return pulled;
}

std::vector<StationCheck> check(
    Connection& server, const std::string& name, const std::string& reason) {
  Reader reader(server, name, reason);
  const auto uuid = reader.beginning().uuid;
  std::vector<StationCheck> checks;
  for (const auto& station : reader.stations()) {
    StationCheck found{.station = station.station.label, .events = station.have};
    const auto attempt = [&](const auto& action) {
      try {
        action();
      } catch (const StorageError& error) {
        found.problems.emplace_back(error.what());
      }
    };
    attempt([&] { found.problems = problemsIn(reader.events(station), uuid, station.key); });
    attempt([&] {
      reader.forEachSession(station, [&](std::int64_t number, std::int64_t, const auto&) {
        ++found.sessions;
        for (const auto& chunk : reader.chunks(station, number)) {
          if (storage::asBytes(storage::hashOf(chunk.data)) == chunk.hash) continue;
          found.problems.push_back(
              "session " + std::to_string(number) + ", step " + std::to_string(chunk.step + 1) +
              ": samples differ from their hash");
        }
      });
    });
    checks.push_back(std::move(found));
  }
  return checks;
}

}  // namespace study::collect
