// The questions, saved answers and messages of the operator's window in a session.
#include <sys/resource.h>

#include <csignal>
#include <filesystem>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <QApplication>
#include <QComboBox>
#include <QElapsedTimer>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QRegularExpression>
#include <QTest>

#include "protocols/load_protocol.h"
#include "protocols/model/loaded_protocol.h"
#include "study/gui/operator/control_panel.h"
#include "study/gui/operator/cut_table.h"
#include "study/gui/operator/enrolment_check.h"
#include "study/gui/operator/live_plot.h"
#include "study/gui/operator/operator_window.h"
#include "study/gui/participant/benchmark_page.h"
#include "study/gui/widgets/message_box.h"
#include "study/model/study_files.h"
#include "study/storage/records.h"
#include "tests/study/gui/participant.h"
#include "tests/study/known_secret.h"
#include "tests/study/made_study.h"
#include "tests/study/storage/sql.h"
#include "tests/support/scratch_folder.h"

namespace study::gui {
namespace operator_session_test {

using tests::buttonSaying;

/// The published punch study with a break of one second and an interview after the consent.
class OperatorSession : public testing::Test {
 protected:
  protocols::LoadedProtocol protocol() {
    questionnaires::Problems problems;
    const auto shipped = protocols::loadProtocolFile("punch-face-validity", problems);
    auto json = nlohmann::ordered_json::parse(shipped->text);
    const auto second = nlohmann::ordered_json::parse(
        R"([{"id": "rest", "type": "break", "seconds": 1, "text": {"en": "Rest."}},
            {"id": "talk", "type": "interview", "instrument": "interview"}])");
    auto& phases = json["phases"];
    phases.insert(phases.begin() + 2, second.begin(), second.end());
    return *protocols::loadProtocolFile(folder_.write("protocol.json", json.dump()), problems);
  }

  void SetUp() override { window_.show(); }

  void enrol() {
    window_.enrol(
        {.cohort = "professional", .runMode = RunMode::Pilot, .language = "en", .code = {}});
  }

  void goTo(StepKind kind) {
    const auto& plan = session().plan();
    while (plan[static_cast<std::size_t>(session().stepIndex())].kind != kind) {
      if (session().step().kind == StepKind::Break) {
        auto* next = buttonSaying(window_.participantWindow(), QStringLiteral("Next"));
        ASSERT_TRUE(QTest::qWaitFor([&] { return next->isEnabled(); }, 3000));
      }
      participant_.doStep();
    }
  }

  const Session& session() const { return window_.controller()->session(); }

  /// Types text into the first free-text field of @p window, without waiting for it to be saved.
  void type(QWidget& window, const QString& words) {
    QCoreApplication::processEvents();
    auto* lines = window.findChild<QPlainTextEdit*>();
    ASSERT_NE(lines, nullptr);
    QTest::keyClicks(lines, words);
  }

  std::vector<std::string> textsKept(const char* item) {
    std::vector<std::string> texts;
    for (const auto& row : storage::Records(study_.database()).answers()) {
      if (row.answer.item == item) texts.push_back(std::get<std::string>(row.answer.response));
    }
    return texts;
  }

