// Walks through the participant's pages: what can be read, reached and seen.
#include <cstdlib>
#include <set>
#include <string>

#include <gtest/gtest.h>

#include <QApplication>
#include <QTest>

#include "protocols/load_protocol.h"
#include "study/gui/operator/operator_window.h"
#include "study/gui/participant/participant_window.h"
#include "study/gui/session/session_controller.h"
#include "tests/study/gui/participant.h"
#include "tests/study/gui/pictures.h"
#include "tests/study/gui/window_checks.h"
#include "tests/study/known_secret.h"
#include "tests/study/made_study.h"
#include "tests/support/scratch_folder.h"

namespace study::gui {
namespace participant_walk_test {

/// The participant's window at each step of a session.
TEST(ParticipantWalk, HasNoFlawOnAnyPageInAnyLanguage) {
  tests::ScratchFolder folder;
  SystemClock clock;
  questionnaires::Problems problems;
  const auto protocol = *protocols::loadProtocolFile("punch-face-validity", problems);
  Study::create(folder / "study", tests::filledIn(protocol), clock, 7, tests::knownSecret());
  auto study = Study::open(folder / "study", clock);
  OperatorWindow window(study);
  window.enrol({.cohort = "professional", .runMode = RunMode::Pilot, .language = "en", .code = {}});
  window.setWindowState(Qt::WindowNoState);
  tests::Participant participant(window);
  participant.writes(QStringLiteral("A. Example"));
  window.show();
  const auto& session = window.controller()->session();
  auto& page = *window.participantWindow();
  std::set<StepKind> seen;
  for (bool isOver = false; !isOver;) {
    isOver = session.isOver();
    const bool isNew = isOver || seen.insert(session.step().kind).second;
    if (isNew) {
      const auto where = isOver ? std::string("end") : std::string(nameOf(session.step().kind));
      page.activateWindow();
      const auto expectNone = [&](const QStringList& flaws) {
        for (const auto& flaw : flaws) ADD_FAILURE() << where << ": " << flaw.toStdString();
      };
      const auto photograph = [&](const std::string& language) {
        // Pictures of instruments are drawn a moment after the page.
        if (std::getenv("PALPATE_PICTURES") != nullptr) QTest::qWait(60);
        const auto name = QString::fromStdString("walk-" + where + "-" + language);
        tests::photograph(page, name + QString::number(page.width()));
      };
      expectNone(tests::unreadableTexts(page, 4.5));
      expectNone(tests::unnamedElements(page));
      if (!isOver) expectNone(tests::lostFocus(page));
      for (const auto& language : session.protocol().protocol.languages) {
        if (isOver || language == session.language()) continue;
        const auto before = QString::fromStdString(session.language());
        window.controller()->chooseLanguage(QString::fromStdString(language));
        QApplication::processEvents();
        EXPECT_EQ(session.language(), language) << where;
        for (const QSize screen : {QSize(683, 384), QSize(1280, 720)}) {
          expectNone(tests::cutOffAt(page, screen));
          photograph(language + "-");
        }
        window.controller()->chooseLanguage(before);
        QApplication::processEvents();
      }
      for (const QSize screen :
           {QSize(683, 384),
            QSize(960, 540),
            QSize(1024, 700),
            QSize(1366, 768),
            QSize(1920, 1080),
            QSize(3840, 2160)}) {
        expectNone(tests::cutOffAt(page, screen));
        photograph("");
      }
    }
    if (isOver) break;
    // A questionnaire about a trial comes only after one that was carried out.
    const bool isFirstTrial = isNew && session.step().kind == StepKind::Trial;
    if (!isFirstTrial && session.allows(SessionEvent::SkippedStep)) {
      window.controller()->skipStep(QStringLiteral("walking on"));
    } else {
      participant.doStep();
    }
    QApplication::processEvents();
  }
  EXPECT_GE(seen.size(), 7U);
}

}  // namespace participant_walk_test
}  // namespace study::gui
