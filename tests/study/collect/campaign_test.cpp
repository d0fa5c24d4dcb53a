// Stations, pushes and a server that are killed while a study goes on: what arrives is what was
// recorded, once. With PALPATE_CAMPAIGN six stations with 6,000 events each.
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <random>

#include <fmt/format.h>

#include "study/cohort/simulated_participant.h"
#include "study/collect/exchange/administration.h"
#include "study/collect/exchange/bundle.h"
#include "study/collect/exchange/enrolment.h"
#include "study/collect/exchange/pull.h"
#include "study/collect/server/registry.h"
#include "study/export/export.h"
#include "study/export/statistics_table.h"
#include "study/model/user_error.h"
#include "study/results/results_text.h"
#include "study/session/collected_study.h"
#include "study/session/verification.h"
#include "study/storage/hasher.h"
#include "study/storage/transfer/session_facts.h"
#include "tests/study/collect/collected_study_at.h"
#include "tests/study/walk.h"

namespace campaign_test {

using study::Study;
using study::collect::Batch;
using study::collect::Outbox;
using study::collect::PrivateServer;

constexpr auto kReadOnly = study::storage::Database::Access::ReadOnly;

struct Size {
  int stations = 2;
  std::int64_t events = 100;  ///< of each station, at least
  int people = 1;             ///< who come in one round, besides a simulated one
  int kills = 1;              ///< at least, of stations and of pushes together
  int stops = 1;              ///< of the server, at least
};

bool isWholeCampaign() {
  return std::getenv("PALPATE_CAMPAIGN") != nullptr;  // NOLINT(concurrency-mt-unsafe): one thread
}

Size usualSize() {
  return isWholeCampaign()
             ? Size{.stations = 6, .events = 6000, .people = 6, .kills = 25, .stops = 5}
             : Size{};
}

/// What is broken on purpose, so that the comparison has something to find.
enum class Sabotage { None, NoCheckForDoubles, AnAcknowledgedBatchIsDropped };

class Campaign : public tests::CollectTest {
 protected:
  /// Runs all of it. @return  every difference between stations, server and pulled folder
  std::vector<std::string> run(const Size& size, Sabotage sabotage) {
    sabotage_ = sabotage;
    people_ = size.people;
    enrol(size.stations);
    if (sabotage == Sabotage::NoCheckForDoubles) removeCheckForDoubles();
    for (bool isGrown = false; !isGrown || kills_ < size.kills || stops_ < size.stops;) {
      isGrown = true;
      for (const auto& label : labels_) {
        const bool isSmall = eventsOf(label) < size.events;
        isGrown = isGrown && !isSmall;
        if (!isSmall && kills_ >= size.kills && stops_ >= size.stops) continue;
        work(label);
        send(label, stops_ < size.stops);
      }
    }
    for (const auto& label : labels_) finish(label);
    if (sabotage == Sabotage::AnAcknowledgedBatchIsDropped) EXPECT_TRUE(isDropped_);
    return differences();
  }

  int kills_ = 0;
  int stops_ = 0;
  int refusals_ = 0;  ///< of bundles that came before their predecessor
  std::int64_t batches_ = 0;

 private:
  void enrol(int stations) {
    const int sites = std::max(stations / 2, std::min(stations, 2));
    for (int i = 0; i < stations; ++i) {
      // Up to two stations a site, and the names in another order than they are enrolled in.
      const auto site = std::string("site") + static_cast<char>('z' - i % sites);
      labels_.push_back(i < sites ? site : site + "-2");
      addStation(site, i < sites ? "" : site + "-2");
    }
  }

  std::int64_t eventsOf(const std::string& label) {
    const auto account = accountOf(label);
    return Outbox(folderOf(label), clock_).lastEvent();
  }

  /// Calls @p action in a process of its own. @return  its id
  template <typename Action>
  static pid_t begin(const Action& action) {
    const pid_t id = fork();
    if (id != 0) return id;
    try {
      action();
    } catch (const std::exception&) {
      _exit(1);  // the server was stopped
    }
    _exit(0);
  }

