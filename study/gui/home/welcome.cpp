#include "study/gui/home/welcome.h"

#include <QFrame>
#include <QLabel>
#include <QPushButton>
#include <QResizeEvent>

#include "study/gui/widgets/labels.h"

namespace study::gui {

/// A way to begin, with the button that goes there.
struct Welcome::StartOption {
  QString title;
  QString what;
  QString button;
  const char* role;
  void (Welcome::*requestSignal)();
};

Welcome::Welcome(QWidget* parent)
    : QWidget(parent), cards_(new QBoxLayout(QBoxLayout::LeftToRight)) {
  constexpr int kWidest = 1040;  // [px]
  auto* inside = new QWidget(this);
  inside->setMaximumWidth(kWidest);
  auto* lines = withMargins<QVBoxLayout>(inside, {0, 24, 0, 24}, 16);
  lines->addWidget(titleLabel(tr("Welcome to Palpate"), inside));
  auto* what = quietLabel(
      tr("Palpate runs studies of simulators for surgery: people feel each rendering of a cut "
         "without knowing which it is, and say how real it feels."),
      inside);
  auto* sentence = new QHBoxLayout;  // a short line is read more easily
  sentence->addWidget(what, 4);
  sentence->addStretch(1);
  lines->addLayout(sentence);
  lines->addSpacing(8);
  cards_->setSpacing(16);
  lines->addLayout(cards_);
  addCard(
      {tr("Tour"),
       tr("Try a cut with a virtual punch, answer as a participant, and see what is recorded. It "
          "takes two "
          "minutes, and nothing is saved."),
       tr("Tour in three steps…"),
       "",
       &Welcome::tourRequested});
  addCard(
      {tr("System check"),
       tr("Whether this computer's devices, timing, disk and screens are good enough for a study. "
          "It takes a few seconds."),
       tr("System check…"),
       "",
       &Welcome::systemCheckRequested});
  addCard(
      {tr("New study"),
       tr("From a protocol that ships with the program, or from your own. Texts and conditions can "
          "be changed later."),
       tr("New study…"),
       "main",
       &Welcome::newStudyRequested});
  lines->addWidget(makeLinks());
  auto* page = withoutMargins<QVBoxLayout>(this);
  page->addStretch(2);
  auto* middle = new QHBoxLayout;
  middle->addStretch(1);
  middle->addWidget(inside, 100);
  middle->addStretch(1);
  page->addLayout(middle);
  page->addStretch(3);
}

void Welcome::addCard(const StartOption& way) {
  auto* card = new QFrame(this);
  card->setProperty("role", QStringLiteral("card"));
  auto* title = headingLabel(way.title, card);
  auto* button = new QPushButton(way.button, card);
  button->setProperty("role", QString::fromUtf8(way.role));
  button->setAccessibleDescription(way.what);
  auto* lines = withMargins<QVBoxLayout>(card, {20, 18, 20, 20}, 10);
  lines->addWidget(title);
  auto* what = bodyLabel(way.what, card);
  what->setAlignment(Qt::AlignTop | Qt::AlignLeft);
  lines->addWidget(what, 1);
  lines->addSpacing(8);
  lines->addWidget(button);
  if (button->property("role") == QStringLiteral("main")) main_ = button;
  connect(button, &QPushButton::clicked, this, way.requestSignal);
  cards_->addWidget(card, 1);
}

/// Links to actions that are needed less often.
QWidget* Welcome::makeLinks() {
  auto* row = new QWidget(this);
  auto* line = withoutMargins<QHBoxLayout>(row, 16);
  const auto add = [&](const QString& words, void (Welcome::*requestSignal)()) {
    auto* link = new QPushButton(words, row);
    link->setProperty("role", QStringLiteral("link"));
    connect(link, &QPushButton::clicked, this, requestSignal);
    line->addWidget(link);
  };
  add(tr("Open a study…"), &Welcome::folderRequested);
  add(tr("Check protocol…"), &Welcome::protocolCheckRequested);
  line->addStretch(1);
  return row;
}

/// The main button has the focus as well, so that one place is emphasised.
void Welcome::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  main_->setFocus();
}

void Welcome::resizeEvent(QResizeEvent* event) {
  constexpr int kRoomForThree = 860;  // [px]
  cards_->setDirection(
      event->size().width() >= kRoomForThree ? QBoxLayout::LeftToRight : QBoxLayout::TopToBottom);
  QWidget::resizeEvent(event);
}

}  // namespace study::gui