  tests::ScratchFolder folder_;
  SystemClock clock_;
  Study study_{Study::create(folder_ / "study", protocol(), clock_, 7, tests::knownSecret())};
  OperatorWindow window_{study_};
  tests::Participant participant_{window_};
};

TEST_F(OperatorSession, RefusesALiveSessionWithBlanksInTextsAndAsksBeforeAPilot) {
  const auto press = [&](const auto& answer) {
    std::vector<MessageTopic> shown;
    QTimer look;
    QObject::connect(&look, &QTimer::timeout, &look, [&] {
      auto* box = qobject_cast<MessageBox*>(QApplication::activeModalWidget());
      if (box == nullptr) return;
      shown.push_back(box->topic());
      EXPECT_TRUE(box->words().contains(QStringLiteral("(10)"))) << "as in the form of the texts";
      EXPECT_TRUE(box->words().contains(QStringLiteral("institution"), Qt::CaseInsensitive))
          << box->words().toStdString();
      answer(*box);
    });
    look.start(20);
    tests::chooseFirstCohort(window_);
    QTest::mouseClick(buttonSaying(&window_, QStringLiteral("New participant")), Qt::LeftButton);
    return shown;
  };
  QComboBox* mode = nullptr;
  for (auto* box : window_.findChildren<QComboBox*>()) {
    if (box->accessibleName() == QStringLiteral("Run mode")) mode = box;
  }
  ASSERT_NE(mode, nullptr);
  EXPECT_EQ(mode->currentData().toInt(), static_cast<int>(RunMode::Pilot))
      << "is offered first, because the devices are virtual";
  const auto pressEnter = [](MessageBox& box) { QTest::keyClick(&box, Qt::Key_Return); };
  EXPECT_EQ(press(pressEnter), std::vector{MessageTopic::PilotSessionHasBlanks});
  EXPECT_EQ(window_.controller(), nullptr) << "Enter does not begin it";
  mode->setCurrentIndex(mode->findData(static_cast<int>(RunMode::Live)));
  EXPECT_EQ(
      press([](MessageBox& box) {
        EXPECT_EQ(box.findChild<QPushButton*>(QStringLiteral("action")), nullptr);
        box.accept();
      }),
      std::vector{MessageTopic::LiveSessionHasBlanks});
  EXPECT_EQ(window_.controller(), nullptr) << "there is no way past it";
  EXPECT_TRUE(storage::Records(study_.database()).sessions().empty());

  mode->setCurrentIndex(mode->findData(static_cast<int>(RunMode::Pilot)));
  press([](MessageBox& box) {
    QTest::mouseClick(box.findChild<QPushButton*>(QStringLiteral("action")), Qt::LeftButton);
  });
  ASSERT_NE(window_.controller(), nullptr) << "a pilot session does not count";
}

TEST_F(OperatorSession, NeedsTheCohortOfEachParticipantChosenAnew) {
  const auto isPossible = [this] {
    return buttonSaying(&window_, QStringLiteral("New participant"))->isEnabled();
  };
  EXPECT_FALSE(isPossible());
  tests::chooseFirstCohort(window_);
  EXPECT_TRUE(isPossible());
  enrol();
  QTest::mouseClick(buttonSaying(&window_, QStringLiteral("Close session")), Qt::LeftButton);
  EXPECT_FALSE(isPossible()) << "of the participant before";
}

TEST_F(OperatorSession, OffersASessionOnceItIsNoLongerOpenElsewhere) {
  std::optional<Session> elsewhere(
      Session::enrol(study_, {.cohort = "professional", .runMode = RunMode::Pilot}));
  OperatorWindow window(study_);
  window.show();
  const auto* resume = buttonSaying(&window, QStringLiteral("Continue session"));
  ASSERT_NE(resume, nullptr);
  EXPECT_FALSE(resume->isEnabled());
  for (const auto* label : window.findChildren<QLabel*>()) {
    static const QRegularExpression kUtc(QStringLiteral("\\dT\\d"));
    EXPECT_FALSE(label->text().contains(kUtc)) << label->text().toStdString();
  }
  elsewhere.reset();
  EXPECT_TRUE(QTest::qWaitFor([&] { return resume->isEnabled(); }, 6000));
}

TEST_F(OperatorSession, AsksBeforeALiveSessionInABackup) {
  const tests::OwnStation station(folder_ / "station");
  const std::string folder = folder_ / "own";
  const std::string backup = folder_ / "backup";
  {
    auto own = Study::create(folder, protocol(), clock_, 7, tests::knownSecret());
    own.note(EventKind::UnblindedResults, "an interim look");
  }
  std::filesystem::copy(folder, backup, std::filesystem::copy_options::recursive);
  Study::open(folder, clock_).note(EventKind::UnblindedResults, "another one");
  const auto mayBegin = [&](const std::string& where, RunMode mode) {
    int questions = 0;
    QTimer look;
    QObject::connect(&look, &QTimer::timeout, &look, [&questions] {
      auto* question = qobject_cast<MessageBox*>(QApplication::activeModalWidget());
      if (question == nullptr) return;
      ++questions;
      EXPECT_EQ(question->topic(), MessageTopic::LiveSessionInOlderCopy);
      QTest::keyClick(question, Qt::Key_Return);
    });
    look.start(20);
    auto opened = Study::open(where, clock_, storage::Database::Access::ReadOnly);
    const bool isPossible = confirmNewestCopy(opened, {.runMode = mode}, &window_);
    EXPECT_EQ(questions, isPossible ? 0 : 1);
    return isPossible;
  };
  EXPECT_FALSE(mayBegin(backup, RunMode::Live));
  EXPECT_TRUE(mayBegin(backup, RunMode::Pilot));
  EXPECT_TRUE(mayBegin(folder, RunMode::Live));
}

TEST_F(OperatorSession, SavesTextTypedJustBeforeAPause) {
  enrol();
  goTo(StepKind::Interview);
  type(window_, QStringLiteral("Like bone."));
  EXPECT_TRUE(textsKept("first-impression").empty()) << "typing has not paused long enough";
  window_.controller()->pause(QStringLiteral("coffee"));
  ASSERT_EQ(session().state(), SessionState::Paused);
  EXPECT_EQ(textsKept("first-impression"), std::vector<std::string>{"Like bone."});
  window_.controller()->resume();
  QCoreApplication::processEvents();
  EXPECT_EQ(window_.findChild<QPlainTextEdit*>()->toPlainText(), QStringLiteral("Like bone."));
}

TEST_F(OperatorSession, SavesTextTypedJustBeforeClosing) {
  enrol();
  goTo(StepKind::Interview);
  type(window_, QStringLiteral("Too soft."));
  QTest::mouseClick(buttonSaying(&window_, QStringLiteral("Close session")), Qt::LeftButton);
  ASSERT_EQ(window_.controller(), nullptr);
  EXPECT_EQ(textsKept("first-impression"), std::vector<std::string>{"Too soft."});
}

/// Reads the next message box and closes it.
class Reader {
 public:
  Reader() {
    QObject::connect(&look_, &QTimer::timeout, &look_, [this] {
      auto* message = qobject_cast<MessageBox*>(QApplication::activeModalWidget());
      if (message == nullptr) return;
      texts_ << message->words();
      message->close();
    });
    look_.start(20);
  }
  const QStringList& texts() const noexcept { return texts_; }

