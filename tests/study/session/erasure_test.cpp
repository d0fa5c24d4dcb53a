#include "study/session/erasure.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <limits>
#include <utility>

#include <gtest/gtest.h>

#include "study/export/export.h"
#include "study/model/user_error.h"
#include "study/results/results.h"
#include "study/session/unblinding.h"
#include "study/session/verification.h"
#include "study/storage/hasher.h"
#include "study/storage/records.h"
#include "tests/study/everything_instrument.h"
#include "tests/study/made_study.h"
#include "tests/study/session/erasure_fixture.h"
#include "tests/study/storage/faults.h"
#include "tests/study/storage/sql.h"
#include "tests/study/walk.h"
#include "tests/support/long_form.h"
#include "tests/support/test_data.h"

namespace study {
namespace erasure_test {

TEST_F(ErasureTest, LeavesNothingThatTheParticipantWrote) {
  // The control: it is there before, in answers and reasons. Events and names are sealed.
  EXPECT_EQ(filesWithSentinel(), std::vector<std::string>{"study.db"});
  EXPECT_EQ(study_->identities().names("P001").size(), 1U);
  EXPECT_EQ(study_->traces().visits().size(), 1U);
  const auto report = eraseThem();
  EXPECT_GT(report.answers, 10);
  EXPECT_EQ(report.names, 1U);
  EXPECT_EQ(report.sessions, 1U);
  EXPECT_GE(report.texts.size(), 5U);
  EXPECT_TRUE(report.filesWithTexts.empty());
  EXPECT_TRUE(filesWithSentinel().empty());
  EXPECT_TRUE(study_->identities().names().empty());
  EXPECT_TRUE(study_->traces().visits().empty());
  EXPECT_EQ(problemsOf(*study_), "");
}

TEST(Erasure, SearchesForNoWordsOfTheProtocol) {
  // An option that was chosen and a comment that is a word of the protocol stay in study.db.
  auto instrument = tests::everythingInstrument();
  const std::string option = R"({"id": "y")";
  instrument.replace(instrument.find(option), option.size(), R"({"id": "orthopaedic-resident")");
  tests::MadeStudy study(
      tests::protocolFrom(tests::protocolWithEverything(), {{"everything.json", instrument}}));
  {
    auto session = Session::enrol(*study, {.cohort = "surgeons"});
    tests::walkTo(session, StepKind::Form);
    int order = 0;
    for (const auto& item : session.items()) {
      auto answer = tests::answerTo(session, item, ++order);
      if (item.id == "one") answer.response = "orthopaedic-resident";
      if (item.id == "line") answer.response = "everything";
      if (item.id == "story") answer.response = planted("a story");
      session.record(answer);
    }
    session.pause("asked for it");
  }
  const auto report = erase(*study, {.participant = "P001", .reason = "asked for it by telephone"});
  EXPECT_EQ(report.filesWithTexts, std::vector<std::string>());
  EXPECT_EQ(report.texts.size(), 2U) << "the story and the name";
}

TEST_F(ErasureTest, LeavesNoReasonOfAnOperator) {
  eraseThem();
  using End = void (Session::*)(const std::string&);
  for (const End end : {&Session::withdraw, &Session::reject}) {
    auto begun = std::make_optional(Session::enrol(*study_, {.cohort = "surgeons"}));
    const auto participant = begun->participant();
    const auto id = begun->id();
    tests::walkTo(*begun, StepKind::Form);
    begun.reset();
    study_->database().execute(
        "REPLACE INTO lease VALUES (" + std::to_string(static_cast<std::int64_t>(id)) +
        ", 'the-other-laboratory', 4711, 'boot/1#1', 'earlier')");
    {
      auto session = Session::resume(*study_, id, planted("a take-over"));
      tests::walkTo(session, StepKind::Trial);
      session.beginTrial();
      session.abortTrial({.ending = TrialEnding::Stopped});
      session.skipStep(planted("a skip"));
      session.pause(planted("a pause"));
      (session.*end)(planted("an end"));
    }
    EXPECT_EQ(filesWithSentinel(), std::vector<std::string>{"study.db"}) << "the control";
    erase(
        *study_,
        {.participant = participant, .level = ErasureLevel::All, .reason = "asked for it"});
    EXPECT_TRUE(filesWithSentinel().empty()) << participant;
  }
  EXPECT_EQ(problemsOf(*study_), "");
}

TEST_F(ErasureTest, DestroysTheKeysAndWithThemWhatEventsSay) {
  const auto said = [&] {
    std::string all;
    for (const auto& event : study_->events().read(SessionId{1})) all += describe(event) + "\n";
    return all;
  };
  EXPECT_NE(said().find(kSentinel), std::string::npos);
  eraseThem();
  EXPECT_EQ(said().find(kSentinel), std::string::npos);
  EXPECT_NE(said().find("(erased)"), std::string::npos);
  EXPECT_NE(said().find("P001 (all): asked for it by telephone"), std::string::npos);
  using Key = storage::IdentityStore::Key;
  EXPECT_FALSE(study_->identities().key(Key::Identity, "P001"));
  EXPECT_FALSE(study_->identities().key(Key::Content, "P001"));
  EXPECT_TRUE(study_->identities().key(Key::Content, "P002"));
  for (const auto& event : study_->events().read(SessionId{2})) EXPECT_FALSE(event.isErased);
}

TEST_F(ErasureTest, LeavesATombstoneAndGivesThePlaceBack) {
  const auto before = row();
  eraseThem();
  EXPECT_EQ(row().state, SessionState::Erased);
  EXPECT_EQ(row().slotState, storage::SlotState::Released);
  EXPECT_EQ(row().endReason, std::nullopt);
  EXPECT_EQ(row().participant, "P001");
  EXPECT_EQ(row().startedUtc, before.startedUtc);
  auto next = Session::enrol(*study_, {.cohort = "surgeons"});
  EXPECT_EQ(next.slot(), before.slot);
  EXPECT_EQ(next.participant(), "P003");
  EXPECT_THROW(Session::enrol(*study_, {.cohort = "surgeons", .code = "P001"}), UserError);
}

TEST_F(ErasureTest, TakesTheParticipantOutOfAllResults) {
  EXPECT_EQ(computeResults(*study_, RunMode::Live).completed(), 1);
  eraseThem();
  const auto results = computeResults(*study_, RunMode::Live);
  EXPECT_EQ(results.completed(), 0);
  EXPECT_EQ(results.flow[0].enrolled, 2);
  EXPECT_EQ(results.flow[0].erased, 1);
  EXPECT_EQ(results.flow[0].inProgress, 1);
  for (const auto& answer : storage::Records(study_->database()).answers()) {
    EXPECT_NE(answer.step.visit.session, SessionId{1});
  }
}

TEST_F(ErasureTest, OfTheIdentityKeepsAnswers) {
  const auto answers = storage::Records(study_->database()).answers().size();
  const auto report = eraseThem(ErasureLevel::Identity);
  EXPECT_EQ(report.names, 1U);
  EXPECT_EQ(report.answers, 0);
  EXPECT_EQ(storage::Records(study_->database()).answers().size(), answers);
  EXPECT_EQ(row().state, SessionState::Completed);
  EXPECT_TRUE(study_->identities().names().empty());
  EXPECT_EQ(problemsOf(*study_), "");
  eraseThem(ErasureLevel::Answers);
  EXPECT_TRUE(eraseThem().filesWithTexts.empty()) << "its own reason stays";
  EXPECT_EQ(row().state, SessionState::Erased);
  EXPECT_EQ(problemsOf(*study_), "");
}

TEST_F(ErasureTest, OfAnswersKeepsTheName) {
  eraseThem(ErasureLevel::Answers);
  EXPECT_EQ(study_->identities().names("P001").size(), 1U);
  EXPECT_EQ(row().state, SessionState::Erased);
  EXPECT_TRUE(filesWithSentinel().empty()) << "the name is sealed";
  EXPECT_EQ(problemsOf(*study_), "");
}

TEST_F(ErasureTest, NamesTheFilesThatStillHoldAText) {
  fs::create_directories(study_.file("exports/table"));
  std::ofstream(study_.file("exports/table/responses.csv"))
      << "P001,\"" << planted("story") << "\"";
  std::ofstream(study_.file("exports/table/events.csv")) << planted("a pause");
  std::ofstream(study_.file("exports/table/other.csv")) << "P002,nothing";
  auto found = eraseThem().filesWithTexts;
  std::sort(found.begin(), found.end());
  EXPECT_EQ(
      found, (std::vector<std::string>{"exports/table/events.csv", "exports/table/responses.csv"}));
}

TEST_F(ErasureTest, LeavesNoReasonWithWhichASessionEnded) {
  // Each with all that an operator can type in a session before.
  constexpr std::array kEndings{&Session::withdraw, &Session::reject, &Session::giveUpOnDevice};
  const auto ended = [&](auto end) {
    auto session = Session::enrol(*study_, {.cohort = "surgeons"});
    session.note(planted("a note"));
    tests::walkTo(session, StepKind::Trial);
    session.beginTrial();
    session.abortTrial({.ending = TrialEnding::Stopped, .ticks = 500});
    if (end != &Session::giveUpOnDevice) {
      session.skipStep(planted("a skipped step"));
      session.pause(planted("a pause"));
      session.resumeAfterPause();
    }
    (session.*end)(planted("an end"));
    return session.participant();
  };
  for (const auto end : kEndings) {
    const auto report = erase(*study_, {.participant = ended(end), .reason = "asked"});
    EXPECT_TRUE(report.filesWithTexts.empty());
  }
  eraseThem();
  EXPECT_TRUE(filesWithSentinel().empty());
  EXPECT_EQ(problemsOf(*study_), "");
}

TEST_F(ErasureTest, LeavesNoReasonOfASessionThatWasTakenOver) {
  eraseThem();
  study_.close();
  tests::Sql(study_.file("study.db"))
      .run(
          "INSERT INTO lease (session_id, station, pid, process, taken_utc) "
          "VALUES (2, 'another-computer', 4711, 'boot/1#1', 'earlier')");
  study_.reopen();
  Session::resume(*study_, SessionId{2}, planted("a session that was taken over"));
  fs::create_directories(study_.file("exports"));
  std::ofstream(study_.file("exports/events.csv")) << planted("a session that was taken over");
  const auto report = erase(*study_, {.participant = "P002", .reason = "asked"});
  EXPECT_EQ(report.filesWithTexts, std::vector<std::string>{"exports/events.csv"});
  EXPECT_EQ(filesWithSentinel(), std::vector<std::string>{"events.csv"});
  EXPECT_EQ(problemsOf(*study_), "");
}

TEST_F(ErasureTest, SaysThatAReasonOfTheStudyNamesTheParticipant) {
  // Such an event is of no session and cannot be erased: docs/privacy.md asks for reasons without
  // names.
  recordUnblinding(*study_, RunMode::Live, EventKind::UnblindedReport, kName + " wants to know it");
  EXPECT_EQ(eraseThem().filesWithTexts, std::vector<std::string>{"study.db"});
}

TEST_F(ErasureTest, FingerprintsOfReportsTellNothingWithoutTheKeyOfTheStudy) {
  storage::Hasher open;
  open.add("the report of each order that can be");
  const std::string content = "the report of each order that can be";
  EXPECT_NE(fingerprintOf(*study_, content), storage::inHexadecimal(open.finish()));
  EXPECT_EQ(fingerprintOf(*study_, content), fingerprintOf(*study_, content));
}

TEST(ErasureList, ReadsWhatItWrote) {
  const storage::ListedErasure erasure{
      .study = "1a2b",
      .participant = "P001",
      .enrolledUtc = "then",
      .level = ErasureLevel::Answers,
      .utc = "now"};
  EXPECT_EQ(storage::listedErasureIn(asLine(erasure)), erasure);
  EXPECT_FALSE(storage::listedErasureIn("a\tb"));
  EXPECT_FALSE(storage::listedErasureIn("a\tb\tc\thalf\te"));
}

TEST_F(ErasureTest, IsToldByVerify) {
  eraseThem();
  const auto verification = verify(*study_);
  std::string remarks;
  for (const auto& check : verification.checks) {
    for (const auto& remark : check.remarks) remarks += remark + "\n";
  }
  EXPECT_NE(remarks.find("P001 was erased (all) on "), std::string::npos) << remarks;
}

TEST_F(ErasureTest, IsNotTakenForAForgedOne) {
  // The control of a sound study: without the key nothing can be read, and nobody was erased.
  study_->identities().destroy(storage::IdentityStore::Key::Content, "P002");
  EXPECT_NE(problemsOf(*study_).find("the key is missing"), std::string::npos);
}

TEST_F(ErasureTest, ShowsIfItsRecordWasChanged) {
  eraseThem();
  study_.close();
  tests::Sql(study_.file("study.db"))
      .run("DROP TRIGGER an_erasure_is_never_changed; UPDATE erasure SET reason = 'another'");
  study_.reopen();
  EXPECT_NE(problemsOf(*study_), "");
}

TEST_F(ErasureTest, IsRefusedWithAReason) {
  const auto refused = [&](const ErasureRequest& request) {
    EXPECT_THROW(erase(*study_, request), UserError) << request.participant << request.reason;
  };
  refused({.participant = "P009", .reason = "a reason"});
  refused({.participant = "P001"});
  refused({.participant = "P001", .reason = "Beeblebrox wants it"});
  refused({.participant = "P001", .reason = "asked for by BEEBLEBROX, on the telephone"});
  refused({.participant = "P001", .reason = "Beeblebrox's letter"});
  refused({.participant = "P001", .reason = "the Beeblebroxes' letter"});
  {
    auto simulated = Session::enrol(*study_, {.cohort = "surgeons", .runMode = RunMode::Simulated});
    refused({.participant = simulated.participant(), .reason = "a reason"});
  }
  auto open = Session::resume(*study_, SessionId{2});
  EXPECT_THROW(
      erase(*study_, {.participant = "P002", .reason = "a reason"}), storage::StorageError);
  EXPECT_TRUE(storage::ErasureRepository(study_->database()).all().empty());
}

TEST_F(ErasureTest, EndsASessionThatIsUnderWay) {
  erase(*study_, {.participant = "P002", .reason = "a reason"});
  EXPECT_TRUE(Session::resume(*study_, SessionId{2}).isOver());
  EXPECT_EQ(problemsOf(*study_), "");
}

TEST_F(ErasureTest, IsGoneOnWithWhenTheStudyIsOpenedToBeRead) {
  // As if it had been interrupted right after the decision.
  eraseThem(ErasureLevel::Answers);
  study_->database().execute("UPDATE erasure SET finished_utc = NULL");
  study_->identities().drawKeys("P001");
  study_.close();
  tests::Sql(study_.file("identity.db"))
      .run("UPDATE participant_key SET content = zeroblob(32) WHERE participant = 'P001'");
  SimulatedClock clock;
  auto study = Study::open(study_.folder(), clock, storage::Database::Access::ReadOnly);
  EXPECT_FALSE(study.identities().key(storage::IdentityStore::Key::Content, "P001"));
  EXPECT_TRUE(storage::ErasureRepository(study.database()).unfinished().empty());
  study_.reopen();
}

TEST_F(ErasureTest, LeavesNothingOnADiskThatFailsAtAnyCall) {
  study_.close();
  const auto original = study_.scratch() / "original";
  fs::rename(study_.folder(), original);
  fs::remove(original + std::string("/ballast"));
  // The calls of an erasure from call n on fail. @return  how many there were, and whether it ended
  const auto erasedWithFault = [&](std::int64_t n) {
    study_.close();
    fs::remove_all(study_.folder());
    fs::copy(original, study_.folder(), fs::copy_options::recursive);
    study_.reopen();
    tests::io_faults::arm({.first = n, .isPersistent = true});
    bool isComplete = true;
    try {
      eraseThem();
    } catch (const std::exception&) {
      isComplete = false;
    }
    return std::pair{tests::io_faults::disarm(), isComplete};
  };
  // On this station the erasures before this one did not happen.
  const auto own = [&](std::int64_t n) {
    return tests::OwnStation(study_.scratch() / ("station-" + std::to_string(n)));
  };
  const auto calls = [&] {
    const auto station = own(0);
    return erasedWithFault(std::numeric_limits<std::int64_t>::max()).first;
  }();
  std::int64_t failed = 0;
  const std::int64_t points = tests::isLong() ? calls : 5;
  for (std::int64_t point = 0; point < points; ++point) {
    const auto n = 1 + point * calls / points;
    const auto station = own(n);
    if (!erasedWithFault(n).second) ++failed;
    study_.close();
    study_.reopen();  // goes on, if it was decided
    if (row().state != SessionState::Erased) eraseThem();
    ASSERT_EQ(filesWithSentinel(), std::vector<std::string>{}) << "call " << n;
    ASSERT_EQ(problemsOf(*study_), "") << "call " << n;
  }
  std::cout << calls << " calls, " << points << " of them tried, " << failed
            << " erasures failed\n";
  EXPECT_GE(failed, points / 2) << "control: the faults reach the erasure";
}

}  // namespace erasure_test
}  // namespace study
