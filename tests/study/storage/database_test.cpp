#include "study/storage/database.h"

#include <unistd.h>

#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>

#include "study/model/user_error.h"
#include "study/storage/statement.h"
#include "study/storage/study_schema.h"
#include "tests/study/made_study.h"
#include "tests/study/storage/refusals.h"
#include "tests/study/storage/sql.h"
#include "tests/study/walk.h"

namespace study::storage {
namespace database_test {

namespace fs = std::filesystem;
using Access = Database::Access;
using Kind = StorageError::Kind;
using tests::expectClear;
using tests::refusalOf;

std::string pragma(Database& database, const std::string& name) {
  Statement statement(database, "PRAGMA " + name);
  return statement.step() ? statement.text(0) : std::string();
}

TEST(Database, HasDurableSettings) {
  tests::MadeStudy study;
  auto recorder = study->openTraces();  // the recorder thread's connection
  for (auto* database :
       {&study->database(),
        &study->traces().database(),
        &study->identities().database(),
        &recorder.database()}) {
    SCOPED_TRACE(database->path());
    EXPECT_EQ(pragma(*database, "journal_mode"), "wal");
    EXPECT_EQ(pragma(*database, "synchronous"), "2");  // FULL
    EXPECT_EQ(pragma(*database, "foreign_keys"), "1");
    EXPECT_EQ(pragma(*database, "trusted_schema"), "0");
    EXPECT_EQ(pragma(*database, "cell_size_check"), "1");
    EXPECT_EQ(pragma(*database, "mmap_size"), "0");
  }
}

TEST(Database, CompilesAStatementOnce) {
  const auto database = Database::inMemory(studySchema());
  auto* first = database.compiled("SELECT ?");
  database.giveBack(first);
  auto* second = database.compiled("SELECT ?");
  EXPECT_EQ(second, first);
  database.giveBack(second);
}

TEST(Database, GivesAStatementWithoutTheValuesOfTheLastUse) {
  const auto database = Database::inMemory(studySchema());
  {
    Statement first(database, "SELECT ?");
    first.bind(1, std::int64_t{5});
    ASSERT_TRUE(first.step());
  }
  Statement second(database, "SELECT ?");
  Statement third(database, "SELECT ?");  // of the same text, and at the same time
  third.bind(1, std::int64_t{6});
  ASSERT_TRUE(second.step());
  ASSERT_TRUE(third.step());
  EXPECT_TRUE(second.isNull(0));
  EXPECT_EQ(third.number(0), 6);
  EXPECT_FALSE(second.step());
}

TEST(Database, BindsAllParametersInTheirOrder) {
  const auto database = Database::inMemory(studySchema());
  Statement row(database, "SELECT ?, ?, ?, ?, ?, ?, ?");
  const VisitKey visit{.session = SessionId{7}, .step = 2, .attempt = 3};
  row.bindAll(true, visit, "text", 0.5, std::optional<std::string>());
  ASSERT_TRUE(row.step());
  EXPECT_EQ(row.number(0), 1);
  EXPECT_EQ(row.number(1), 7);
  EXPECT_EQ(row.number(2), 2);
  EXPECT_EQ(row.number(3), 3);
  EXPECT_EQ(row.text(4), "text");
  EXPECT_EQ(row.real(5), 0.5);
  EXPECT_TRUE(row.isNull(6));
}

TEST(Database, CanBeChangedAndVacuumedAfterAStatementThatDidNotReadToTheEnd) {
  auto database = Database::inMemory(studySchema());
  database.execute("CREATE TABLE note (words TEXT); INSERT INTO note VALUES ('a'), ('b')");
  const auto columns = [&] {
    Statement select(database, "SELECT * FROM note ORDER BY rowid");
    return select.step() ? select.columnCount() : 0;
  };
  EXPECT_EQ(columns(), 1);
  database.execute("ALTER TABLE note ADD COLUMN author TEXT; VACUUM");
  EXPECT_EQ(columns(), 2);
  database.execute("DROP TABLE note");
  EXPECT_THROW(columns(), StorageError);
}

TEST(Database, NeverOverwritesAFile) {
  const tests::ScratchFolder folder;
  const auto file = folder.write("study.db", "a diary");
  const auto refusal = refusalOf([&] { Database::create(file, studySchema()); });
  expectClear(refusal, "study.db is there already");
  EXPECT_EQ(tests::contentOf(file), "a diary");
}

TEST(Database, NeedsAnExistingFolder) {
  const tests::ScratchFolder folder;
  const auto refusal = refusalOf([&] { Database::create(folder / "no/study.db", studySchema()); });
  expectClear(refusal, "Check that the folder exists");
}

class OpeningTest : public testing::Test {
 protected:
  tests::Refusal opening(Access access = Access::ReadWrite) {
    study_.close();
    return refusalOf([&] { Study::open(study_.folder(), study_.clock, access); });
  }

