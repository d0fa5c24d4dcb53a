// Whether the operator's window fits the smallest screens in laboratories.
#include <algorithm>
#include <filesystem>

#include <gtest/gtest.h>

#include <QAbstractButton>
#include <QApplication>
#include <QComboBox>
#include <QCoreApplication>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QTableView>
#include <QTableWidget>
#include <QTest>
#include <QTimer>

#include "haptics/engine/force_limiter.h"
#include "haptics/engine/sample_ring.h"
#include "protocols/load_protocol.h"
#include "protocols/model/loaded_protocol.h"
#include "study/gui/operator/control_panel.h"
#include "study/gui/operator/cut_table.h"
#include "study/gui/operator/live_plot.h"
#include "study/gui/operator/operator_window.h"
#include "study/gui/operator/page_mirror.h"
#include "study/gui/operator/servo_panel.h"
#include "study/gui/operator/sessions_page.h"
#include "study/gui/operator/timeline_table.h"
#include "study/gui/operator/trial_panel.h"
#include "study/gui/operator/window_geometries.h"
#include "study/gui/session/station_push.h"
#include "study/gui/widgets/desk_language.h"
#include "study/model/new_file.h"
#include "study/session/arrivals.h"
#include "tests/study/gui/participant.h"
#include "tests/study/known_secret.h"
#include "tests/study/made_study.h"
#include "tests/support/scratch_folder.h"

namespace study::gui {
namespace operator_layout_test {

constexpr QSize kLowScreen(1280, 720);  // 1280×800 less a desktop's bars
constexpr QSize kLargePrint(960, 540);  // 1920×1080 at a scale of 2
constexpr QSize kWideScreen(1920, 1040);

protocols::LoadedProtocol shipped(const std::string& name) {
  questionnaires::Problems problems;
  return *protocols::loadProtocolFile(name, problems);
}

class OperatorLayout : public testing::Test {
 protected:
  explicit OperatorLayout(const std::string& protocol = "punch-face-validity")
      : study_(Study::create(
            folder_ / "study",
            tests::filledIn(shipped(protocol)),
            clock_,
            7,
            tests::knownSecret())) {}

  void SetUp() override {
    window_.setWindowState(
        Qt::WindowNoState);  // otherwise it is maximised on the test's small screen
    window_.show();
  }

  void enrol() {
    window_.enrol(
        {.cohort = "professional", .runMode = RunMode::Pilot, .language = "en", .code = {}});
  }

  void show(const QSize& size) {
    window_.resize(size);
    QTest::qWait(20);
    ASSERT_EQ(window_.size(), size) << "the contents do not fit";
  }

  /// The controls and fields that are not completely visible, or whose text is cut off.
  QStringList cutOff() {
    QStringList names;
    for (auto* widget : window_.findChildren<QWidget*>()) {
      const bool isPressed = qobject_cast<QAbstractButton*>(widget) != nullptr ||
                             qobject_cast<QComboBox*>(widget) != nullptr ||
                             qobject_cast<QLineEdit*>(widget) != nullptr;
      const bool isOfATable = qobject_cast<QTableView*>(widget->parentWidget()) != nullptr;
      if (!isPressed || isOfATable || !widget->isVisible()) continue;
      const auto* button = qobject_cast<QPushButton*>(widget);
      const bool isWritten = button == nullptr || button->sizeHint().width() <= button->width();
      const bool isInSight = widget->visibleRegion().boundingRect() == widget->rect();
      if (isWritten && isInSight) continue;
      names << (button != nullptr ? button->text() : widget->accessibleName()) +
                   (isInSight ? QStringLiteral(" (words)") : QStringLiteral(" (place)"));
    }
    return names;
  }

  void expectAllInSight(const QString& name) {
    for (const auto& [size, screen] :
         {std::pair(kLowScreen, "low"), std::pair(kWideScreen, "wide")}) {
      show(size);
      EXPECT_EQ(cutOff().join(u';').toStdString(), "") << name.toStdString() << ", " << screen;
      tests::photograph(window_, QStringLiteral("%1-%2").arg(name, QString::fromUtf8(screen)));
    }
    show(kLargePrint);
    tests::photograph(window_, name + QStringLiteral("-large-print"));
    const auto* stop = window_.findChild<ControlPanel*>()->stopButton();
    if (window_.controller() == nullptr) return;
    EXPECT_EQ(stop->visibleRegion().boundingRect(), stop->rect()) << name.toStdString();
  }

