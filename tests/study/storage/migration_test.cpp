// Studies of older formats can be continued.
#include <algorithm>
#include <filesystem>

#include <gtest/gtest.h>

#include "study/results/results_text.h"
#include "study/session/verification.h"
#include "study/storage/identity_store.h"
#include "study/storage/records.h"
#include "study/storage/study_schema.h"
#include "tests/study/made_study.h"
#include "tests/study/storage/refusals.h"
#include "tests/study/storage/sql.h"
#include "tests/study/walk.h"
#include "tests/support/test_data.h"

namespace study::storage {
namespace migration_test {

using Access = Database::Access;

/// A study of format 1, made by palpate 0.1.0 on 2026-11-21, with an unfinished live session.
class FormatOneTest : public testing::Test {
 protected:
  void SetUp() override {
    std::filesystem::create_directory(folder_);
    tests::Sql study(folder_ + "/study.db");
    study.run(
        tests::contentOf((tests::repository() / "tests/study/data/study-format-1.sql").string()));
    study.run("PRAGMA application_id = 0x50616c53; PRAGMA user_version = 1");
    Database::create(folder_ + "/traces.db", traceSchema());
    Database::create(folder_ + "/identity.db", identitySchema());
  }

  std::int64_t format() { return tests::Sql(folder_ + "/study.db").number("PRAGMA user_version"); }