 private:
  QTimer look_;
  QStringList texts_;
};

TEST_F(OperatorSession, ShowsThePauseAndHowTheSessionEnded) {
  enrol();
  goTo(StepKind::Interview);
  const auto says = [&](const char* words) {
    for (auto* label : window_.findChildren<QLabel*>()) {
      if (label->isVisible() && label->text().contains(QString::fromUtf8(words))) return true;
    }
    return false;
  };
  window_.controller()->pause(QStringLiteral("phone call"));
  EXPECT_TRUE(says("paused: no force"));
  window_.controller()->resume();
  EXPECT_FALSE(says("paused"));
  window_.controller()->withdraw({});
  EXPECT_TRUE(says("this session is over: withdrawn"));
}

TEST_F(OperatorSession, SaysBeforeARepetitionWhichStepIsRepeated) {
  enrol();
  const auto asked = [this](const char* button) {
    const Reader reader;
    QTest::mouseClick(buttonSaying(&window_, QString::fromUtf8(button)), Qt::LeftButton);
    return reader.texts().value(0).toStdString();
  };
  goTo(StepKind::Questionnaire);
  const int trial = session().stepIndex();  // the step before, counted from 1
  const auto repeat = asked("Repeat…");
  EXPECT_NE(repeat.find("Repeat from step " + std::to_string(trial) + " ("), std::string::npos)
      << repeat;
  EXPECT_EQ(asked("Skip…").find("trial"), std::string::npos);
  goTo(StepKind::Trial);
  EXPECT_NE(asked("Skip…").find("Skip the trial and the questions about it?"), std::string::npos);
  participant_.cut(1);
  window_.controller()->stop();
  ASSERT_EQ(session().state(), SessionState::Interrupted);
  EXPECT_NE(asked("Repeat…").find("Repeat the trial from its start?"), std::string::npos);
}

TEST_F(OperatorSession, ShowsNoDataOfThePreviousSession) {
  enrol();
  goTo(StepKind::Trial);
  participant_.cut(1);
  window_.controller()->stop();
  auto* plot = window_.findChild<LivePlot*>();
  auto* cuts = window_.findChild<CutTable*>();
  ASSERT_FALSE(plot->channel(0).empty());
  ASSERT_GT(cuts->rowCount(), 0);
  window_.controller()->withdraw({});
  QTest::mouseClick(buttonSaying(&window_, QStringLiteral("Close session")), Qt::LeftButton);
  enrol();
  ASSERT_NE(window_.controller(), nullptr);
  EXPECT_TRUE(plot->channel(0).empty());
  EXPECT_EQ(cuts->rowCount(), 0);
  EXPECT_EQ(
      window_.findChild<QLabel*>(QStringLiteral("servo-health"))->text(),
      QStringLiteral("Nothing is felt just now."));
}

TEST_F(OperatorSession, StaysInAStepWhoseTextCannotBeSaved) {
  enrol();
  goTo(StepKind::Interview);
  const int step = session().stepIndex();
  type(window_, QStringLiteral("Too hard."));
  auto* next = buttonSaying(&window_, QStringLiteral("Interview done"));
  {
    tests::Sql somebodyElse(StudyFiles{study_.folder()}.study());
    somebodyElse.run("BEGIN IMMEDIATE");
    const Reader reader;
    QTest::mouseClick(next, Qt::LeftButton);
    EXPECT_EQ(reader.texts().size(), 1) << "one message";
    EXPECT_EQ(session().stepIndex(), step);
    window_.close();
    EXPECT_GE(reader.texts().size(), 2);
    EXPECT_NE(window_.controller(), nullptr) << "not closed without confirmation";
  }
  EXPECT_TRUE(textsKept("first-impression").empty());
  QTest::mouseClick(next, Qt::LeftButton);
  EXPECT_EQ(session().stepIndex(), step + 1);
  EXPECT_EQ(textsKept("first-impression"), std::vector<std::string>{"Too hard."});
}

TEST_F(OperatorSession, ABreaksTimerEnablesNextOnItsOwnPageOnly) {
  enrol();
  QElapsedTimer longerThanTheBreak;
  longerThanTheBreak.start();
  goTo(StepKind::Break);
  auto* next = buttonSaying(window_.participantWindow(), QStringLiteral("Next"));
  const bool isEnabled = next->isEnabled();
  if (longerThanTheBreak.elapsed() < 1000) EXPECT_FALSE(isEnabled);
  window_.controller()->skipStep(QStringLiteral("not tired"));
  window_.controller()->skipStep(QStringLiteral("nothing to say"));
  window_.controller()->skipStep(QStringLiteral("known already"));
  ASSERT_EQ(session().step().kind, StepKind::Benchmark) << "its cuts must be made";
  next = window_.participantWindow()->findChild<BenchmarkPage*>()->findChild<QPushButton*>();
  EXPECT_FALSE(next->isEnabled());
  QTest::qSleep(1200);  // longer than the break; the page of the break is not deleted yet
  QTest::qWait(50);
  EXPECT_FALSE(next->isEnabled());
}

TEST_F(OperatorSession, CountsTheCutsOfABenchmarkForTheOperatorToo) {
  enrol();
  goTo(StepKind::Benchmark);
  const auto* count = window_.findChild<QLabel*>(QStringLiteral("count"));
  EXPECT_TRUE(count->text().startsWith(QStringLiteral("0 of "))) << count->text().toStdString();
  const auto press = [this](const char* button) {
    QTest::mouseClick(buttonSaying(&window_, QString::fromUtf8(button)), Qt::LeftButton);
  };
  press("Count a cut (F9)");
  press("Count a cut (F9)");
  press("One less");
  EXPECT_TRUE(count->isVisible());
  EXPECT_TRUE(count->text().startsWith(QStringLiteral("1 of "))) << count->text().toStdString();
  press("One less");
  press("One less");
  EXPECT_EQ(session().benchmarkCuts(), 0) << "not fewer than none";
}

/// Calls a function for the modal dialog in front until it returns true.
class InFront {
 public:
  explicit InFront(std::function<bool(QWidget&)> act) {
    QObject::connect(&look_, &QTimer::timeout, &look_, [this, act = std::move(act)] {
      auto* front = QApplication::activeModalWidget();
      if (front != nullptr && act(*front)) look_.stop();
    });
    look_.start(20);
  }