  tests::ScratchFolder folder_;
  SystemClock clock_;
  Study study_;
  OperatorWindow window_{study_};
  tests::Participant participant_{window_};
};

class OperatorLayoutWithInterview : public OperatorLayout {
 protected:
  OperatorLayoutWithInterview() : OperatorLayout("punch-counterbalanced") {}
};

TEST_F(OperatorLayout, ShowsEverythingBetweenSessions) {
  expectAllInSight(QStringLiteral("between-empty"));
  enrol();
  window_.findChild<ControlPanel*>()->closeSessionRequested();
  ASSERT_EQ(window_.controller(), nullptr);
  auto* table = window_.findChild<SessionsPage*>()->findChild<QTableWidget*>();
  table->selectRow(0);
  expectAllInSight(QStringLiteral("between"));
}

TEST_F(OperatorLayout, NamesTheNextParticipantAndClosesTheStudy) {
  const auto* code = window_.findChild<QLabel*>(QStringLiteral("next-code"));
  EXPECT_EQ(code->text(), QStringLiteral("Code: PILOT-001")) << "devices are virtual";
  enrol();
  window_.findChild<ControlPanel*>()->closeSessionRequested();
  EXPECT_EQ(code->text(), QStringLiteral("Code: PILOT-002"));
  tests::buttonSaying(&window_, QStringLiteral("Close study"))->click();
  EXPECT_FALSE(window_.isVisible());
}

TEST_F(OperatorLayout, ShowsTheRowsOfSessionsWhole) {
  enrol();
  window_.findChild<ControlPanel*>()->closeSessionRequested();
  const auto* table = window_.findChild<SessionsPage*>()->findChild<QTableWidget*>();
  for (const QSize size : {kLowScreen, kWideScreen, kLowScreen}) {
    window_.resize(size);
    QTest::qWait(50);
    EXPECT_GE(table->viewport()->height(), table->verticalHeader()->length()) << size.width();
  }
}

TEST_F(OperatorLayout, EndsTheUnfinishedSessionThatIsSelected) {
  enrol();
  const auto id = window_.controller()->session().id();
  window_.findChild<ControlPanel*>()->closeSessionRequested();
  auto* page = window_.findChild<SessionsPage*>();
  EXPECT_EQ(
      tests::buttonSaying(page, QStringLiteral("Continue session"))->property("role").toString(),
      QStringLiteral("main"))
      << "the session is selected";
  EXPECT_EQ(tests::buttonSaying(page, QStringLiteral("Device failed…")), nullptr)
      << "no trial broke off";
  QTimer answer;
  QObject::connect(&answer, &QTimer::timeout, &answer, [&] {
    auto* box = QApplication::activeModalWidget();
    if (box == nullptr) return;
    answer.stop();
    QTest::keyClicks(box->findChild<QLineEdit*>(), QStringLiteral("went home"));
    box->findChild<QPushButton*>(QStringLiteral("action"))->click();
  });
  answer.start(20);
  tests::buttonSaying(page, QStringLiteral("Participant withdraws…"))->click();
  EXPECT_EQ(study_.sessions().load(id).state, SessionState::Withdrawn);
  EXPECT_EQ(tests::buttonSaying(page, QStringLiteral("Participant withdraws…")), nullptr);
  EXPECT_EQ(
      tests::buttonSaying(page, QStringLiteral("New participant"))->property("role").toString(),
      QStringLiteral("main"));
}

/// The windows have no connection to a server; the other program notes what became of the push.
TEST(Station, PushesInTheBackgroundAfterEachSession) {
  const auto bin = std::filesystem::path(QCoreApplication::applicationDirPath().toStdString());
  if (!std::filesystem::exists(bin / "palpate-collect")) GTEST_SKIP() << "built without PostgreSQL";
  const tests::ScratchFolder folder;
  const tests::OwnStation account(folder / "account");
  SystemClock clock;
  auto study = Study::create(
      folder / "study",
      shipped("punch-face-validity"),
      clock,
      7,
      tests::knownSecret(),
      {.site = "oslo", .label = "oslo", .uuid = "11"});
  writeNewFile(
      folder / "study/collect.json",
      R"({"server": "host=/nowhere", "role": "station_oslo", "bundle_key": ""})");
  OperatorWindow window(study);
  window.show();
  window.enrol({.cohort = "professional", .language = "en", .code = {}});
  window.findChild<ControlPanel*>()->closeSessionRequested();
  constexpr int kPatience = 20'000;
  EXPECT_TRUE(QTest::qWaitFor(
      [&] { return lastPush(study.uuid(), "11").problem == "unreachable"; }, kPatience));
}

/// A station's study with a session that has not arrived, and no server that can be reached.
class StationDesk : public testing::Test {
 protected:
  void SetUp() override {
    const auto bin = std::filesystem::path(QCoreApplication::applicationDirPath().toStdString());
    if (!std::filesystem::exists(bin / "palpate-collect"))
      GTEST_SKIP() << "built without PostgreSQL";
    writeNewFile(
        folder_ / "study/collect.json",
        R"({"server": "host=/nowhere", "role": "station_oslo", "bundle_key": ""})");
    auto session = Session::enrol(
        study_, {.cohort = "professional", .runMode = RunMode::Live, .language = "en", .code = {}});
  }

