// `palpate study run`: a session in the terminal with typed input.
#include <gtest/gtest.h>

#include "study/storage/records.h"
#include "tests/study/made_study.h"
#include "tests/support/child_process.h"
#include "tests/support/programs.h"

namespace study {
namespace terminal_session_test {

class TerminalSessionTest : public testing::Test {
 protected:
  /// Runs a session with @p typed as its whole input.
  tests::Finished run(const std::string& typed, const std::string& options = "") {
    study_.close();
    const std::string call = "printf '" + typed + "' | '" + tests::program() + "' study run '" +
                             study_.folder() + "' " + options;
    auto finished = tests::run({"sh", "-c", call});
    study_.reopen();
    return finished;
  }

  /// The response to the consent question in the last session.
  std::string consented() {
    std::string said;
    for (const auto& answer : storage::Records(study_->database()).answers()) {
      if (answer.answer.item == "consent") said = std::get<std::string>(answer.answer.response);
    }
    return said;
  }
  storage::SessionRecord last() { return storage::Records(study_->database()).sessions().back(); }

  tests::MadeStudy study_;
};

TEST_F(TerminalSessionTest, AcceptsYesAndNoInItsLanguages) {
  for (const std::string yes : {"yes", "Y", "Ja", "j"}) {
    const auto finished = run("y\\n" + yes + "\\n\\n\\n");
    EXPECT_EQ(consented(), "yes") << yes << "\n" << finished.out;
    EXPECT_FALSE(isOver(last().state)) << yes;
    auto session = Session::resume(*study_, last().id);
    session.withdraw("a test");
  }
  for (const std::string no : {"no", "Nein", "nei", "n"}) {
    run("y\\n" + no + "\\n\\n\\n");
    EXPECT_EQ(last().state, SessionState::Declined) << no;
  }
  run("y\\nperhaps\\n");
  EXPECT_FALSE(isOver(last().state)) << "neither yes nor no";
}

TEST_F(TerminalSessionTest, AsksBeforeAParticipantReadsPlaceholders) {
  const auto refused = run("\\n");
  EXPECT_EQ(refused.status, 1);
  EXPECT_NE(refused.out.find("[[institution]]"), std::string::npos) << refused.out;
  EXPECT_TRUE(storage::Records(study_->database()).sessions().empty()) << "no place is taken";
  EXPECT_NE(refused.out.find("Start anyway?"), std::string::npos) << refused.out;
  const auto pilot = run("", "--pilot");
  EXPECT_EQ(pilot.out.find("Start anyway"), std::string::npos) << "a pilot does not count";
}

TEST_F(TerminalSessionTest, HasTheRequestedRunMode) {
  run("", "--run-mode pilot");
  EXPECT_EQ(last().runMode, RunMode::Pilot);
  run("y\\n", "--cohort students");
  EXPECT_EQ(last().runMode, RunMode::Live);
  EXPECT_EQ(run("", "--run-mode simulated").status, 2);
  EXPECT_EQ(run("", "--pilot --run-mode live").status, 2);
  EXPECT_EQ(storage::Records(study_->database()).sessions().size(), 2U);
  run("", "--pilot");
  EXPECT_EQ(storage::Records(study_->database()).sessions().size(), 2U) << "the pilot goes on";
}

}  // namespace terminal_session_test
}  // namespace study