 private:
  QTimer look_;
};

TEST_F(OperatorSession, ClosesTheWarningThatATrialIsRunningWhenAStopEndsIt) {
  enrol();
  goTo(StepKind::Trial);
  participant_.cut(0);
  ASSERT_TRUE(window_.controller()->isTrialRunning());
  const InFront stop([](QWidget& message) {
    QTest::keyClick(&message, Qt::Key_Escape);
    return true;
  });
  EXPECT_FALSE(window_.close());
  EXPECT_FALSE(window_.controller()->isTrialRunning());
}

TEST_F(OperatorSession, AsksBeforeVirtualDevicesGoOnInPlaceOfAnInstrument) {
  enrol();
  goTo(StepKind::Trial);
  participant_.cut(0);
  window_.controller()->stop();
  const auto id = session().id();
  const auto close = [&] {
    QTest::mouseClick(buttonSaying(&window_, QStringLiteral("Close session")), Qt::LeftButton);
  };
  close();
  {
    const Reader reader;
    window_.resumeAfterChecks(id);
    EXPECT_TRUE(reader.texts().isEmpty()) << "it was virtual before";
  }
  close();
  tests::Sql(StudyFiles{study_.folder()}.study()).run("UPDATE trial SET device = 'punch (COM3)'");
  const Reader reader;
  window_.resumeAfterChecks(id);
  ASSERT_EQ(reader.texts().size(), 1);
  EXPECT_TRUE(reader.texts().front().contains(QStringLiteral("was felt on: punch (COM3)")));
  EXPECT_EQ(window_.controller(), nullptr) << "closing the question does not go on";
}

TEST_F(OperatorSession, KeepsATrialThatCannotBeSavedUntilItCan) {
  enrol();
  goTo(StepKind::Trial);
  participant_.cut(1);
  QString shown;
  const auto state = [this] { return window_.findChild<QLabel*>(QStringLiteral("state"))->text(); };
  {
    tests::Sql somebodyElse(StudyFiles{study_.folder()}.study());
    somebodyElse.run("BEGIN IMMEDIATE");
    const InFront read([&](QWidget& message) {
      shown = state();
      message.close();
      return true;
    });
    window_.controller()->stop();
  }
  EXPECT_TRUE(shown.contains(QStringLiteral("not saved"))) << "before the message is closed";
  EXPECT_EQ(buttonSaying(window_.participantWindow(), QStringLiteral("Begin")), nullptr);
  auto* save = buttonSaying(&window_, QStringLiteral("Save the trial"));
  ASSERT_NE(save, nullptr);
  QTest::mouseClick(save, Qt::LeftButton);
  EXPECT_EQ(session().state(), SessionState::Interrupted);
  const auto trials = storage::Records(study_.database()).trials();
  ASSERT_EQ(trials.size(), 1U);
  EXPECT_EQ(trials.front().ending, TrialEnding::Stopped);
  EXPECT_GT(trials.front().duration, 0.0);
  EXPECT_FALSE(save->isVisible());
  EXPECT_TRUE(state().contains(QStringLiteral("broke off"))) << state().toStdString();
}

TEST_F(OperatorSession, SavesATrialThatCouldNotBeSavedWhenTheSessionIsClosed) {
  enrol();
  goTo(StepKind::Trial);
  participant_.cut(1);
  {
    tests::Sql somebodyElse(StudyFiles{study_.folder()}.study());
    somebodyElse.run("BEGIN IMMEDIATE");
    const Reader reader;
    window_.controller()->stop();
  }
  QTest::mouseClick(buttonSaying(&window_, QStringLiteral("Close session")), Qt::LeftButton);
  EXPECT_EQ(window_.controller(), nullptr);
  const auto trials = storage::Records(study_.database()).trials();
  ASSERT_EQ(trials.size(), 1U);
  EXPECT_EQ(trials.front().ending, TrialEnding::Stopped);
}

TEST_F(OperatorSession, WarnsWhileTheDiskHasNoRoomForTheNextTrial) {
  enrol();
  const auto* disk = window_.findChild<QLabel*>(QStringLiteral("disk"));
  ASSERT_NE(disk, nullptr);
  EXPECT_FALSE(disk->isVisible());
  std::filesystem::remove(study_.folder() / "ballast");
  struct rlimit before {};
  getrlimit(RLIMIT_FSIZE, &before);
  auto* handler = std::signal(SIGXFSZ, SIG_IGN);
  const rlimit tooSmall{1 << 20, before.rlim_max};
  setrlimit(RLIMIT_FSIZE, &tooSmall);
  participant_.doStep();
  EXPECT_TRUE(disk->isVisible());
  setrlimit(RLIMIT_FSIZE, &before);
  std::signal(SIGXFSZ, handler);
  participant_.doStep();
  EXPECT_FALSE(disk->isVisible()) << "the space is reserved again";
}

/// A session whose participant's window covers the screen until the PIN 2468.
class HandedOver : public OperatorSession {
 protected:
  void handOver() {
    enrol();
    const InFront choosePin([](QWidget& dialog) {
      for (auto* line : dialog.findChildren<QLineEdit*>()) {
        QTest::keyClicks(line, QStringLiteral("2468"));
      }
      QTest::mouseClick(buttonSaying(&dialog, QStringLiteral("Hand over")), Qt::LeftButton);
      return true;
    });
    QTest::mouseClick(buttonSaying(&window_, QStringLiteral("Hand over…")), Qt::LeftButton);
    ASSERT_TRUE(window_.participantWindow()->lock().isLocked());
  }

