#include <gtest/gtest.h>

#include <QAction>
#include <QCoreApplication>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSignalSpy>
#include <QTest>

#include "protocols/load_protocol.h"
#include "protocols/model/loaded_protocol.h"
#include "study/gui/operator/control_panel.h"
#include "study/gui/operator/operator_window.h"
#include "study/gui/operator/page_mirror.h"
#include "study/gui/operator/timeline_table.h"
#include "study/gui/participant/option_buttons.h"
#include "study/gui/participant/trial_page.h"
#include "study/results/results.h"
#include "study/storage/records.h"
#include "tests/study/gui/participant.h"
#include "tests/study/gui/visible_words.h"
#include "tests/study/known_secret.h"
#include "tests/support/scratch_folder.h"

namespace study::gui {
namespace punch_session_test {

using tests::buttonSaying;

protocols::LoadedProtocol library(const std::string& name) {
  questionnaires::Problems problems;
  return *protocols::loadProtocolFile(name, problems);
}

class PunchSession : public testing::Test {
 protected:
  void SetUp() override {
    window_.show();
    window_.enrol(
        {.cohort = "professional", .runMode = RunMode::Live, .language = "en", .code = {}});
  }

  tests::ScratchFolder folder_;
  SystemClock clock_;
  Study study_{Study::create(
      folder_ / "study", library("punch-face-validity"), clock_, 7, tests::knownSecret())};
  OperatorWindow window_{study_};
  tests::Participant participant_{window_};
};

TEST_F(PunchSession, CanBeClickedThroughFromConsentToThanks) {
  participant_.takePart();

  const auto& session = window_.controller()->session();
  ASSERT_TRUE(session.isOver()) << "stuck in step " << session.stepIndex();
  EXPECT_EQ(session.state(), SessionState::Completed);
  const auto results = computeResults(study_, RunMode::Live);
  EXPECT_EQ(results.completed(), 1);
  for (const auto& condition : results.families.front().cohorts.front().conditions) {
    EXPECT_EQ(condition.answers.total(), 6U);  // three statements, two rounds
  }
  for (const auto& trial : storage::Records(study_.database()).trials()) {
    EXPECT_GE(trial.cuts, 3);
    EXPECT_EQ(trial.traceSamples, trial.ticks);
  }
}

TEST_F(PunchSession, DoesNotEndATrialBeforeTheMinimumNumberOfCuts) {
  participant_.goTo(StepKind::Trial);
  auto& controller = *window_.controller();
  ASSERT_EQ(controller.session().step().minimumCuts, 3);
  controller.beginTrial();
  ASSERT_TRUE(controller.isTrialRunning());
  controller.finishTrial();
  EXPECT_TRUE(controller.isTrialRunning());
  EXPECT_EQ(controller.session().state(), SessionState::InTrial);
  EXPECT_TRUE(storage::Records(study_.database()).trials().empty());
}

TEST_F(PunchSession, StaysOnAPageWhoseStepCouldNotBeFinished) {
  auto session = Session::enrol(study_, {.cohort = "professional", .runMode = RunMode::Pilot});
  while (session.missing().empty()) session.finishStep();
  SessionController controller(study_, window_.deviceSet(), std::move(session));
  const auto visit = controller.session().visit();
  QSignalSpy changes(&controller, &SessionController::stepChanged);
  QSignalSpy failures(&controller, &SessionController::failed);
  controller.finishStep();
  EXPECT_EQ(failures.count(), 1);
  EXPECT_EQ(changes.count(), 0) << "the page changed although the step was not saved";
  EXPECT_EQ(controller.session().visit(), visit);
}

TEST_F(PunchSession, StopsWhenTheOperatorPressesStop) {
  participant_.goTo(StepKind::Trial);
  participant_.cut(1);
  QTest::mouseClick(window_.findChild<ControlPanel*>()->stopButton(), Qt::LeftButton);
  EXPECT_FALSE(window_.controller()->isTrialRunning());
  EXPECT_EQ(window_.controller()->session().state(), SessionState::Interrupted);
  EXPECT_EQ(storage::Records(study_.database()).trials().back().ending, TrialEnding::Stopped);
}

TEST_F(PunchSession, StopsOnEscapeInTheParticipantsWindowToo) {
  participant_.goTo(StepKind::Trial);
  participant_.cut(1);
  QTest::keyClick(window_.participantWindow()->findChild<TrialPage*>(), Qt::Key_Escape);
  EXPECT_EQ(window_.controller()->session().state(), SessionState::Interrupted);
}

TEST_F(PunchSession, MarksATrialWhoseDeviceDisconnectsAndOffersItAgain) {
  participant_.goTo(StepKind::Trial);
  const auto step = window_.controller()->session().stepIndex();
  participant_.cut(1);
  dynamic_cast<SimulatedDeviceSet&>(window_.deviceSet()).unplug("punch");
  ASSERT_TRUE(QTest::qWaitFor([&] { return !window_.controller()->isTrialRunning(); }, 2000));
  EXPECT_EQ(storage::Records(study_.database()).trials().back().ending, TrialEnding::DeviceGone);
  EXPECT_EQ(window_.controller()->session().state(), SessionState::Interrupted);

  dynamic_cast<SimulatedDeviceSet&>(window_.deviceSet()).plugIn("punch");
  window_.controller()->repeatStep(QStringLiteral("cable"));
  EXPECT_EQ(window_.controller()->session().stepIndex(), step);
  participant_.doStep();
  EXPECT_EQ(window_.controller()->session().stepIndex(), step + 1);
}

TEST_F(PunchSession, StopsWhileTheOperatorTypesANote) {
  participant_.goTo(StepKind::Trial);
  participant_.cut(1);
  auto* note = window_.findChild<QLineEdit*>();
  QTest::keyClicks(note, QStringLiteral("the cable hu"));
  QTest::keyClick(note, Qt::Key_Escape);
  EXPECT_EQ(window_.controller()->session().state(), SessionState::Interrupted);
  QTest::keyClick(note, Qt::Key_Return);
  ASSERT_EQ(window_.controller()->notes().size(), 1U) << "the typed note is saved";
  EXPECT_EQ(window_.controller()->notes().front().text, QStringLiteral("the cable hu"));
}

TEST_F(PunchSession, ShowsAttemptsAndSkippedSteps) {
  participant_.goTo(StepKind::Trial);
  const int trial = window_.controller()->session().stepIndex();
  participant_.cut(1);
  const auto* timeline = window_.findChild<TimelineTable*>();
  EXPECT_EQ(timeline->item(trial, 4)->text(), QStringLiteral("● running"));
  window_.controller()->stop();
  EXPECT_EQ(timeline->item(trial, 4)->text(), QStringLiteral("✖ broke off"));
  window_.controller()->repeatStep(QStringLiteral("stopped by mistake"));
  EXPECT_EQ(timeline->item(trial - 1, 4)->text(), QStringLiteral("done"));
  EXPECT_EQ(timeline->item(trial, 3)->text(), QStringLiteral("2"));
  EXPECT_EQ(timeline->item(trial, 4)->text(), QStringLiteral("▶ now"));
  window_.controller()->skipStep(QStringLiteral("no time"));
  EXPECT_EQ(timeline->item(trial, 4)->text(), QStringLiteral("skipped"));
  EXPECT_EQ(timeline->item(trial + 1, 4)->text(), QStringLiteral("skipped"))
      << "the questions about the trial";
}

TEST_F(PunchSession, MirrorsTheParticipantsPageOnRequest) {
  participant_.takePart(1);
  auto* mirror = window_.findChild<PageMirror*>();
  const auto* picture = mirror->findChild<QLabel*>();
  EXPECT_FALSE(mirror->isVisible());
  window_.findChild<QAction*>(QStringLiteral("show-mirror"))->trigger();
  EXPECT_TRUE(mirror->isVisible());
  QCoreApplication::processEvents();
  const auto page = window_.participantWindow()->size();
  const auto shown = picture->pixmap(Qt::ReturnByValue).size();
  ASSERT_FALSE(shown.isEmpty());
  EXPECT_NEAR(
      static_cast<double>(shown.width()) / shown.height(),
      static_cast<double>(page.width()) / page.height(),
      0.02);
  mirror->setPage(nullptr);
  EXPECT_EQ(picture->text(), QStringLiteral("No session is open."));
}

TEST_F(PunchSession, RefusesToCloseWhileATrialRuns) {
  participant_.goTo(StepKind::Trial);
  participant_.cut(1);
  EXPECT_FALSE(window_.participantWindow()->close());
  window_.controller()->stop();
}

TEST_F(PunchSession, KeepsAnswersWhenTheLanguageIsSwitched) {
  participant_.takePart(1);  // at the consent form
  const auto before = window_.controller()->session().answers();
  participant_.look();
  auto* first = window_.participantWindow()->findChild<OptionButtons*>();
  QTest::mouseClick(first->button(0), Qt::LeftButton);
  window_.controller()->chooseLanguage(QStringLiteral("de"));
  QCoreApplication::processEvents();
  EXPECT_EQ(window_.controller()->session().answers().size(), before.size() + 1);
  EXPECT_EQ(window_.participantWindow()->findChild<OptionButtons*>()->chosen(), 0);
  EXPECT_NE(buttonSaying(window_.participantWindow(), QStringLiteral("Weiter")), nullptr);
}

TEST_F(PunchSession, EndsAfterDeclinedConsent) {
  participant_.takePart(1);  // at the consent form
  auto* consent = window_.participantWindow()->findChild<OptionButtons*>();
  QTest::mouseClick(consent->button(1), Qt::LeftButton);
  const auto rest = window_.participantWindow()->findChildren<OptionButtons*>();
  for (auto* other : rest) {
    if (other != consent) QTest::mouseClick(other->button(1), Qt::LeftButton);
  }
  QTest::mouseClick(
      buttonSaying(window_.participantWindow(), QStringLiteral("Next")), Qt::LeftButton);
  QCoreApplication::processEvents();
  EXPECT_EQ(window_.controller()->session().state(), SessionState::Declined);
  const auto words = tests::wordsIn(*window_.participantWindow());
  EXPECT_EQ(words.count(QStringLiteral("You do not take part")), 1U);
  EXPECT_EQ(buttonSaying(window_.participantWindow(), QStringLiteral("Next")), nullptr);
  participant_.look();
}

TEST_F(PunchSession, ResumesAtItsStepAfterTheWindowsWereClosed) {
  participant_.takePart(3);
  const auto id = window_.controller()->session().id();
  const int step = window_.controller()->session().stepIndex();
  ASSERT_TRUE(window_.close());
  window_.show();
  window_.resume(id);
  ASSERT_NE(window_.controller(), nullptr);
  EXPECT_EQ(window_.controller()->session().stepIndex(), step);
}

}  // namespace punch_session_test
}  // namespace study::gui
