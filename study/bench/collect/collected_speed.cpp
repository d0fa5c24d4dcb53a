#include "study/bench/collect/collected_speed.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <map>
#include <tuple>

#include <fmt/format.h>

#include "study/bench/memory.h"
#include "study/collect/app/options.h"
#include "study/collect/exchange/pull.h"
#include "study/model/new_file.h"
#include "study/storage/statement.h"

namespace study::bench {
namespace {

namespace fs = std::filesystem;
using collect::Connection;

constexpr int kMostParts = 20;
constexpr std::array kTables{"event", "session", "fact", "progress", "answer"};

/// Numbers of answers by cohort, code or condition, and point of the scale.
using Counts = std::map<std::tuple<std::string, std::string, std::int64_t>, std::int64_t>;

/// The query of the counts from which the pairwise comparisons are computed.
std::string countQuery(const std::string& table, const std::string& instrument) {
  return "SELECT cohort, code, point, count(*) FROM " + table +
         " WHERE run_mode = 'simulated' AND state = 'completed' AND instrument = '" + instrument +
         "' GROUP BY 1, 2, 3";
}

/// Stores the rows of a station a second time, by COPY from a file: a lower bound for the time of
/// storing them.
class PlainCopy {
 public:
  PlainCopy(Connection& owner, const fs::path& folder) : owner_(owner), folder_(folder) {
    owner_.execute("CREATE SCHEMA bare");
    for (const std::string table : kTables) {
      owner_.execute("CREATE TABLE bare." + table + " (LIKE palpate." + table + ")");
    }
    owner_.execute("CREATE TABLE bare.chunk (LIKE palpate.chunk INCLUDING STORAGE)");
  }

  /// Measures the COPY of a station's answers, and of all its rows.
  void copy(const std::string& label, IngestSpeed& part) {
    for (const std::string table : kTables) write(table, label, "");
    part.copyingAll += timeOf(owner_, [&] {
      owner_.execute("BEGIN");
      for (const std::string table : kTables) read(table, "");
      owner_.execute("COMMIT");
    });
    owner_.execute("TRUNCATE bare.answer");  // those of the last station are copied again
    part.copying += timeOf(owner_, [&] { read("answer", ""); });
  }

  /// The time of the COPY of a station's samples.
  WorkTime copyTraces(const std::string& label) {
    write("chunk", label, " (FORMAT binary)");
    owner_.execute("TRUNCATE bare.chunk");
    return timeOf(owner_, [&] { read("chunk", " (FORMAT binary)"); });
  }

 private:
  std::string file(const std::string& table) const {
    return owner_.quotedText((folder_ / (table + ".copy")).string());
  }
  void write(const std::string& table, const std::string& label, const char* how) {
    owner_.execute(
        "COPY (SELECT * FROM palpate." + table +
        " WHERE station = (SELECT id FROM palpate.station WHERE label = '" + label + "')) TO " +
        file(table) + how);
  }
  void read(const std::string& table, const char* how) {
    owner_.execute("COPY bare." + table + " FROM " + file(table) + how);
  }

