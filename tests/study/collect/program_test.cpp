// The program palpate-collect, as an administrator and a person at the desk call it.
#include <filesystem>

#include <fmt/format.h>

#include "study/session/backup.h"
#include "study/session/erasure.h"
#include "tests/study/collect/collected_study_at.h"
#include "tests/support/child_process.h"
#include "tests/support/long_form.h"

namespace program_test {

class CollectProgram : public tests::CollectTest {
 protected:
  /// What it prints, with its errors.
  std::string call(
      std::vector<std::string> words, int status = 0, const std::string& account = "account") {
    const auto folder = std::filesystem::read_symlink("/proc/self/exe").parent_path();
    words.insert(words.begin(), folder / "palpate-collect");
    auto environment = environment_;
    environment.push_back("PALPATE_SERVER=" + postgres().server(database()));
    environment.push_back("PALPATE_STATION=" + (scratch_ / account));
    const auto finished = tests::run(words, environment);
    EXPECT_EQ(finished.status, status) << words.at(1) << ": " << finished.error;
    return finished.out + finished.error;
  }

  /// Where a role is let in without a password: over the socket.
  static std::string way(const std::string& database) {
    return fmt::format(
        "host={} port={} dbname={}", postgres().folder().string(), postgres().port(), database);
  }

  static void expectWords(const std::string& said, const std::string& words) {
    EXPECT_NE(said.find(words), std::string::npos) << said;
  }

