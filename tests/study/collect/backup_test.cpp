// A server that was lost, and one made out of its backup: docs/collecting.md, "Backups".
#include <filesystem>

#include "study/collect/exchange/pull.h"
#include "study/session/verification.h"
#include "tests/study/collect/collected_study_at.h"
#include "tests/support/child_process.h"

namespace backup_test {

using study::collect::Connection;
using study::collect::PrivateServer;

class Backups : public tests::CollectTest {
 protected:
  /// Runs one of PostgreSQL's own programs on a server.
  static tests::Finished finished(
      const PrivateServer& server,
      const std::string& name,
      std::vector<std::string> arguments,
      const std::string& user) {
    std::filesystem::path newest;
    for (const auto& entry : std::filesystem::directory_iterator("/usr/lib/postgresql")) {
      if (std::filesystem::exists(entry.path() / "bin" / name)) newest = entry.path() / "bin";
    }
    arguments.insert(arguments.begin(), newest / name);
    return tests::run(
        arguments,
        {"PGHOST=" + server.folder().string(),
         "PGPORT=" + std::to_string(server.port()),
         "PGUSER=" + user});
  }

  static void run(
      const PrivateServer& server,
      const std::string& name,
      const std::vector<std::string>& arguments,
      const std::string& user = "postgres") {
    const auto finished = Backups::finished(server, name, arguments, user);
    ASSERT_EQ(finished.status, 0) << name << ": " << finished.error;
  }
};

TEST_F(Backups, ADumpAndItsRolesMakeTheSameServerElsewhere) {
  addStation("oslo");
  addStation("bergen");
  simulate("oslo", 1);
  runSession("bergen");
  push("oslo");
  push("bergen");
  // By an account that is no superuser, even if a station left objects in the database.
  const auto keeper = "keeper_" + database();
  admin().execute("CREATE ROLE " + keeper + " LOGIN IN ROLE palpate_owner");
  as("station_oslo").execute("SELECT lo_creat(1)");
  const std::vector<std::string> whole{
      "--format=custom", "--file", scratch_ / "study.dump", database()};
  EXPECT_NE(finished(postgres(), "pg_dump", whole, keeper).status, 0) << "the control";
  auto ofSchema = whole;
  ofSchema.emplace_back("--schema=palpate");
  run(postgres(), "pg_dump", ofSchema, keeper);
  const auto roles = scratch_ / "roles.sql";
  run(postgres(), "pg_dumpall", {"--roles-only", "--no-role-passwords", "--file", roles}, keeper);

  const PrivateServer other(PrivateServer::Disk::WithoutFsync);
  // The superuser is there already, which psql says and passes over.
  run(other, "psql", {"--quiet", "--file", roles, "postgres"});
  run(other, "createdb", {"study"});
  run(other, "pg_restore", {"--exit-on-error", "--dbname", "study", scratch_ / "study.dump"});

  const auto owner = other.server("study");
  {
    Connection server(owner);
    const auto account = accountOf("analyst");
    study::collect::pull(server, {.folder = scratch_ / "restored", .reason = "to compare"}, clock_);
    auto pulled = study::Study::open(
        scratch_ / "restored", clock_, study::storage::Database::Access::ReadOnly);
    EXPECT_TRUE(study::verify(pulled).isSound());
  }
  EXPECT_EQ(contentOf({scratch_ / "restored"}), contentOf({folderOf("oslo"), folderOf("bergen")}));
  // The stations find their roles there, and nothing else.
  Connection station(owner, "station_oslo");
  EXPECT_THROW(station.query("SELECT * FROM palpate.answer"), study::collect::ServerError);
}

TEST_F(Backups, WhatCameAfterTheDumpIsSentAgain) {
  addStation("oslo");
  simulate("oslo", 1);
  push("oslo");
  run(postgres(),
      "pg_dump",
      {"--schema=palpate", "--format=custom", "--file", scratch_ / "study.dump", database()});
  runSession("oslo");
  push("oslo");

  const auto older = database() + "_older";
  run(postgres(), "createdb", {older});
  run(postgres(), "pg_restore", {"--exit-on-error", "--dbname", older, scratch_ / "study.dump"});
  const auto sent = pushOver("oslo", postgres().server(older));
  EXPECT_LT(sent.before, sent.lastEvent);
  const auto account = accountOf("analyst");
  Connection server(postgres().server(older));
  study::collect::pull(server, {.folder = scratch_ / "union", .reason = "to compare"}, clock_);
  EXPECT_EQ(contentOf({scratch_ / "union"}), contentOf({folderOf("oslo")}));
}

}  // namespace backup_test