  Connection& owner_;
  fs::path folder_;
};

void send(
    const CollectBenchOptions& size,
    ManyStations& stations,
    PlainCopy& plain,
    CollectMeasurement& measured) {
  const int parts = std::min(kMostParts, size.sites);
  std::int64_t sent = 0;
  int number = 0;
  for (int part = 1; part <= parts; ++part) {
    std::fprintf(stderr, "sites: %d of %d\n", number, size.sites);
    auto& speed = measured.parts.emplace_back();
    speed.before = sent;
    while (number < size.sites * part / parts) {
      ++number;
      const auto share = size.answers * number / size.sites - sent;
      if (share <= 0) continue;
      const auto push = stations.add(number, share);
      sent += push.answers;
      speed.sent += push;
      plain.copy(ManyStations::labelOf(number), speed);
    }
  }
}

Counts countsIn(Connection& server, const std::string& query) {
  const auto rows = server.query(query);
  Counts counts;
  for (int i = 0; i < rows.count(); ++i) {
    counts[{rows.text(i, 0), rows.text(i, 1), rows.number(i, 2)}] = rows.number(i, 3);
  }
  return counts;
}

/// Replaces codes by conditions, which only the owner of the database can read.
Counts withConditionNames(Connection& owner, const Counts& counts) {
  const auto rows = owner.query(
      "SELECT code, condition FROM palpate.condition_code WHERE run_mode = 'simulated'");
  std::map<std::string, std::string> names;
  for (int i = 0; i < rows.count(); ++i) names[rows.text(i, 0)] = rows.text(i, 1);
  Counts result;
  for (const auto& [place, count] : counts) {
    const auto& [cohort, code, point] = place;
    result[{cohort, names[code], point}] = count;
  }
  return result;
}

/// The counts, computed from a study's folder.
Counts countsAt(const fs::path& folder, const std::string& instrument) {
  auto study = Study::open(folder, storage::Database::Access::ReadOnly);
  storage::Statement select(
      study.database(),
      "SELECT s.cohort, l.condition, a.point, count(*) FROM answer AS a "
      "JOIN session AS s ON s.id = a.session_id "
      "JOIN step AS t ON t.session_id = a.session_id AND t.step = a.step "
      "JOIN allocation AS l ON l.session_id = a.session_id AND l.step = a.step "
      "JOIN visit AS v ON v.session_id = a.session_id AND v.step = a.step AND v.attempt = "
      "a.attempt "
      "WHERE s.state = 'completed' AND t.instrument = ? AND l.condition <> '' "
      "AND v.status = 'finished' AND a.point IS NOT NULL GROUP BY 1, 2, 3");
  select.bindAll(instrument);
  Counts counts;
  while (select.step()) {
    counts[{select.text(0), select.text(1), select.number(2)}] = select.number(3);
  }
  return counts;
}

void count(
    const collect::PrivateServer& postgres,
    const std::string& instrument,
    int repetitions,
    CollectMeasurement& measured) {
  Connection owner(postgres.server());
  owner.execute("CREATE TABLE bare.points AS SELECT * FROM palpate.answers");
  owner.execute(
      "GRANT USAGE ON SCHEMA bare TO palpate_analyst; GRANT SELECT ON bare.points TO "
      "palpate_analyst");
  owner.execute("VACUUM ANALYZE");
  Connection analyst(postgres.server());
  analyst.execute("SET ROLE palpate_analyst");
  const auto ours = countQuery("palpate.answers", instrument);
  const auto bare = countQuery("bare.points", instrument);
  if (countsIn(analyst, ours) != countsIn(analyst, bare)) {
    measured.problems.emplace_back("the analyst's view counts other answers than its own rows");
  }
  for (int i = 0; i < repetitions; ++i) {
    measured.counts.ours.push_back(timeOf(analyst, [&] { analyst.query(ours); }).wall);
    measured.counts.bare.push_back(timeOf(analyst, [&] { analyst.query(bare); }).wall);
  }
  const auto plan = owner.query("EXPLAIN (ANALYZE, BUFFERS) " + ours);
  for (int i = 0; i < plan.count(); ++i) measured.plan.push_back(plan.text(i, 0));
}

double megabytesOf(const fs::path& folder) {
  double bytes = 0.0;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (entry.is_regular_file()) bytes += static_cast<double>(entry.file_size());
  }
  return bytes / 1e6;
}

void pullAll(
    const collect::PrivateServer& postgres,
    const CollectBenchOptions& size,
    const std::string& instrument,
    CollectMeasurement& measured) {
  const TemporaryFolder own(size.folder);
  const collect::StationFolderOverride account(own / "account");
  SystemClock clock;
  Connection server(postgres.server());
  resetPeakMemory();
  measured.memoryBefore = peakMemory();
  measured.pulling = timeOf(server, [&] {
    const auto pulled =
        collect::pull(server, {.folder = own / "study", .reason = "benchmark"}, clock);
    measured.sessions = static_cast<std::int64_t>(pulled.sessions());
    const auto note = [&](const std::vector<std::string>& problems) {
      measured.problems.insert(measured.problems.end(), problems.begin(), problems.end());
    };
    // Problems that 'study verify' finds in the folder are ignored: repeated sessions have the
    // orders of the station at which they were recorded.
    for (const auto& station : pulled.stations) {
      measured.events += station.events;
      note(station.problems);
      note(station.incomplete);
    }
  });
  measured.memory = peakMemory();
  measured.pulledMegabytes = megabytesOf(own / "study");
  const auto counts =
      withConditionNames(server, countsIn(server, countQuery("palpate.answers", instrument)));
  measured.groups = counts.size();
  if (counts.empty() || counts != countsAt(own / "study", instrument)) {
    measured.problems.emplace_back("the pulled folder has other counts than the analyst's view");
  }
}

void measureTableSizes(Connection& owner, CollectMeasurement& measured) {
  for (const std::string table : {"answer", "session", "event", "fact", "progress", "chunk"}) {
    const auto rows = owner.query(
        "SELECT (SELECT count(*) FROM palpate." + table + "), pg_table_size('palpate." + table +
        "'), pg_indexes_size('palpate." + table + "')");
    measured.tables.push_back(
        {.table = table,
         .rows = rows.number(0, 0),
         .bytes = rows.number(0, 1),
         .indexes = rows.number(0, 2)});
  }
}

}  // namespace

CollectMeasurement measureCollection(const CollectBenchOptions& size) {
  CollectMeasurement measured;
  const collect::PrivateServer postgres;
  std::fprintf(stderr, "%d simulated participants with samples\n", size.participants);
  ManyStations stations(postgres, size.folder, size.participants);
  measured.recorded = stations.recorded();
  Connection owner(postgres.server());
  PlainCopy plain(owner, postgres.folder());
  for (int i = 0; i < size.repetitions; ++i) {
    measured.copyingTraces.push_back(plain.copyTraces(ManyStations::kRecorded));
  }
  send(size, stations, plain, measured);
  const auto& instrument = stations.protocol().protocol.analysis.families.at(0).instrument;
  std::fprintf(stderr, "counts\n");
  count(postgres, instrument, size.repetitions, measured);
  std::fprintf(stderr, "pull\n");
  pullAll(postgres, size, instrument, measured);
  measureTableSizes(owner, measured);
  measured.sites = size.sites;
  measured.answers = measured.tables.front().rows;
  auto sent = measured.recorded.answers;
  for (const auto& part : measured.parts) sent += part.sent.answers;
  if (sent != measured.answers) {
    measured.problems.push_back(
        fmt::format("{} answers were sent, and {} are there", sent, measured.answers));
  }
  return measured;
}

}  // namespace study::bench