  std::string problem() { return lastPush(study_.uuid(), "11").problem; }

  static constexpr int kPatience = 20'000;
  static constexpr int kSoon = 20;
  tests::ScratchFolder folder_;
  tests::OwnStation account_{folder_ / "account"};
  SystemClock clock_;
  Study study_{Study::create(
      folder_ / "study",
      shipped("punch-face-validity"),
      clock_,
      7,
      tests::knownSecret(),
      {.site = "oslo", .label = "oslo", .uuid = "11"})};
};

TEST_F(StationDesk, ShowsTheSiteOfASessionAndSendsOnRequest) {
  OperatorWindow window(study_);
  window.setWindowState(Qt::WindowNoState);
  window.resize(1280, 720);
  window.show();
  const auto* table = window.findChild<SessionsPage*>()->findChild<QTableWidget*>();
  EXPECT_FALSE(table->isColumnHidden(1));
  EXPECT_EQ(table->item(0, 1)->text(), QStringLiteral("oslo"));
  const auto* arrived = window.findChild<QLabel*>(QStringLiteral("arrived"));
  EXPECT_TRUE(arrived->text().contains(QStringLiteral("Arrived: 0")));
  auto* send = window.findChild<QPushButton*>(QStringLiteral("send"));
  QTest::mouseClick(send, Qt::LeftButton);
  EXPECT_FALSE(send->isEnabled()) << "it is sending";
  EXPECT_TRUE(QTest::qWaitFor([&] { return send->isEnabled(); }, kPatience));
  EXPECT_EQ(problem(), "unreachable");
  EXPECT_TRUE(arrived->text().contains(QStringLiteral("no network")));
}

TEST_F(StationDesk, SendsAgainByItselfButNotDuringATrial) {
  bool isBusy = true;
  int askedOften = 0;
  StationPush push(
      study_,
      [&] {
        ++askedOften;
        return isBusy;
      },
      kSoon);
  EXPECT_TRUE(QTest::qWaitFor([&] { return askedOften > 2; }, kPatience));
  EXPECT_FALSE(push.isSending());
  isBusy = false;
  EXPECT_TRUE(QTest::qWaitFor([&] { return problem() == "unreachable"; }, kPatience));
}

TEST_F(OperatorLayout, IsInTheLanguageThatIsChosenBetweenSessions) {
  constexpr int kPatience = 20'000;
  const auto choose = [&](const char* tag) {
    window_.findChild<QAction*>(QStringLiteral("language-") + QString::fromUtf8(tag))->trigger();
  };
  const auto says = [&](const char* words) {
    const auto wanted = QString::fromUtf8(words);
    return QTest::qWaitFor(
        [&] { return tests::buttonSaying(&window_, wanted) != nullptr; }, kPatience);
  };
  choose("de");
  EXPECT_TRUE(says("Sitzung fortsetzen"));
  enrol();
  EXPECT_TRUE(says("Schließen"));
  window_.findChild<ControlPanel*>()->closeSessionRequested();
  choose("en");
  EXPECT_TRUE(says("Continue session"));
}

TEST_F(OperatorLayout, ShowsEverythingInASession) {
  enrol();
  expectAllInSight(QStringLiteral("in-session"));
  const auto places = windowGeometriesOn({0, 0, 1920, 1080});
  window_.participantWindow()->resize(places->participant.size());
  participant_.goTo(StepKind::Trial);
  participant_.cut(2);
  expectAllInSight(QStringLiteral("in-trial"));
  show(places->own.size());
  tests::photograph(window_, QStringLiteral("in-trial-tiled"));
  tests::photograph(*window_.participantWindow(), QStringLiteral("in-trial-participant"));
  auto* mirror = window_.findChild<PageMirror*>();
  mirror->show();
  EXPECT_FALSE(mirror->findChild<QLabel*>()->pixmap().isNull());
  tests::photograph(*mirror, QStringLiteral("mirror"));
  mirror->hide();
  window_.controller()->stop();
  expectAllInSight(QStringLiteral("broken-off"));
}

/// Half of a usual screen, and the screen of a small laptop, without the desktop's frame.
TEST_F(OperatorLayout, ShowsATrialWithoutScrollingFromHalfAScreen) {
  enrol();
  participant_.goTo(StepKind::Trial);
  participant_.cut(1);
  for (const QSize size : {QSize(960, 1000), QSize(1366, 728)}) {
    show(size);
    for (QWidget* seen :
         {static_cast<QWidget*>(window_.findChild<ControlPanel*>()->stopButton()),
          window_.findChild<QWidget*>(QStringLiteral("state")),
          window_.findChild<QWidget*>(QStringLiteral("count")),
          window_.findChild<QWidget*>(QStringLiteral("timing")),
          window_.findChild<LivePlot*>()->findChild<QWidget*>(),  // which covers it
          window_.findChild<CutTable*>()->viewport()}) {
      EXPECT_EQ(seen->visibleRegion().boundingRect(), seen->rect())
          << size.width() << ' ' << seen->objectName().toStdString();
    }
    const auto* cuts = window_.findChild<CutTable*>();
    EXPECT_LE(cuts->horizontalHeader()->length(), cuts->viewport()->width()) << size.width();
    tests::photograph(window_, QStringLiteral("in-trial-%1").arg(size.width()));
  }
  window_.controller()->stop();
}

TEST_F(OperatorLayout, ScrollsTheStepsOrTheButtonsAboveThemButNotBoth) {
  enrol();
  const auto* controls = window_.findChild<ControlPanel*>();
  const auto* steps = controls->findChild<TimelineTable*>();
  const auto* outer = controls->findChild<QScrollArea*>()->verticalScrollBar();
  const auto expectOne = [&](const char* when) {
    for (const QSize size : {kWideScreen, kLowScreen, kLargePrint, QSize(1366, 728), kWideScreen}) {
      show(size);
      QTest::qWait(20);  // heights of rows follow
      EXPECT_TRUE(outer->maximum() == 0 || steps->verticalScrollBar()->maximum() == 0)
          << when << ' ' << size.width();
    }
    EXPECT_EQ(outer->maximum(), 0) << "there is room";
  };
  expectOne("before the trial");
  participant_.goTo(StepKind::Trial);
  participant_.cut(1);
  expectOne("in the trial");
  window_.controller()->stop();
}

TEST_F(OperatorLayout, OffersOnlyWhatTheStepAllows) {
  enrol();
  const auto offers = [&](const char* words) {
    return tests::buttonSaying(&window_, QString::fromUtf8(words)) != nullptr;
  };
  EXPECT_FALSE(offers("Interview done") || offers("Skip…")) << "before the consent";
  EXPECT_TRUE(offers("Close session"));
  participant_.goTo(StepKind::Trial);
  EXPECT_TRUE(offers("Skip…") && offers("Pause…"));
  participant_.cut(1);
  EXPECT_FALSE(offers("Skip…") || offers("Pause…") || offers("Close session"));
  EXPECT_TRUE(offers("Participant withdraws…") && offers("Reject session…"));
  ASSERT_TRUE(offers("Device failed…")) << "a device fails while it is used";
  QTimer answer;
  QObject::connect(&answer, &QTimer::timeout, &answer, [&] {
    auto* box = QApplication::activeModalWidget();
    if (box == nullptr) return;
    answer.stop();
    EXPECT_FALSE(window_.controller()->isTrialRunning()) << "the force is off during the question";
    box->findChild<QPushButton*>(QStringLiteral("action"))->click();
  });
  answer.start(20);
  tests::buttonSaying(&window_, QStringLiteral("Device failed…"))->click();
  EXPECT_EQ(window_.controller()->session().state(), SessionState::AbortedHardware);
}

class BlindedSession : public OperatorLayout {
 protected:
  void enrolLive() {
    window_.enrol({.cohort = "professional", .language = "en", .code = {}});
    participant_.goTo(StepKind::Trial);
    participant_.cut(1);
  }