  tests::ScratchFolder scratch_;
  std::string folder_ = scratch_ / "old";
  SimulatedClock clock_{1'795'300'000'000};  // 2026-11-21, later
};

TEST_F(FormatOneTest, IsConvertedWhenItIsOpenedWithoutLoss) {
  auto study = Study::open(folder_, clock_);
  EXPECT_EQ(format(), 10);
  EXPECT_EQ(study.seed(), 42U);
  const auto answers = Records(study.database()).answers();
  ASSERT_EQ(answers.size(), 2U);
  EXPECT_EQ(answers[0].answer.response, questionnaires::Response(std::string("yes")));
  EXPECT_EQ(answers[1].answer.response, questionnaires::Response(std::int64_t{4}));
  EXPECT_TRUE(study.protocols().current().frozenUtc);
  EXPECT_TRUE(verify(study).isSound());
}

TEST_F(FormatOneTest, KeepsTheQuestionNumbersThatFormatThreeWrote) {
  const auto file = folder_ + "/study.db";
  const Schema now = studySchema();
  {
    const Schema four{now.applicationId, now.name, now.steps.first(4)};
    Database::open(file, four, Access::ReadWrite);
  }
  const auto numbered = [&] {
    return tests::Sql(file).text("SELECT group_concat(item || '=' || question) FROM answer") +
           tests::Sql(file).text("SELECT group_concat(id || kind || phase || item) FROM question");
  };
  const auto before = numbered();
  EXPECT_NE(before.find("presence="), std::string::npos) << before;
  auto study = Study::open(folder_, clock_);
  EXPECT_EQ(numbered(), before);
  EXPECT_EQ(
      tests::Sql(file).number(
          "SELECT count(*) FROM sqlite_master WHERE type IN ('trigger', 'index') "
          "AND sql LIKE '%question%'"),
      0);
  EXPECT_TRUE(verify(study).isSound());
}

TEST_F(FormatOneTest, GetsCopiesOfTheLibrarysFormsOnceThoughItsProtocolIsFrozen) {
  const auto hash = tests::Sql(folder_ + "/study.db").text("SELECT sha256 FROM protocol");
  const auto kinds = [](Study& study) {
    std::string all;
    for (const auto& event : study.events().read()) all.append(event.name()).append(" ");
    return all;
  };
  std::string after;
  {
    auto study = Study::open(folder_, clock_);
    const auto stored = study.protocols().current();
    EXPECT_TRUE(stored.areFormsAdded);
    EXPECT_EQ(stored.sha256, hash);
    EXPECT_EQ(
        std::count_if(
            stored.files.begin(),
            stored.files.end(),
            [](const auto& file) { return file.name.starts_with(protocols::kLibraryCopyPrefix); }),
        static_cast<std::ptrdiff_t>(study.protocol().instruments.size()));
    after = kinds(study);
    EXPECT_NE(after.find(" copied_forms "), std::string::npos) << after;
    EXPECT_TRUE(verify(study).isSound());
  }
  auto study = Study::open(folder_, clock_);
  EXPECT_EQ(kinds(study), after);
  EXPECT_THROW(
      study.database().execute(
          "INSERT INTO protocol_file VALUES (1, 'palpate-library/debrief.json', '', '')"),
      StorageError);
  study.database().execute(
      "DROP TRIGGER a_frozen_file_stays_as_it_is; UPDATE protocol_file SET text = text || ' '");
  EXPECT_FALSE(verify(study).isSound());
}

TEST_F(FormatOneTest, IsNotOpenedForReadingOnly) {
  const auto refusal = tests::refusalOf([&] { Study::open(folder_, clock_, Access::ReadOnly); });
  tests::expectClear(refusal, "Open the study once for writing");
  EXPECT_EQ(format(), 1);
}

TEST_F(FormatOneTest, ContinuesItsSessionAndHashesContentFromThenOn) {
  auto study = Study::open(folder_, clock_);
  auto session = Session::resume(study, SessionId{1});
  EXPECT_EQ(session.step().kind, StepKind::Trial);
  tests::walkToTheEnd(session);
  EXPECT_TRUE(verify(study).isSound());
  study.database().execute("UPDATE answer SET first_touch_s = 0 WHERE item = 'presence'");
  EXPECT_FALSE(verify(study).isSound());
}

TEST_F(FormatOneTest, HasTheConstraintsOfTheNewFormat) {
  auto study = Study::open(folder_, clock_);
  EXPECT_THROW(study.database().execute("UPDATE protocol SET frozen_utc = NULL"), StorageError);
  EXPECT_THROW(
      study.database().execute("REPLACE INTO event SELECT * FROM event WHERE seq = 2"),
      StorageError);
}

TEST_F(FormatOneTest, StaysUnchangedIfTheConversionFails) {
  // A table of the same name as one that the new format adds.
  tests::Sql(folder_ + "/study.db")
      .run(
          "CREATE TRIGGER a_frozen_protocol_is_not_removed BEFORE DELETE ON protocol BEGIN SELECT "
          "1; END");
  const std::string before =
      tests::Sql(folder_ + "/study.db").text("SELECT group_concat(sql) FROM sqlite_master");
  EXPECT_THROW(Study::open(folder_, clock_), StorageError);
  EXPECT_EQ(format(), 1);
  EXPECT_EQ(
      tests::Sql(folder_ + "/study.db").text("SELECT group_concat(sql) FROM sqlite_master"),
      before);
}

/// Writes a copy of a study in an older format, with what that format has of its columns.
void writeAsFormat(std::size_t format, const std::string& from, const std::string& to) {
  const Schema now = studySchema();
  Database::create(to, {now.applicationId, now.name, now.steps.first(format)});
  tests::Sql sql(to);
  sql.run("ATTACH '" + from + "' AS now");
  for (const std::string table :
       {"study",
        "protocol_file",
        "protocol",
        "participant",
        "session",
        "step",
        "allocation",
        "visit",
        "answer",
        "trial",
        "cut",
        "event"}) {
    const auto columns =
        sql.text("SELECT group_concat(name) FROM pragma_table_info('" + table + "', 'main')");
    sql.run(
        "INSERT INTO main." + table + " (" + columns + ") SELECT " + columns + " FROM now." +
        table + " ORDER BY rowid");
  }
}

void makeOld(const tests::MadeStudy& made, std::size_t format) {
  writeAsFormat(format, made.file("study.db"), made.file("old.db"));
  for (const char* rest : {"-wal", "-shm"}) {
    std::filesystem::remove(made.file("study.db") + rest);
    std::filesystem::remove(made.file("old.db") + rest);
  }
  std::filesystem::rename(made.file("old.db"), made.file("study.db"));
}

/// As older releases stored it: without copies of the library's forms.
protocols::LoadedProtocol withoutCopies() {
  auto protocol = tests::protocolFrom(tests::shortProtocol());
  protocol.files.clear();
  return protocol;
}

class OlderFormat : public testing::TestWithParam<std::size_t> {};

TEST_P(OlderFormat, GivesTheSameResultsAndGoesOn) {
  constexpr std::size_t kSealsTrials = 8;
  tests::MadeStudy made(withoutCopies());
  const auto takePart = [&](const char* cohort, RunMode mode) {
    auto session = Session::enrol(*made, {.cohort = cohort, .runMode = mode});
    tests::walkToTheEnd(session);
  };
  const auto results = [&](RunMode mode) {
    return resultsAsText(*made, computeResults(*made, mode), {});
  };
  for (const char* cohort : {"surgeons", "students", "surgeons", "students"}) {
    takePart(cohort, RunMode::Simulated);  // of whom nothing is sealed, as in the first formats
    if (GetParam() >= kSealsTrials) takePart(cohort, RunMode::Live);
  }
  const auto simulated = results(RunMode::Simulated);
  const auto live = results(RunMode::Live);
  made.close();
  makeOld(made, GetParam());
  const auto format = [&] {
    return tests::Sql(made.file("study.db")).number("PRAGMA user_version");
  };
  EXPECT_EQ(format(), static_cast<std::int64_t>(GetParam()));
  made.reopen();
  EXPECT_EQ(format(), 10);
  EXPECT_EQ(results(RunMode::Simulated), simulated);
  EXPECT_EQ(results(RunMode::Live), live);
  takePart("surgeons", RunMode::Live);
  EXPECT_TRUE(verify(*made).isSound());
}

INSTANTIATE_TEST_SUITE_P(FromTwoOn, OlderFormat, testing::Range<std::size_t>(2, 10));

TEST(FormatThree, IsReadWithoutBeingWritten) {
  tests::MadeStudy made;
  made.close();
  makeOld(made, 3);
  SimulatedClock clock;
  auto study = Study::open(made.folder(), clock, Access::ReadOnly);
  EXPECT_TRUE(verify(study).isSound());
  EXPECT_EQ(tests::Sql(made.file("study.db")).number("PRAGMA user_version"), 3);
}

TEST(Schema, IsTheSameForNewAndConvertedStudies) {
  tests::ScratchFolder folder;
  const Schema first{studySchema().applicationId, studySchema().name, studySchema().steps.first(1)};
  Database::create(folder / "old.db", first);
  Database::open(folder / "old.db", studySchema(), Access::ReadWrite);
  Database::create(folder / "new.db", studySchema());
  const char* all = "SELECT group_concat(type || name || sql) FROM sqlite_master";
  EXPECT_EQ(tests::Sql(folder / "old.db").text(all), tests::Sql(folder / "new.db").text(all));
}

TEST(Identities, OfFormatTwoHaveNoSecretAndAreReadAsTheyAre) {
  const tests::ScratchFolder folder;
  const auto file = folder / "identity.db";
  const Schema now = identitySchema();
  Database::create(file, {now.applicationId, now.name, now.steps.first(2)});
  EXPECT_FALSE(IdentityStore(Database::open(file, now, Access::ReadOnly)).blindingSecret());
  EXPECT_EQ(tests::Sql(file).number("PRAGMA user_version"), 2);
  EXPECT_FALSE(IdentityStore(Database::open(file, now, Access::ReadWrite)).blindingSecret());
  EXPECT_EQ(tests::Sql(file).number("PRAGMA user_version"), 6);
}

TEST(Identities, OfFormatOneAreKeptAndLaterOnesHaveAHash) {
  tests::ScratchFolder folder;
  const auto file = folder / "identity.db";
  const Schema now = identitySchema();
  Database::create(file, {now.applicationId, now.name, now.steps.first(1)});
  tests::Sql(file).run(
      "INSERT INTO identifying_answer VALUES ('P001', 1, 0, 1, 'name', 'A. Name', 'earlier')");
  IdentityStore store(Database::open(file, now, Access::ReadWrite));
  EXPECT_TRUE(store.has({"P001", 1, 0, 1}, "name"));
  store.put({"P002", 1, 0, 1}, "name", "Another", "later");
  EXPECT_TRUE(store.damaged().empty());
  tests::Sql(file).run("UPDATE identifying_answer SET text = 'X'");
  EXPECT_EQ(store.damaged(), std::vector<std::string>{"P002, name"});
}

}  // namespace migration_test
}  // namespace study::storage