  /// A study.db with content, complete, without a log.
  void SetUp() override {
    {
      auto session = Session::enrol(*study_, {.cohort = "surgeons"});
      tests::walkToTheEnd(session);
    }
    study_.close();
  }

  tests::MadeStudy study_;
};

TEST_F(OpeningTest, AMissingFolder) {
  const auto refusal = refusalOf([&] { Study::open(study_.file("elsewhere"), study_.clock); });
  expectClear(refusal, "palpate study create");
}

TEST_F(OpeningTest, AFileInPlaceOfTheFolder) {
  const auto file = study_.scratch().write("file", "text");
  expectClear(refusalOf([&] { Study::open(file, study_.clock); }), "There is no study in");
}

TEST_F(OpeningTest, AFolderWithoutAStudy) {
  const auto refusal = refusalOf([&] { Study::open(study_.scratch().path(), study_.clock); });
  expectClear(refusal, "study.db");
}

TEST_F(OpeningTest, AForeignDatabase) {
  fs::remove(study_.file("study.db"));
  tests::Sql(study_.file("study.db")).run("CREATE TABLE song (title TEXT)");
  const auto refusal = opening();
  EXPECT_EQ(refusal.kind, Kind::Damaged);
  expectClear(refusal, "not a palpate study");
}

TEST_F(OpeningTest, TheTracesInPlaceOfTheStudy) {
  fs::copy_file(
      study_.file("traces.db"), study_.file("study.db"), fs::copy_options::overwrite_existing);
  expectClear(opening(), "not a palpate study");
}

TEST_F(OpeningTest, AFileThatIsNoDatabase) {
  for (const auto& content : {std::string(5000, 'x'), std::string("SQLite format 3\0", 16)}) {
    std::ofstream(study_.file("study.db"), std::ios::binary | std::ios::trunc) << content;
    const auto refusal = opening();
    EXPECT_EQ(refusal.kind, Kind::Damaged) << refusal.words;
    expectClear(refusal, "study.db");
  }
}

TEST_F(OpeningTest, AnEmptyFile) {
  fs::resize_file(study_.file("study.db"), 0);
  for (const auto access : {Access::ReadWrite, Access::ReadOnly}) {
    const auto refusal = opening(access);
    EXPECT_EQ(refusal.kind, Kind::Damaged);
    expectClear(refusal, "Restore it from a copy");
  }
}

TEST_F(OpeningTest, ATruncatedFile) {
  const auto size = fs::file_size(study_.file("study.db"));
  const auto whole = study_.scratch() / "whole.db";
  fs::copy_file(study_.file("study.db"), whole);
  for (const auto part : {size / 2, size - 4096, std::uintmax_t{4096}, std::uintmax_t{5000}}) {
    fs::copy_file(whole, study_.file("study.db"), fs::copy_options::overwrite_existing);
    fs::resize_file(study_.file("study.db"), part);
    const auto refusal = opening();
    EXPECT_EQ(refusal.kind, Kind::Damaged) << refusal.words;
    expectClear(refusal, "damaged");
  }
}

TEST_F(OpeningTest, ANewerFormatChangesNothing) {
  tests::Sql(study_.file("study.db")).run("PRAGMA user_version = 99; PRAGMA journal_mode = DELETE");
  const auto before = tests::contentOf(study_.file("study.db"));
  for (const auto access : {Access::ReadWrite, Access::ReadOnly}) {
    const auto refusal = opening(access);
    EXPECT_EQ(refusal.kind, Kind::Newer);
    expectClear(refusal, "newer version of palpate");
  }
  EXPECT_EQ(tests::contentOf(study_.file("study.db")), before);
}

TEST_F(OpeningTest, AnUnfinishedStudy) {
  fs::remove(study_.file("study.db"));
  fs::remove(study_.file("traces.db"));
  Database::create(study_.file("study.db"), studySchema());
  const auto refusal = opening();
  EXPECT_EQ(refusal.kind, Kind::Damaged);
  expectClear(refusal, "was not finished when it was made");
}

TEST_F(OpeningTest, AFolderThatMayNotBeRead) {
  constexpr uid_t kNobody = 65534;
  const auto own = geteuid();
  fs::permissions(study_.scratch().path(), fs::perms::none);
  if (own == 0) ASSERT_EQ(seteuid(kNobody), 0) << "root may read everything";
  const auto folder = opening();
  const auto file =
      refusalOf([&] { Database::open(study_.file("study.db"), studySchema(), Access::ReadOnly); });
  if (own == 0) ASSERT_EQ(seteuid(own), 0);
  fs::permissions(study_.scratch().path(), fs::perms::owner_all);
  expectClear(folder, "Permission denied");
  expectClear(file, "Permission denied");
}

TEST_F(OpeningTest, AFileThatMayNotBeReadInAFolderThatMay) {
  constexpr uid_t kNobody = 65534;
  const auto own = geteuid();
  fs::permissions(study_.scratch().path(), fs::perms::all);
  fs::permissions(study_.folder(), fs::perms::all);
  fs::permissions(study_.file("study.db"), fs::perms::none);
  if (own == 0) ASSERT_EQ(seteuid(kNobody), 0) << "root may read everything";
  const auto refusal = opening();
  if (own == 0) ASSERT_EQ(seteuid(own), 0);
  expectClear(refusal, "This account may not use it");
  EXPECT_EQ(refusal.words.find("folder exists"), std::string::npos) << refusal.words;
}

TEST(Database, SaysThatAPathIsTooLong) {
  const tests::ScratchFolder scratch;
  fs::path folder = scratch.path();
  while (folder.string().size() < 512) folder /= std::string(100, 'a');
  fs::create_directories(folder);
  const auto refusal = refusalOf([&] { Database::create(folder / "study.db", studySchema()); });
  expectClear(refusal, "path is too long");
}

TEST_F(OpeningTest, AStudyWithoutItsTraces) {
  fs::remove(study_.file("traces.db"));
  expectClear(opening(), "traces.db");
}

TEST_F(OpeningTest, AStudyWithUnknownRandomNumbers) {
  tests::Sql(study_.file("study.db")).run("UPDATE study SET random_version = 2");
  const auto refusal = opening();
  EXPECT_EQ(refusal.kind, Kind::Newer);
  expectClear(refusal, "Install the version that made it");
}

TEST_F(OpeningTest, AStudyWhoseSeedIsNoNumber) {
  for (const std::string seed : {"", "12 34", "seed", "18446744073709551616"}) {
    tests::Sql(study_.file("study.db")).run("UPDATE study SET seed = '" + seed + "'");
    const auto refusal = opening();
    EXPECT_EQ(refusal.kind, Kind::Damaged);
    expectClear(refusal, "study.db is damaged: the seed of its orders is '" + seed + "'");
  }
}

TEST(Transaction, RollsBackUncommittedChanges) {
  auto database = Database::inMemory(identitySchema());
  const std::string row =
      "INSERT INTO identifying_answer VALUES ('P001', 1, 0, 1, 'name', 'x', '', NULL, NULL)";
  {
    Transaction transaction(database);
    database.execute(row);
  }
  Statement count(database, "SELECT count(*) FROM identifying_answer");
  ASSERT_TRUE(count.step());
  EXPECT_EQ(count.number(0), 0);
}

TEST(Study, IsNeverMadeInAnExistingFolder) {
  const tests::ScratchFolder folder;
  SimulatedClock clock;
  const auto protocol = tests::protocolFrom(tests::shortProtocol());
  folder.write("study/notes.txt", "mine");
  const auto refusal = refusalOf([&] { Study::create(folder / "study", protocol, clock); });
  expectClear(refusal, "is there already");
  EXPECT_EQ(tests::contentOf(folder / "study/notes.txt"), "mine");
  EXPECT_THROW(Study::create("", protocol, clock), UserError);
  folder.write("file", "mine");
  expectClear(refusalOf([&] { Study::create(folder / "file", protocol, clock); }), "is there");
  expectClear(
      refusalOf([&] { Study::create(folder / "file/study", protocol, clock); }), "cannot be made");
}

TEST(Study, HasANameThatDependsOnSecretSeedAndProtocol) {
  tests::MadeStudy a(tests::protocolFrom(tests::shortProtocol()), 5);
  tests::MadeStudy b(tests::protocolFrom(tests::shortProtocol()), 5);
  tests::MadeStudy c(tests::protocolFrom(tests::shortProtocol()), 6);
  EXPECT_EQ(a->uuid(), b->uuid());
  EXPECT_NE(a->uuid(), c->uuid());
  EXPECT_EQ(a->seed(), 5U);
  a.reopen();
  EXPECT_EQ(a->seed(), 5U);
  EXPECT_EQ(a->uuid(), b->uuid());
}

TEST(Study, KeepsItsProtocolIfTheFilesAreDeleted) {
  const auto protocol = tests::libraryProtocol("punch-counterbalanced");
  tests::MadeStudy study(protocol);
  study.reopen();
  EXPECT_EQ(study->protocol().text, protocol.text);
  EXPECT_EQ(study->protocol().protocol.study.title, protocol.protocol.study.title);
  EXPECT_EQ(study->protocol().instruments.size(), protocol.instruments.size());
}

}  // namespace database_test
}  // namespace study::storage