  void unlock() {
    QTest::mouseClick(
        buttonSaying(window_.participantWindow(), QStringLiteral("Researcher")), Qt::LeftButton);
    auto* pin = window_.participantWindow()->findChild<QLineEdit*>();
    ASSERT_NE(pin, nullptr);
    QTest::keyClicks(pin, QStringLiteral("2468"));
    QTest::keyClick(pin, Qt::Key_Return);
  }
};

TEST_F(HandedOver, ShowsMessagesOnlyAfterUnlocking) {
  handOver();
  QString told;
  emit window_.controller()->failed(QStringLiteral("The disk is full."));
  emit window_.controller()->failed(QStringLiteral("It still is."));
  QCoreApplication::processEvents();
  EXPECT_EQ(QApplication::activeModalWidget(), nullptr) << "no message while the screen is locked";

  const InFront read([&](QWidget& message) {
    told = qobject_cast<MessageBox*>(&message)->words();
    message.close();
    return true;
  });
  unlock();
  EXPECT_TRUE(QTest::qWaitFor([&] { return !told.isEmpty(); }, 2000));
  EXPECT_TRUE(told.contains(QStringLiteral("\n\nThe disk is full.\n\nIt still is.")))
      << told.toStdString();
}

TEST_F(HandedOver, AsksTheParticipantToCallTheResearcherWhenATrialBreaksOff) {
  handOver();
  goTo(StepKind::Trial);
  participant_.cut(1);
  window_.controller()->stop();
  const auto says = [this](const char* words) {
    for (const auto* label : window_.participantWindow()->findChildren<QLabel*>()) {
      if (label->isVisible() && label->text().contains(QString::fromUtf8(words))) return true;
    }
    return false;
  };
  EXPECT_TRUE(says("Please call the researcher"));
  unlock();
  EXPECT_FALSE(says("Please call the researcher"));
  EXPECT_TRUE(says("The researcher will go on")) << "who has come";
}

TEST_F(HandedOver, GivesTheOperatorTheKeyboardBackAfterThePin) {
  handOver();
  EXPECT_NE(QApplication::activeWindow(), &window_);
  unlock();
  EXPECT_TRUE(QTest::qWaitFor([&] { return QApplication::activeWindow() == &window_; }, 2000));
}

}  // namespace operator_session_test
}  // namespace study::gui