  bool areForcesInSight() {
    return window_.findChild<LivePlot*>()->isVisible() ||
           window_.findChild<CutTable*>()->isVisible();
  }

  /// Chooses "Force curves" in the menu, and answers the question that is asked.
  void chooseForces(const char* answerButton) {
    QTimer answer;
    QObject::connect(&answer, &QTimer::timeout, &answer, [&] {
      auto* box = QApplication::activeModalWidget();
      if (box == nullptr) return;
      answer.stop();
      tests::buttonSaying(box, QString::fromUtf8(answerButton))->click();
    });
    answer.start(20);
    window_.findChild<QAction*>(QStringLiteral("show-forces"))->trigger();
  }

  std::vector<std::string> noted() {
    std::vector<std::string> details;
    for (const auto& event : study_.events().read(EventKind::ShowedForces))
      details.push_back(event.detail);
    return details;
  }
};

TEST_F(BlindedSession, HidesForcesUntilTheyAreAskedForAndNotesThat) {
  enrolLive();
  EXPECT_FALSE(areForcesInSight());
  for (const auto& text : participant_.seenByOperator()) {
    EXPECT_FALSE(
        text.startsWith(QStringLiteral("Force 0")) || text.contains(QStringLiteral("Energy")))
        << text.toStdString();
  }
  EXPECT_TRUE(window_.findChild<QWidget*>(QStringLiteral("timing"))->isVisible());
  tests::photograph(window_, QStringLiteral("in-trial-blinded"));
  chooseForces("Keep them hidden");
  EXPECT_FALSE(areForcesInSight());
  EXPECT_TRUE(noted().empty());
  chooseForces("Show the forces");
  EXPECT_TRUE(areForcesInSight());
  window_.findChild<QAction*>(QStringLiteral("show-forces"))->trigger();
  EXPECT_FALSE(areForcesInSight());
  EXPECT_EQ(noted(), (std::vector<std::string>{"on", "off"}));
  window_.controller()->stop();
}

TEST_F(BlindedSession, ShowsForcesOfAPilot) {
  enrol();
  participant_.goTo(StepKind::Trial);
  participant_.cut(1);
  EXPECT_TRUE(areForcesInSight());
  EXPECT_TRUE(noted().empty());
  window_.controller()->stop();
}

TEST_F(OperatorLayoutWithInterview, HasAllOfItsRightColumnBesideAParticipantsWindow) {
  const auto places = windowGeometriesOn({0, 0, 1920, 1080});
  ASSERT_TRUE(places);
  enrol();
  show(places->own.size());
  const auto expectFits = [&](const char* when) {
    for (const auto* area : window_.findChildren<QScrollArea*>()) {
      const auto* bar = area->horizontalScrollBar();
      if (area->isVisible()) EXPECT_EQ(bar->maximum(), 0) << when;
    }
    EXPECT_EQ(cutOff().join(u';').toStdString(), "") << when;
  };
  participant_.goTo(StepKind::Trial);
  participant_.cut(1);
  auto* servo = window_.findChild<ServoPanel*>();
  servo->findChild<QPushButton*>(QStringLiteral("timing-details"))->click();
  haptics::engine::TickSample late;
  late.lateness = 5000.0F;
  late.interventions = haptics::engine::ForceLimiter::Saturated;
  for (int i = 0; i < 20'000; ++i) servo->add(late);
  servo->refresh();
  QCoreApplication::processEvents();
  expectFits("in a trial with a long line about its timing");
  tests::photograph(window_, QStringLiteral("beside-participant"));
  window_.controller()->stop();
  while (window_.controller()->session().step().kind != StepKind::Interview) {
    window_.controller()->skipStep(QStringLiteral("not needed here"));
  }
  QCoreApplication::processEvents();
  expectFits("in the interview");
  const auto* middle = window_.findChild<TrialPanel*>()->parentWidget()->parentWidget();
  const auto* area = qobject_cast<QScrollArea*>(middle->parentWidget());
  ASSERT_NE(area, nullptr);
  EXPECT_EQ(area->verticalScrollBar()->maximum(), 0) << "the questions scroll by themselves";
  tests::photograph(window_, QStringLiteral("beside-participant-interview"));
  window_.activateWindow();
  ASSERT_TRUE(QTest::qWaitForWindowActive(&window_));
  ASSERT_TRUE(area->isAncestorOf(window_.focusWidget())) << "what is asked next";
  window_.controller()->finishStep();
  EXPECT_FALSE(window_.findChild<ControlPanel*>()->isAncestorOf(window_.focusWidget()))
      << "Enter would press one of its buttons";
}

TEST(WindowGeometries, AreSideBySideOnAScreenWithRoomForTwo) {
  for (const QRect screen : {QRect(0, 30, 1920, 1050), QRect(1920, 0, 3840, 2160)}) {
    const auto places = windowGeometriesOn(screen);
    ASSERT_TRUE(places);
    EXPECT_FALSE(places->own.intersects(places->participant));
    EXPECT_EQ(places->own.united(places->participant), screen);
    EXPECT_GT(places->own.width(), places->participant.width());
  }
  EXPECT_FALSE(windowGeometriesOn({0, 0, 1366, 768}));
}

TEST_F(OperatorLayout, HasItsButtonsWholeWhenASessionBegins) {
  setDeskLanguage("de");  // its words are longer
  OperatorWindow window(study_);
  window.setWindowState(Qt::WindowNoState);
  window.resize(1366, 740);
  window.show();
  QTest::qWait(20);
  window.enrol({.cohort = "professional", .runMode = RunMode::Pilot, .language = "en", .code = {}});
  QTest::qWait(20);
  for (const auto* button : window.findChild<ControlPanel*>()->findChildren<QPushButton*>()) {
    if (!button->isVisible()) continue;
    EXPECT_EQ(button->visibleRegion().boundingRect(), button->rect())
        << button->text().toStdString();
  }
  setDeskLanguage("en");
}

TEST_F(OperatorLayout, LeavesStopInSightBesideTheParticipantsWindowOnASmallScreen) {
  constexpr QRect kSmall(0, 0, 1366, 768);
  const auto place = placeBesideStop(kSmall);
  ASSERT_TRUE(place);
  enrol();
  show(kSmall.size());
  const auto* stop = window_.findChild<ControlPanel*>()->stopButton();
  EXPECT_LT(stop->mapTo(&window_, stop->rect().bottomRight()).x(), place->left());
  EXPECT_LE(window_.participantWindow()->minimumSizeHint().width(), place->width());
  EXPECT_FALSE(placeBesideStop({0, 0, 1024, 768})) << "no room for both";
}

TEST_F(OperatorLayout, KeepsTheFocusOffButtonsThatEndTheSession) {
  enrol();
  window_.activateWindow();
  while (!window_.controller()->session().isOver()) {
    const auto* focused = qobject_cast<QPushButton*>(window_.focusWidget());
    const auto* controls = window_.findChild<ControlPanel*>();
    EXPECT_FALSE(focused != nullptr && controls->isAncestorOf(focused))
        << window_.controller()->session().step().phase << ": " << focused->text().toStdString();
    participant_.doStep();
  }
}

TEST_F(OperatorLayout, ShowsPauseAndContinueInTheSamePlace) {
  enrol();
  window_.setWindowState(Qt::WindowNoState);
  window_.resize(1280, 860);
  participant_.goTo(StepKind::Trial);
  auto* pause = tests::buttonSaying(&window_, QStringLiteral("Pause…"));
  ASSERT_NE(pause, nullptr);
  EXPECT_EQ(tests::buttonSaying(&window_, QStringLiteral("Continue")), nullptr);
  const auto place = pause->geometry();
  window_.controller()->pause(QStringLiteral("coffee"));
  QCoreApplication::processEvents();
  EXPECT_EQ(tests::buttonSaying(&window_, QStringLiteral("Pause…")), nullptr);
  auto* proceed = tests::buttonSaying(&window_, QStringLiteral("Continue"));
  ASSERT_NE(proceed, nullptr);
  EXPECT_EQ(proceed->geometry(), place);
  QTest::mouseClick(proceed, Qt::LeftButton);
  EXPECT_EQ(window_.controller()->session().state(), SessionState::Consented);
}

}  // namespace operator_layout_test
}  // namespace study::gui
