// `palpate study run`: a session in the terminal with typed input.
#include <chrono>
#include <csignal>
#include <fstream>
#include <string>
#include <thread>

#include <gtest/gtest.h>

#include "study/storage/records.h"
#include "tests/study/made_study.h"
#include "tests/study/storage/sql.h"
#include "tests/support/child_process.h"
#include "tests/support/programs.h"

namespace study {
namespace terminal_session_test {

class TerminalSessionTest : public testing::Test {
 protected:
  explicit TerminalSessionTest(
      const protocols::LoadedProtocol& protocol =
          tests::filledIn(tests::protocolFrom(tests::shortProtocol())))
      : study_(protocol) {}

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

  /// Answers a pilot's first question while another program holds the lock of study.db.
  /// @param isLetGo  once the session has said that it waits, until it asks the next question;
  ///     otherwise it is ended
  /// @return what it wrote to stderr
  std::string answeredUnderALock(bool isLetGo) {
    study_.close();
    const auto output = study_.scratch() / "output";
    const auto errors = study_.scratch() / "errors";
    for (const auto& file : {output, errors}) std::ofstream(file).flush();
    const std::string call = "exec '" + tests::program() + "' study run '" + study_.folder() +
                             "' --pilot >'" + output + "' 2>'" + errors + "'";
    tests::ChildProcess session({"sh", "-c", call}, {}, tests::ChildProcess::Input::Pipe);
    const auto waitFor = [&](const auto& isThere) {
      while (!isThere() && !session.hasEnded()) {
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
      }
    };
    const auto hasAsked = [&](int questions) {
      const auto text = tests::contentOf(output);
      std::size_t place = 0;
      for (int i = 0; i < questions && place != std::string::npos; ++i) {
        place = text.find("\n> ", place + 1);
      }
      return place != std::string::npos;
    };
    waitFor([&] { return hasAsked(1); });
    tests::Sql other(study_.file("study.db"));
    other.run("BEGIN IMMEDIATE");
    session.say("yes");
    waitFor([&] { return tests::contentOf(errors).find("Not stored yet") != std::string::npos; });
    if (isLetGo) {
      other.run("ROLLBACK");
      waitFor([&] { return hasAsked(2); });
    }
    session.kill(SIGKILL);
    session.finish();
    if (!isLetGo) other.run("ROLLBACK");
    study_.reopen();
    return tests::contentOf(errors);
  }

  tests::MadeStudy study_;
};

TEST_F(TerminalSessionTest, StoresAnAnswerOnceAnotherProgramLetsGoOfTheStudy) {
  const auto said = answeredUnderALock(true);
  EXPECT_NE(said.find("another program is using it"), std::string::npos) << said;
  EXPECT_EQ(consented(), "yes");
}

TEST_F(TerminalSessionTest, StoresNothingWhileAnotherProgramKeepsTheStudy) {
  answeredUnderALock(false);
  EXPECT_EQ(consented(), "") << "the control";
}

TEST_F(TerminalSessionTest, AcceptsYesAndNoInItsLanguages) {
  for (const std::string yes : {"yes", "Y", "Ja", "j"}) {
    const auto finished = run(yes + "\\n\\n\\n");
    EXPECT_EQ(consented(), "yes") << yes << "\n" << finished.out;
    EXPECT_FALSE(isOver(last().state)) << yes;
    auto session = Session::resume(*study_, last().id);
    session.withdraw("a test");
  }
  for (const std::string no : {"no", "Nein", "nei", "n"}) {
    run(no + "\\n\\n\\n");
    EXPECT_EQ(last().state, SessionState::Declined) << no;
  }
  run("perhaps\\n");
  EXPECT_FALSE(isOver(last().state)) << "neither yes nor no";
}

/// A study whose texts have blanks.
class TerminalWithBlanks : public TerminalSessionTest {
 protected:
  TerminalWithBlanks() : TerminalSessionTest(tests::protocolFrom(tests::shortProtocol())) {}
};

TEST_F(TerminalWithBlanks, BeginsNoLiveSession) {
  const auto refused = run("y\\ny\\n");
  EXPECT_EQ(refused.status, 1);
  EXPECT_NE(refused.out.find("[[institution]]"), std::string::npos) << refused.out;
  EXPECT_NE(refused.out.find("palpate study texts"), std::string::npos) << refused.out;
  EXPECT_TRUE(storage::Records(study_->database()).sessions().empty()) << "no place is taken";
}

TEST_F(TerminalWithBlanks, BeginsAPilotAndNamesTheBlanks) {
  const auto pilot = run("", "--pilot");
  EXPECT_NE(pilot.out.find("[[institution]]"), std::string::npos) << pilot.out;
  EXPECT_EQ(last().runMode, RunMode::Pilot);
}

TEST_F(TerminalSessionTest, HasTheRequestedRunMode) {
  run("", "--run-mode pilot");
  EXPECT_EQ(last().runMode, RunMode::Pilot);
  run("", "--cohort students");
  EXPECT_EQ(last().runMode, RunMode::Live);
  EXPECT_EQ(run("", "--run-mode simulated").status, 2);
  EXPECT_EQ(run("", "--pilot --run-mode live").status, 2);
  EXPECT_EQ(storage::Records(study_->database()).sessions().size(), 2U);
  run("", "--pilot");
  EXPECT_EQ(storage::Records(study_->database()).sessions().size(), 2U) << "the pilot goes on";
}

TEST_F(TerminalSessionTest, GoesOnWithNoSessionThatTheOptionsContradict) {
  run("", "--cohort students --language de");
  for (const std::string options : {"--cohort surgeons", "--language nb", "--language en"}) {
    const auto refused = run("", options);
    EXPECT_EQ(refused.status, 1) << options;
    EXPECT_NE(refused.error.find("P001 is not finished"), std::string::npos) << refused.error;
  }
  for (const std::string options : {"", "--cohort students", "--language de"}) {
    EXPECT_NE(run("", options).out.find("palpate study run' goes on"), std::string::npos);
  }
  EXPECT_EQ(storage::Records(study_->database()).sessions().size(), 1U);
  run("", "--cohort surgeons --participant P007");
  EXPECT_EQ(last().cohort, "surgeons");
  EXPECT_EQ(last().language, "en");
}

}  // namespace terminal_session_test
}  // namespace study
