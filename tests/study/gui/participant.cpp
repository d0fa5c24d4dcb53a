#include "tests/study/gui/participant.h"

#include <cstdlib>

#include <gtest/gtest.h>

#include <QAbstractButton>
#include <QComboBox>
#include <QCoreApplication>
#include <QElapsedTimer>
#include <QLineEdit>
#include <QMouseEvent>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QTest>

#include "study/gui/participant/answer_slider.h"
#include "study/gui/participant/option_buttons.h"
#include "study/gui/participant/trial_page.h"
#include "study/session/trial_setup.h"
#include "tests/study/gui/visible_words.h"

namespace tests {

using study::StepKind;
using study::gui::AnswerSlider;
using study::gui::OptionButtons;
using study::gui::TrialPage;

void chooseFirstCohort(study::gui::OperatorWindow& window) {
  for (auto* box : window.findChildren<QComboBox*>()) {
    if (box->accessibleName() == QStringLiteral("Cohort")) box->setCurrentIndex(1);
  }
}

QPushButton* buttonSaying(QWidget* parent, const QString& text) {
  for (auto* button : parent->findChildren<QPushButton*>()) {
    if (button->isVisible() && button->text() == text) return button;
  }
  return nullptr;
}

void photograph(QWidget& window, const QString& name) {
  const char* folder = std::getenv("PALPATE_PICTURES");
  if (folder == nullptr) return;
  window.grab().save(QStringLiteral("%1/%2.png").arg(QString::fromUtf8(folder), name));
}

QWidget* Participant::page() const {
  return window_.participantWindow();
}

bool Participant::waitFor(const std::function<bool()>& condition, int milliseconds) const {
  return QTest::qWaitFor(condition, milliseconds);
}

void Participant::look() {
  QCoreApplication::processEvents();
  seen_.merge(wordsIn(*page()));
  seenByOperator_.merge(wordsIn(window_));
  photograph();
}

/// Saves each page as a picture if PALPATE_PICTURES=FOLDER is set.
void Participant::photograph() {
  const char* folder = std::getenv("PALPATE_PICTURES");
  if (folder == nullptr) return;
  QTest::qWait(50);
  const auto name = QStringLiteral("%1/page-%2.png")
                        .arg(QString::fromUtf8(folder))
                        .arg(++pictures_, 2, 10, QLatin1Char('0'));
  page()->grab().save(name);
  window_.grab().save(QString(name).replace(QStringLiteral("page"), QStringLiteral("operator")));
}

void Participant::answerAll() {
  for (auto* buttons : page()->findChildren<OptionButtons*>()) {
    if (buttons->isVisible()) QTest::mouseClick(buttons->button(0), Qt::LeftButton);
  }
  for (auto* slider : page()->findChildren<AnswerSlider*>()) {
    if (slider->isVisible()) QTest::mouseClick(slider, Qt::LeftButton);
  }
  for (auto* line : page()->findChildren<QLineEdit*>()) {
    const bool isOpen = line->isVisible() && line->text().isEmpty();
    const bool isNumber = words_.isEmpty() || line->property("role") == QStringLiteral("number");
    if (isOpen) QTest::keyClicks(line, isNumber ? QStringLiteral("12") : words_);
  }
  for (auto* lines : page()->findChildren<QPlainTextEdit*>()) {
    const bool isOpen = lines->isVisible() && lines->toPlainText().isEmpty();
    if (isOpen)
      QTest::keyClicks(lines, words_.isEmpty() ? QStringLiteral("It felt real.") : words_);
  }
}

/// One event of a drag with the left button, @p y pixels below the top of the page.
static void drag(QWidget& page, QEvent::Type type, int y) {
  const QPointF place(10.0, y);
  const bool isMove = type == QEvent::MouseMove;
  QMouseEvent event(
      type,
      place,
      page.mapToGlobal(place),
      isMove ? Qt::NoButton : Qt::LeftButton,
      type == QEvent::MouseButtonRelease ? Qt::NoButton : Qt::LeftButton,
      Qt::NoModifier);
  QCoreApplication::sendEvent(&page, &event);
}

void Participant::cut(int cuts) {
  QCoreApplication::processEvents();  // the page may be new
  auto* feel = page()->findChild<TrialPage*>();
  auto* controller = window_.controller();
  const double far = study::pointerReachFor(study::deviceFor(controller->session()));
  QTest::mouseClick(buttonSaying(feel, QStringLiteral("Begin")), Qt::LeftButton);
  for (int made = controller->trialStatus().cuts; made < cuts;) {
    drag(*feel, QEvent::MouseButtonPress, 0);  // the space bar would take its time
    drag(*feel, QEvent::MouseMove, 300);
    double before = -1.0;
    // A stroke does not go through bone at once: it also ends when the hand stops moving.
    const auto isThrough = [&] {
      const double travel = controller->trialStatus().travel;
      const bool isAtRest = travel > 0.25 * far && travel - before < 1e-3 * far;
      before = travel;
      return travel > 0.75 * far || isAtRest;
    };
    waitFor(isThrough, 10'000);  // a reamer goes through some millimetres a second
    drag(*feel, QEvent::MouseButtonRelease, 300);
    waitFor([&] { return controller->trialStatus().travel < 0.04 * far; }, 2000);
    made = controller->trialStatus().cuts;
  }
}

void Participant::doInterview() {
  for (auto* lines : window_.findChildren<QPlainTextEdit*>()) {
    const bool isOpen = lines->isVisible();
    if (isOpen) QTest::keyClicks(lines, words_.isEmpty() ? QStringLiteral("Like bone.") : words_);
  }
  for (auto* buttons : window_.findChildren<OptionButtons*>()) {
    QTest::mouseClick(buttons->button(0), Qt::LeftButton);
  }
  look();
  QTest::mouseClick(buttonSaying(&window_, QStringLiteral("Interview done")), Qt::LeftButton);
}

void Participant::doStep() {
  look();
  const auto& step = window_.controller()->session().step();
  if (step.kind == StepKind::Trial) {
    cut(step.minimumCuts);
    look();
    auto* enough = buttonSaying(page(), QStringLiteral("Done"));
    waitFor([&] { return enough->isEnabled(); }, 2000);
    QTest::mouseClick(enough, Qt::LeftButton);
    return;
  }
  if (step.kind == StepKind::Interview) {
    doInterview();
    return;
  }
  if (step.kind == StepKind::Benchmark) {
    auto* count = buttonSaying(&window_, QStringLiteral("Count a cut (F9)"));
    for (int i = 0; i < step.minimumCuts; ++i) QTest::mouseClick(count, Qt::LeftButton);
    look();
    goOn();
    return;
  }
  // A questionnaire has pages, and an answer may lead to another question.
  constexpr int kMostPages = 8;
  const auto& session = window_.controller()->session();
  const int before = session.stepIndex();
  for (int i = 0; i < kMostPages && !session.isOver() && session.stepIndex() == before; ++i) {
    answerAll();
    look();
    goOn();
  }
}

void Participant::goOn() {
  auto* next = buttonSaying(page(), QStringLiteral("Next"));
  if (next == nullptr) next = buttonSaying(page(), QStringLiteral("Finish"));
  QTest::mouseClick(next, Qt::LeftButton);
  QCoreApplication::processEvents();
}

void Participant::goTo(StepKind kind) {
  const auto& session = window_.controller()->session();
  int step = 0;
  while (session.plan()[static_cast<std::size_t>(step)].kind != kind) ++step;
  takePart(step);
  EXPECT_EQ(session.stepIndex(), step);
}

void Participant::takePart(int stopBefore) {
  const auto& session = window_.controller()->session();
  while (!session.isOver() && session.stepIndex() != stopBefore) {
    const int before = session.stepIndex();
    doStep();
    if (session.stepIndex() == before && !session.isOver())
      return;  // no progress: the test will report it
  }
  if (session.isOver()) look();
}

}  // namespace tests
