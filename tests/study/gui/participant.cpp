#include "tests/study/gui/participant.h"

#include <cstdlib>

#include <QAbstractButton>
#include <QCoreApplication>
#include <QElapsedTimer>
#include <QLabel>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QTest>

#include "study/gui/answer_slider.h"
#include "study/gui/feel_page.h"
#include "study/gui/option_buttons.h"

namespace tests {

using study::StepKind;
using study::gui::AnswerSlider;
using study::gui::FeelPage;
using study::gui::OptionButtons;

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
  seen_.insert(page()->windowTitle());
  for (auto* widget : page()->findChildren<QWidget*>()) {
    for (const auto& words :
         {widget->accessibleName(),
          widget->accessibleDescription(),
          widget->toolTip(),
          widget->objectName(),
          widget->windowTitle(),
          widget->statusTip(),
          widget->whatsThis()}) {
      seen_.insert(words);
    }
    if (auto* label = qobject_cast<QLabel*>(widget)) seen_.insert(label->text());
    if (auto* button = qobject_cast<QAbstractButton*>(widget)) seen_.insert(button->text());
    if (auto* line = qobject_cast<QLineEdit*>(widget)) seen_.insert(line->placeholderText());
  }
  photograph();
}

/// With PALPATE_PICTURES=FOLDER every page is saved there, for people to look at.
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
    QTest::mouseClick(buttons->button(0), Qt::LeftButton);
  }
  for (auto* slider : page()->findChildren<AnswerSlider*>())
    QTest::mouseClick(slider, Qt::LeftButton);
  for (auto* line : page()->findChildren<QLineEdit*>())
    QTest::keyClicks(line, QStringLiteral("12"));
  for (auto* lines : page()->findChildren<QPlainTextEdit*>()) {
    QTest::keyClicks(lines, QStringLiteral("It felt real."));
  }
}

void Participant::cut(int cuts) {
  QCoreApplication::processEvents();  // the page may be new
  auto* feel = page()->findChild<FeelPage*>();
  auto* controller = window_.controller();
  QTest::mouseClick(buttonSaying(feel, QStringLiteral("Begin")), Qt::LeftButton);
  for (int made = controller->trialStatus().cuts; made < cuts;) {
    QTest::keyPress(feel, Qt::Key_Space);
    waitFor([&] { return controller->trialStatus().travel > 10.0; }, 2000);
    QTest::keyRelease(feel, Qt::Key_Space);
    waitFor([&] { return controller->trialStatus().travel < 2.0; }, 2000);
    made = controller->trialStatus().cuts;
  }
}

void Participant::doStep() {
  look();
  const auto& step = window_.controller()->session().step();
  if (step.kind == StepKind::Trial) {
    cut(step.minimumCuts);
    look();
    auto* enough = buttonSaying(page(), QStringLiteral("I have felt enough"));
    waitFor([&] { return enough->isEnabled(); }, 2000);
    QTest::mouseClick(enough, Qt::LeftButton);
    return;
  }
  if (step.kind == StepKind::Benchmark) {
    auto* made = buttonSaying(page(), QStringLiteral("I have made a cut"));
    for (int i = 0; i < step.minimumCuts; ++i) QTest::mouseClick(made, Qt::LeftButton);
  } else {
    answerAll();
  }
  look();
  QTest::mouseClick(buttonSaying(page(), QStringLiteral("Next")), Qt::LeftButton);
}

void Participant::takePart(int stopBefore) {
  const auto& session = window_.controller()->session();
  while (!session.isOver() && session.stepIndex() != stopBefore) {
    const int before = session.stepIndex();
    doStep();
    if (session.stepIndex() == before && !session.isOver()) return;  // stuck: the test will say so
  }
  if (session.isOver()) look();
}

}  // namespace tests