  /// Waits for it. @return  whether it came to its end
  bool hasEnded(pid_t id) {
    int status = 0;
    waitpid(id, &status, 0);
    if (WIFSIGNALED(status)) ++kills_;
    return WIFEXITED(status) && WEXITSTATUS(status) == 0;
  }

  /// Kills it after @p patience [µs]; 0: does it here. @return  whether it came to its end
  template <typename Action>
  bool attempt(useconds_t patience, const Action& action) {
    if (patience == 0) {
      action();
      return true;
    }
    const pid_t id = begin(action);
    usleep(patience);
    kill(id, SIGKILL);
    return hasEnded(id);
  }

  useconds_t soon(int most) {
    return static_cast<useconds_t>(std::uniform_int_distribution<int>(2'000, most)(random_));
  }

  /// Once in so many times, not in turn: a station whose turn it always is would never get on.
  bool isTurn(int times) { return std::uniform_int_distribution<int>(1, times)(random_) == 1; }

  static void endSessions(Study& study) {
    for (const auto& row : study.sessions().all()) {
      if (row.runMode != study::RunMode::Live || study::isOver(row.state)) continue;
      auto session = study::Session::resume(study, row.id);
      if (session.state() == study::SessionState::Interrupted) session.repeatStep("killed in it");
      tests::walkToTheEnd(session);
    }
  }

  /// Participants come. Once in three times somebody pulls the plug; the next go on from there.
  void work(const std::string& label) { work(label, isTurn(3) ? soon(300'000) : 0); }

  void work(const std::string& label, useconds_t patience) {
    attempt(patience, [&] {
      const auto account = accountOf(label);
      auto study = Study::open(folderOf(label), clock_);
      int simulated = 0;
      for (const auto& row : study.sessions().all()) {
        if (row.runMode == study::RunMode::Simulated && study::isOver(row.state)) ++simulated;
      }
      endSessions(study);
      study::simulateCohorts(study, clock_, simulated + 1, seedOf(label), [](const auto&) {});
      for (int i = 0; i < people_; ++i) {
        auto session = tests::consenting(study, {.cohort = i % 2 == 0 ? "surgeons" : "students"});
        tests::walkToTheEnd(session);
        clock_.advance(60.0);
      }
    });
    clock_.advance(3600.0);
  }

  std::uint64_t seedOf(const std::string& label) const {
    return 1 + static_cast<std::uint64_t>(
                   std::find(labels_.begin(), labels_.end(), label) - labels_.begin());
  }

  bool hasNetwork(const std::string& label) const { return seedOf(label) % 3 != 2; }

  /// Some pushes are killed, some meet a server that is stopped at once.
  void send(const std::string& label, bool mayStop) {
    if (!hasNetwork(label)) {
      sendBundles(label);
      return;
    }
    const auto push = [&] { pushThrice(label); };
    if (mayStop && isTurn(4)) {
      const pid_t id = begin(push);
      usleep(soon(80'000));
      postgres().stop(PrivateServer::Stop::Immediate);
      ++stops_;
      hasEnded(id);
      postgres().start();
      return;
    }
    // In a control nothing is killed: a push that ends after the first of three sends nothing
    // twice.
    const bool mayBeKilled = sabotage_ == Sabotage::None && isTurn(2);
    if (attempt(mayBeKilled ? soon(80'000) : 0, push)) drop(label);
  }

  static Outbox::Limits smallParts() { return {.events = 150, .traceBytes = 200'000}; }

  /// Sends what the server has not, each part three times.
  void pushThrice(const std::string& label) {
    const auto account = accountOf(label);
    Outbox outbox(folderOf(label), clock_);
    outbox.setLimits(smallParts());
    auto server = as(study::collect::serverSettingsOf(folderOf(label)).role);
    const auto have = study::collect::ingest(server, outbox.lastEventQuery()).lastEvent;
    outbox.forEachBatch(have, [&](const Batch& batch) {
      for (int times = 0; times < 3; ++times) {
        const auto answer = study::collect::ingest(server, batch);
        if (!answer.refused.empty()) throw study::UserError(answer.refused);
      }
      ++batches_;
      return true;
    });
  }

  /// Two bundles of what is new: the second comes first, and both come again.
  void sendBundles(const std::string& label) {
    auto owner = admin();
    const auto before =
        owner.query("SELECT have FROM palpate.station WHERE label = $1", {label}).number(0, 0);
    const auto account = accountOf(label);
    const auto station =
        study::storage::StationStore::openOrCreate(study::storage::StationStore::defaultFolder());
    const auto home = study::collect::serverSettingsOf(folderOf(label));
    const auto write = [&](std::int64_t after) {
      const auto file = scratch_ / ("bundle-" + std::to_string(++bundles_));
      Outbox outbox(folderOf(label), clock_);
      outbox.setLimits(smallParts());
      const auto last =
          study::collect::writeBundle(outbox, station, home.bundleKey, after, file).last;
      return std::make_pair(file, last);
    };
    if (eventsOf(label) == before) return;
    const auto first = write(before);
    work(label);
    const auto take = [&](const std::string& file) {
      try {
        study::collect::ingestBundle(owner, file);
      } catch (const study::UserError&) {
        ++refusals_;
      }
    };
    if (eventsOf(label) > first.second) {
      const auto second = write(first.second);
      take(second.first);
      take(first.first);
      take(second.first);
      std::filesystem::remove(second.first);
    }
    take(first.first);
    std::filesystem::remove(first.first);
    drop(label);
  }

  /// What was killed at last is signed with the end of the next session, and pulled from then on.
  void finish(const std::string& label) {
    work(label, 0);
    pushThrice(label);
    drop(label);
    push(label);
  }

  void removeCheckForDoubles() {
    admin().execute(
        "ALTER TABLE palpate.event DROP CONSTRAINT event_pkey;"
        "DO $$ BEGIN "
        "EXECUTE replace(replace(replace(pg_get_functiondef('palpate.take_events'::regproc), "
        "'WHERE n.seq > me.have RETURNING', 'RETURNING'), "
        "'IF coalesce(many, 0) = 0 THEN RETURN me.have; END IF;', ''), "
        "'RETURN most;', 'RETURN coalesce(most, me.have);');"
        "EXECUTE replace(pg_get_functiondef('palpate.ingest'::regproc), "
        "'seq = reached)', 'seq = reached LIMIT 1)'); END $$");
  }

  /// Once, the server forgets the middle of what it acknowledged.
  void drop(const std::string& label) {
    if (sabotage_ != Sabotage::AnAcknowledgedBatchIsDropped || isDropped_) return;
    isDropped_ = true;
    admin().execute(
        "ALTER TABLE palpate.event DISABLE TRIGGER an_event_is_never_changed;"
        "DELETE FROM palpate.event USING palpate.station AS s "
        "WHERE s.id = station AND s.label = '" +
        label +
        "' AND seq BETWEEN 20 AND 40;"
        "ALTER TABLE palpate.event ENABLE TRIGGER an_event_is_never_changed");
  }

  // What is compared.

  /// Number and hash of each event of each station, there and on the server.
  std::pair<std::string, std::string> chains() {
    std::pair<std::string, std::string> chains;
    auto owner = admin();
    for (const auto& label : labels_) {
      const auto account = accountOf(label);
      auto study = Study::open(folderOf(label), clock_, kReadOnly);
      for (const auto& event : study.events().stored(0, study.events().last())) {
        chains.first += label + " " + std::to_string(event.seq) + " " +
                        study::storage::inHexadecimal(event.hash) + "\n";
      }
      const auto rows = owner.query(
          "SELECT e.seq, encode(e.hash, 'hex') FROM palpate.event AS e JOIN palpate.station AS s "
          "ON s.id = e.station WHERE s.label = $1 ORDER BY e.seq",
          {label});
      for (int i = 0; i < rows.count(); ++i) {
        chains.second += label + " " + rows.text(i, 0) + " " + rows.text(i, 1) + "\n";
      }
    }
    return chains;
  }

  /// The stations' folders put together without any server.
  std::string unionOfFolders() {
    auto owner = admin();
    const auto row = study::collect::findStudy(owner, "short");
    study::storage::BlindingSecret::Bytes secret{};
    std::transform(row.secret.begin(), row.secret.end(), secret.begin(), [](std::byte b) {
      return std::to_integer<unsigned char>(b);
    });
    auto inOrder = labels_;
    std::sort(inOrder.begin(), inOrder.end());
    const auto folder = scratch_ / "without a server";
    const auto analyst = std::make_unique<tests::OwnStation>(scratch_ / "account-analyst");
    study::CollectedStudy all(
        folder,
        clock_,
        {.uuid = row.uuid,
         .seed = std::stoull(row.seed),
         .secret = study::storage::BlindingSecret(secret),
         .createdUtc = "2000-01-01T00:00:00.000Z",
         .protocols = {tests::protocolFrom(tests::shortProtocol())}});
    for (const auto& label : inOrder) add(label, all);
    all.finish("to compare");
    return folder;
  }

  void add(const std::string& label, study::CollectedStudy& all) {
    const auto account = accountOf(label);
    auto study = Study::open(folderOf(label), clock_, kReadOnly);
    for (const auto& session : study.sessions().all()) {
      const auto number = static_cast<std::int64_t>(session.id);
      all.add(number, study::storage::sessionTablesOf(study.database(), session.id));
      if (const auto key = study.events().keyOf(session.id)) all.addKey(session.participant, *key);
      for (const auto& visit : study.traces().visits()) {
        if (visit.session != session.id) continue;
        for (const auto& chunk : study::storage::chunksOf(study.traces().database(), visit)) {
          all.add(number, study::storage::opened(chunk, session.id, *study.database().key()));
        }
      }
    }
    auto events = study.events().stored(0, study.events().last());
    const study::CollectedStudy::Trail trail{
        .station = study.station(),
        .events = study.events().last(),
        .head = study::storage::inHexadecimal(events.back().hash)};
    all.add(trail, std::move(events));
  }

  /// All tables of an export, for readers who may see everything, and for blinded ones.
  std::string exportsOf(const std::string& folder) {
    const auto account = accountOf("analyst");
    auto study = Study::open(folder, clock_, kReadOnly);
    std::string text;
    for (const bool isBlinded : {false, true}) {
      const study::ExportOptions options{
          .isBlinded = isBlinded, .isExact = !isBlinded, .hasTexts = true, .codes = "codes"};
      for (const auto& table : study::exportTables(study, options)) {
        text += table.name + "\n";
        for (const auto& row : table.rows) {
          for (const auto& cell : row) text += asWords(cell) + " ";
          text += "\n";
        }
      }
    }
    return text;
  }

  /// Statistics in full precision, in both profiles, and as they are printed.
  std::string statisticsOf(const std::string& folder) {
    const auto account = accountOf("analyst");
    auto study = Study::open(folder, clock_, kReadOnly);
    std::string text;
    for (const auto mode : {study::RunMode::Simulated, study::RunMode::Live}) {
      const study::ExportOptions options{.runMode = mode, .isBlinded = false};
      const auto results = study::resultsFor(study, options);
      for (const auto& table :
           {study::statisticsTable(study, options, results),
            study::votesTable(study, options, results)}) {
        for (const auto& row : table.rows) {
          for (const auto& cell : row) text += asWords(cell) + " ";
          text += "\n";
        }
      }
      for (const auto& one : results) {
        text += study::resultsAsText(study, one, study::Profile::Recommended);
      }
    }
    return text;
  }

  static std::string asWords(const study::Cell& cell) {
    return std::visit(
        [](const auto& held) -> std::string {
          using Held = std::decay_t<decltype(held)>;
          if constexpr (std::is_same_v<Held, std::monostate>) {
            return "-";
          } else if constexpr (std::is_same_v<Held, std::string>) {
            return held;
          } else {
            return fmt::format("{}", held);  // the shortest text that gives the same number
          }
        },
        cell);
  }

  /// What the trail says, without what is of the folder alone: two events at its beginning, and the
  /// signature at its end.
  std::vector<std::string> saidBy(const std::string& folder) {
    const auto account = accountOf("analyst");
    auto study = Study::open(folder, clock_, kReadOnly);
    std::vector<std::string> said;
    for (const auto& event : study.events().read()) {
      said.push_back(fmt::format(
          "{} {} {} {}", event.when.wall, event.when.monotonic, event.name(), describe(event)));
    }
    if (said.size() < 4) return {};
    return {said.begin() + 2, said.end() - 1};
  }

  std::vector<std::string> differences() {
    std::vector<std::string> found;
    const auto compare = [&](const auto& one, const auto& other, const char* what) {
      if (one != other) found.emplace_back(what);
    };
    std::vector<std::string> folders;
    for (const auto& label : labels_) folders.push_back(folderOf(label));
    const auto content = contentOf(folders);
    things_ = content.size();
    const auto trails = chains();
    events_ = std::count(trails.first.begin(), trails.first.end(), '\n');
    compare(contentOfServer(), content, "tables and traces of the server");
    compare(trails.second, trails.first, "audit trails of the server");
    try {
      const auto account = accountOf("analyst");
      auto server = admin();
      const auto pulled = study::collect::pull(
          server, {.folder = scratch_ / "union", .reason = "to evaluate"}, clock_);
      traceBytes_ = 0;
      for (const auto& station : pulled.stations) {
        if (!station.incomplete.empty()) found.emplace_back("incomplete sessions");
        for (const auto& problem : station.problems) found.push_back(problem);
        traceBytes_ += station.traceBytes;
      }
      sessions_ = pulled.sessions();
    } catch (const std::exception& error) {
      found.push_back(std::string("nothing was pulled: ") + error.what());
      return found;
    }
    const auto whole = unionOfFolders();
    compare(contentOf({scratch_ / "union"}), content, "tables and traces of the pulled folder");
    compare(saidBy(scratch_ / "union"), saidBy(whole), "what the trail says");
    const auto statistics = statisticsOf(whole);
    EXPECT_GT(statistics.size(), 1000U);
    compare(statisticsOf(scratch_ / "union"), statistics, "statistics");
    const auto exports = exportsOf(whole);
    EXPECT_GT(exports.size(), 1000U);
    compare(exportsOf(scratch_ / "union"), exports, "exports");
    const auto account = accountOf("analyst");
    auto study = Study::open(scratch_ / "union", clock_, kReadOnly);
    for (const auto& check : study::verify(study).checks) {
      for (const auto& problem : check.problems) found.push_back(check.what + ": " + problem);
    }
    return found;
  }

 protected:
  void report() const {
    std::printf(
        "campaign: %zu stations, %lld events, %zu sessions, %zu sessions and traces compared, %.1f "
        "MB of samples, %d kills, %d stops of the server, %d bundles, %d of them refused before "
        "their turn\n",
        labels_.size(),
        static_cast<long long>(events_),
        sessions_,
        things_,
        static_cast<double>(traceBytes_) / 1e6,
        kills_,
        stops_,
        bundles_,
        refusals_);
  }

 private:
  Sabotage sabotage_ = Sabotage::None;
  int people_ = 1;
  std::vector<std::string> labels_;
  std::mt19937 random_{20261123};
  int bundles_ = 0;
  bool isDropped_ = false;
  std::int64_t events_ = 0;
  std::size_t sessions_ = 0;
  std::size_t things_ = 0;
  std::uint64_t traceBytes_ = 0;
};

TEST_F(Campaign, LosesAndDoublesNothing) {
  const auto size = usualSize();
  EXPECT_EQ(run(size, Sabotage::None), std::vector<std::string>());
  EXPECT_GE(kills_, size.kills);
  EXPECT_GE(stops_, size.stops);
  EXPECT_TRUE(refusals_ > 0 || !isWholeCampaign());
  EXPECT_TRUE(incidents().empty() || incidents().front() == "gap") << incidents().front();
  report();
}

// Controls, by the same comparison.

constexpr Size kSmall{.stations = 1, .events = 60, .kills = 0, .stops = 0};

TEST_F(Campaign, FindsWhatIsDoubledWithoutTheCheck) {
  const auto found = run(kSmall, Sabotage::NoCheckForDoubles);
  EXPECT_NE(std::find(found.begin(), found.end(), "audit trails of the server"), found.end());
}

TEST_F(Campaign, FindsAnAcknowledgedBatchThatWasDropped) {
  const auto found = run(kSmall, Sabotage::AnAcknowledgedBatchIsDropped);
  EXPECT_NE(std::find(found.begin(), found.end(), "audit trails of the server"), found.end());
}

}  // namespace campaign_test