  std::vector<std::string> environment_;  ///< of the program
};

TEST_F(CollectProgram, EnrolsByAMarkAndShowsWhatWasRefused) {
  const auto protocol = scratch_.write("protocol.json", tests::shortProtocol());
  expectWords(call({"init", "--study", "realism", "--protocol", protocol}), "is on the server");
  auto key = call({"key"});
  key.pop_back();
  const auto file = scratch_ / "oslo.enrol";
  const auto said =
      call({"init", "--study", "realism", "--station", file, "--site", "oslo", "--key", key});
  const std::string sign = "telephone: ";
  expectWords(said, sign);
  const auto mark = said.substr(said.find(sign) + sign.size(), 24);
  expectWords(
      call({"join", file, folderOf("oslo"), "--mark", "0000 0000 0000 0000 0000"}, 1),
      "has the mark " + mark);
  expectWords(call({"join", file, folderOf("oslo"), "--mark", mark}), "is ready");
  const auto way = CollectProgram::way(database());
  expectWords(call({"push", folderOf("oslo"), "--server", way}), "1 new event sent");
  expectWords(
      call({"revoke", "--study", "realism", "--station", "oslo", "--reason", "stolen"}), "");
  expectWords(call({"push", folderOf("oslo"), "--server", way}, 1), "stolen");
  const auto status = call({"status"});
  expectWords(status, "Refused, the newest first");
  expectWords(status, "station_oslo");
  expectWords(status, "revoked: stolen");
}

TEST_F(CollectProgram, ShowsAnOperatorTheStationsOfTheOwnSiteAlone) {
  for (const auto* site : {"oslo", "bergen"}) {
    addStation(site);
    runSession(site);
    push(site);
  }
  const auto operatorOfOslo = "olav_" + database();
  admin().execute("CREATE ROLE " + operatorOfOslo + " LOGIN IN ROLE operator_oslo");
  const auto said = call({"status", "--server", way(database()) + " user=" + operatorOfOslo});
  expectWords(said, "oslo ");
  EXPECT_EQ(said.find("bergen"), std::string::npos) << said;
  expectWords(call({"status"}), "bergen ");  // the control: the owner sees all
}

/// A push of the program is killed at the n-th call of one system call: what it sends, receives and
/// stores. Pushes that are killed at any time are in collection_test.cpp.
TEST_F(CollectProgram, ThatIsKilledAtASystemCallOfAPushLosesAndDoublesNothing) {
  const auto tried = tests::run({"strace", "-o", scratch_ / "tried", "true"});
  if (tried.status != 0) GTEST_SKIP() << "strace is missing or not permitted: " << tried.error;
  const std::vector<std::string> calls{"sendto", "recvfrom", "poll", "fdatasync", "pwrite64"};
  const int pushes = tests::inLongForm(200, 15);
  addStation("oslo");
  const auto program = std::filesystem::read_symlink("/proc/self/exe").parent_path();
  int killed = 0;
  for (int i = 0; i < pushes; ++i) {
    const auto kind = static_cast<std::size_t>(i) % calls.size();
    if (kind == 0) runSession("oslo");
    const int number = 1 + 7 * i % 23;
    const auto inject = fmt::format("inject={}:signal=KILL:when={}", calls[kind], number);
    const auto finished = tests::run(
        {"strace",
         "-f",
         "-o",
         "/dev/null",
         "-e",
         inject,
         program / "palpate-collect",
         "push",
         folderOf("oslo"),
         "--server",
         way(database()) + " user=station_oslo"},
        {"PALPATE_STATION=" + (scratch_ / "account-oslo"), "ASAN_OPTIONS=detect_leaks=0"});
    if (finished.status != 0) ++killed;
    if (finished.status > 0) EXPECT_EQ(finished.error, "") << inject;
    const auto events = admin().query("SELECT count(*), coalesce(max(seq), 0) FROM palpate.event");
    EXPECT_EQ(events.number(0, 0), events.number(0, 1)) << inject << ": a gap, or one twice";
  }
  EXPECT_GT(killed, pushes / 3) << "the control: pushes were killed";
  EXPECT_NE(contentOfServer(), contentOf({})) << "the control: something had arrived";
  const auto last = push("oslo").lastEvent;
  EXPECT_EQ(admin().query("SELECT count(*) FROM palpate.event").number(0, 0), last);
  EXPECT_EQ(contentOfServer(), contentOf({folderOf("oslo")}));
  EXPECT_EQ(incidents(), std::vector<std::string>());
}

TEST_F(CollectProgram, SaysThatAFolderIsAnOlderCopyAndCountsNothingOfAnother) {
  namespace fs = std::filesystem;
  addStation("oslo");
  const auto folder = folderOf("oslo");
  const auto newest = scratch_ / "newest";
  const auto backup = scratch_ / "backup";
  const auto onStation = [&](const std::string& command, int status) {
    return call({command, folder, "--server", way(database())}, status, "account-oslo");
  };
  runSession("oslo");
  fs::copy(folder, backup, fs::copy_options::recursive);
  runSession("oslo");
  fs::rename(folder, newest);
  fs::rename(backup, folder);
  expectWords(onStation("status", 0), folder + " is an older copy");
  runSession("oslo");
  const auto pushed = onStation("push", 0);
  expectWords(pushed, "2 sessions here, 2 arrived");
  expectWords(pushed, "palpate study restored " + folder);
  expectWords(call({"check", "--reason", "to look"}, 1), "oslo: session 2 is left out");

  fs::rename(folder, backup);
  fs::rename(newest, folder);
  for (const auto* command : {"status", "push", "status"}) {
    const auto said = onStation(command, 1);
    expectWords(said, "Two copies of this study's folder");
    EXPECT_EQ(said.find("arrived,"), std::string::npos) << said;
  }
  expectWords(
      call({"status", folder, "--server", "host=/nowhere"}, 1, "account-oslo"),
      "2 sessions here; which of them arrived is not known");

  fs::rename(folder, newest);
  fs::rename(backup, folder);
  {
    const auto account = accountOf("oslo");
    auto study = study::Study::open(folder, clock_);
    EXPECT_GT(study::recordRestoredCopy(study, "a disk failed"), 0U);
  }
  EXPECT_EQ(onStation("push", 0).find("older copy"), std::string::npos);
  expectWords(call({"check", "--reason", "to look"}), "PASS  oslo: ");
}

TEST_F(CollectProgram, NamesTheVariableOfTheServer) {
  const auto folder = std::filesystem::read_symlink("/proc/self/exe").parent_path();
  for (const std::vector<std::string>& words :
       std::vector<std::vector<std::string>>{{"status"}, {"check", "--reason", "to look"}}) {
    auto call = words;
    call.insert(call.begin(), folder / "palpate-collect");
    const auto finished = tests::run(call, {"PALPATE_SERVER=", "PGHOST=/nowhere"});
    EXPECT_NE(finished.error.find("PALPATE_SERVER"), std::string::npos) << finished.error;
  }
}

TEST_F(CollectProgram, SaysWhatTheServersLogIsMissing) {
  const auto protocol = scratch_.write("protocol.json", tests::shortProtocol());
  const std::vector<std::string> words{"init", "--study", "realism", "--protocol", protocol};
  EXPECT_EQ(call(words).find("log_line_prefix"), std::string::npos);
  admin().execute("ALTER DATABASE " + database() + " SET log_statement = 'all'");
  expectWords(call(words), "log_parameter_max_length = 0");
  admin().execute("ALTER DATABASE " + database() + " SET log_parameter_max_length = 0");
  EXPECT_EQ(call(words).find("log_parameter_max_length"), std::string::npos);
  admin().execute("ALTER DATABASE " + database() + " SET log_min_error_statement = 'panic'");
  expectWords(call(words), "postgresql.conf: log_min_error_statement = error.\n");
}

TEST_F(CollectProgram, NamesEachSettingThatADebianServersLogIsMissing) {
  using study::collect::Connection;
  study::collect::PrivateServer debian(study::collect::PrivateServer::Disk::WithoutFsync);
  debian.set("log_line_prefix", "%m [%p] %q%u@%d ");
  debian.set("log_connections", "off");
  debian.stop();
  debian.start();
  expectWords(
      call({"init", "--server", debian.server()}),
      "postgresql.conf: log_line_prefix = '%m [%p] %q%u@%d %h ', log_connections = on.\n");
}

TEST_F(CollectProgram, InitTakesFromAllRolesWhatFillsTheServersDisk) {
  addStation("oslo");
  const std::vector<std::string> statements{
      "CREATE TEMPORARY TABLE large ()",
      "SELECT lo_creat(1)",
      "SELECT lo_create(0)",
      "SELECT lo_from_bytea(0, '')"};
  auto station = as("station_oslo");
  for (const auto& statement : statements) station.execute(statement);  // the control
  admin().execute(fmt::format(
      "CREATE ROLE guest_{0} LOGIN IN ROLE palpate_owner; GRANT CREATE ON DATABASE {0} TO "
      "guest_{0}",
      database()));
  const auto asGuest = way(database()) + " user=guest_" + database();
  expectWords(call({"init", "--server", asGuest}), "can fill the server's disk");
  EXPECT_EQ(call({"init"}).find("can fill"), std::string::npos);
  EXPECT_EQ(call({"init", "--server", asGuest}).find("can fill"), std::string::npos);
  for (const auto& statement : statements) {
    EXPECT_THROW(station.execute(statement), study::collect::ServerError) << statement;
  }
  push("oslo");  // needs none of it
}

TEST_F(CollectProgram, SaysThatAProtocolIsThereAlready) {
  const auto protocol = scratch_.write("protocol.json", tests::shortProtocol());
  const std::vector<std::string> words{"init", "--study", "realism", "--protocol", protocol};
  expectWords(call(words), "is on the server");
  const auto said = call(words);
  expectWords(said, "'realism' has this version of");
  EXPECT_EQ(said.find("amend"), std::string::npos) << said;
}

TEST_F(CollectProgram, BringsABundleToTheServerAndEverythingBack) {
  const std::string oslo = "account-oslo";
  const auto folder = folderOf("oslo");
  const auto file = scratch_ / "oslo.enrol";
  auto key = call({"key"}, 0, oslo);
  key.pop_back();
  call({"init", "--station", file, "--site", "oslo", "--key", key});
  call({"join", file, folder}, 0, oslo);
  const auto code = runSession("oslo");
  simulate("oslo", 2);
  const auto bundle = scratch_ / "oslo.bundle";
  expectWords(call({"bundle", folder, "--out", bundle}, 0, oslo), "sealed for the server's");
  call({"bundle", folder, "--out", bundle}, 1, oslo);  // it is there already
  expectWords(call({"ingest", bundle}), " new events. The server has all events of 'oslo' up to");
  expectWords(
      call({"ingest", bundle}), "Nothing in it is new. The server has all events of 'oslo' up to");
  call({"ingest", scratch_.write("none", "no bundle")}, 1);
  expectWords(
      call({"status", folder, "--server", way(database())}, 0, oslo), "3 sessions here, 3 arrived");
  expectWords(call({"check", "--reason", "to look"}), "PASS  oslo: ");
  call({"check"}, 2);  // a reason is required
  const auto all = scratch_ / "all";
  expectWords(
      call({"pull", "--out", all, "--reason", "to evaluate"}, 0, "account-analyst"),
      "3 sessions of 1 station");
  expectWords(call({"pull", "--out", all, "--reason", "again"}, 1), "is there already");
  EXPECT_EQ(contentOf({all}), contentOf({folder}));
  const std::vector<std::string> stats{
      "stats", "--reason", "to evaluate", "--run-mode", "simulated"};
  expectWords(call(stats), "Surgeons: 1 enrolled, 1 completed");
  expectWords(call({"stats", "--reason", "x", "--no-such-option"}, 1), "--no-such-option");

  // What was changed on the server is said, and left out.
  admin().execute(
      "UPDATE palpate.session AS s SET facts = x.facts, sha256 = sha256(convert_to(x.facts, "
      "'UTF8')) FROM (SELECT replace(facts, '\"language\":\"en\"', '\"language\":\"de\"') AS "
      "facts, number FROM palpate.session) AS x WHERE x.number = 1 AND s.number = 1");
  expectWords(call({"check", "--reason", "to look"}, 1), "FAIL  oslo: ");
  const auto said = call({"pull", "--out", scratch_ / "less", "--reason", "to evaluate"}, 1);
  expectWords(said, "oslo: session 1 is left out: its rows do not agree with the audit trail");
  expectWords(said, "2 sessions of 1 station");
  expectWords(call(stats, 1), "session 1 is left out");
  expectWords(
      call({"set-aside", "--station", "oslo", "--reason", "rows were changed"}), "is set aside");
  expectWords(
      call({"push", folder, "--server", way(database())}, 0, oslo), "3 sessions here, 3 arrived");
  expectWords(call({"status"}), "set aside");
  expectWords(call({"check", "--reason", "to look"}), "PASS  oslo: ");

  // An erasure is answered with a receipt.
  {
    const auto account = accountOf("oslo");
    auto study = study::Study::open(folder, clock_);
    study::erase(study, {.participant = code, .reason = "asked for it"});
  }
  const auto receipt = "erased on the server: session 1 of " + code;
  expectWords(call({"push", folder, "--server", way(database())}, 0, oslo), receipt);
  expectWords(call({"status", folder, "--server", way(database())}, 0, oslo), receipt);
}

TEST_F(CollectProgram, DemonstratesAllOfItOnThisComputerAlone) {
  const auto out = scratch_ / "sites";
  environment_ = {"PGPORT=54321"};  // of another server
  const auto said = call({"demo", "--out", out, "--participants", "1"});
  expectWords(said, "has 4 sessions of 4 stations, and is sound");
  const auto report = tests::contentOf(out + "/report.html");
  for (const auto* site : {"oslo", "bergen", "tromso"}) {
    EXPECT_NE(report.find(site), std::string::npos) << site;
  }
  expectWords(call({"demo", "--out", out}, 1), "is there already");
  EXPECT_TRUE(std::filesystem::exists(out + "/report.html"));
}

TEST_F(CollectProgram, LeavesNothingOfADemonstrationThatFails) {
  const auto out = scratch_ / "sites";
  environment_ = {"PATH=/nowhere"};  // no server can be started
  call({"demo", "--out", out}, 1);
  EXPECT_FALSE(std::filesystem::exists(out));
}

}  // namespace program_test
