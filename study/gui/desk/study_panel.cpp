#include "study/gui/desk/study_panel.h"

#include <QGridLayout>
#include <QScrollArea>

#include "study/gui/widgets/labels.h"

namespace study::gui {

StudyPanel::StudyPanel(QWidget* parent)
    : QFrame(parent),
      title_(bodyLabel({}, this)),
      what_(quietLabel({}, this)),
      sessions_(bodyLabel({}, this)),
      folder_(quietLabel({}, this)),
      problem_(bodyLabel({}, this)),
      open_(new QPushButton(tr("Open"), this)),
      forget_(new QPushButton(tr("Take off the list"), this)),
      place_(new QWidget(this)),
      unfinished_(new QVBoxLayout(place_)) {
  setProperty("role", QStringLiteral("card"));
  title_->setProperty("role", QStringLiteral("heading"));
  problem_->setProperty("role", QStringLiteral("bad"));
  problem_->setObjectName(QStringLiteral("problem"));
  open_->setProperty("role", QStringLiteral("main"));
  open_->setObjectName(QStringLiteral("open"));
  folder_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  auto* buttons = new QGridLayout;
  buttons->addWidget(open_, 0, 0, 1, 4);
  const auto add = [&](const QString& words, const char* name, void (StudyPanel::*wanted)()) {
    auto* button = new QPushButton(words, this);
    button->setObjectName(QString::fromUtf8(name));
    const int count = static_cast<int>(actions_.size());
    buttons->addWidget(button, 1, count);
    actions_.push_back(button);
    connect(button, &QPushButton::clicked, this, wanted);
  };
  add(tr("Back up…"), "backup", &StudyPanel::backupRequested);
  add(tr("Verify…"), "verify", &StudyPanel::verifyRequested);
  add(tr("Report…"), "report", &StudyPanel::reportRequested);
  add(tr("Export…"), "export", &StudyPanel::exportRequested);
  forget_->setObjectName(QStringLiteral("forget"));
  buttons->addWidget(forget_, 2, 0, 1, 4);
  connect(open_, &QPushButton::clicked, this, &StudyPanel::openRequested);
  connect(forget_, &QPushButton::clicked, this, &StudyPanel::forgetRequested);

  place_->setProperty("role", QStringLiteral("plain"));
  unfinished_->setContentsMargins(0, 0, 0, 0);
  auto* scroll = new QScrollArea(this);
  scroll->setWidgetResizable(true);
  scroll->setWidget(place_);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(20, 18, 20, 18);
  layout->setSpacing(10);
  for (auto* label : {title_, what_, sessions_, folder_, problem_}) layout->addWidget(label);
  layout->addLayout(buttons);
  layout->addWidget(scroll, 1);
  clear();
}

void StudyPanel::clear() {
  show(StudySummary{});
  title_->setText(tr("No study is chosen"));
  what_->setText(tr("Make a new one from a protocol, or open the folder of one that is there."));
  sessions_->clear();
  folder_->clear();
  open_->setEnabled(false);
  forget_->setVisible(false);
  for (auto* button : actions_) button->setEnabled(false);
}

void StudyPanel::show(const StudySummary& summary) {
  const bool isSound = summary.problem.empty();
  title_->setText(QString::fromStdString(summary.title));
  what_->setText(QString::fromStdString(summary.protocol));
  sessions_->setText(QString::fromStdString(sessionsInWords(summary)));
  folder_->setText(QString::fromStdString(summary.folder));
  problem_->setText(QStringLiteral("✕  ") + QString::fromStdString(summary.problem));
  problem_->setVisible(!isSound);
  open_->setEnabled(isSound);
  forget_->setVisible(!isSound);
  for (auto* button : actions_) button->setEnabled(isSound);
  showUnfinished(summary);
}

void StudyPanel::showUnfinished(const StudySummary& summary) {
  while (auto* item = unfinished_->takeAt(0)) {
    delete item->widget();
    delete item;
  }
  if (!summary.unfinished.empty()) {
    auto* heading = bodyLabel(tr("Sessions that are not finished"), place_);
    heading->setProperty("role", QStringLiteral("heading"));
    unfinished_->addWidget(heading);
  }
  for (const auto& session : summary.unfinished) unfinished_->addWidget(cardOf(session));
  unfinished_->addStretch(1);
}

QWidget* StudyPanel::cardOf(const UnfinishedSession& session) {
  auto* card = new QFrame(place_);
  card->setProperty("role", QStringLiteral("card"));
  card->setObjectName(
      QStringLiteral("unfinished-%1").arg(QString::fromStdString(session.participant)));
  auto* layout = new QVBoxLayout(card);
  layout->addWidget(bodyLabel(QString::fromStdString(describe(session)), card));
  QString choices = session.isOpenElsewhere() ? QString() : tr("You can:");
  for (const auto& choice : session.choices) {
    choices += (choices.isEmpty() ? QStringLiteral("") : QStringLiteral("\n")) +
               QStringLiteral("•  ") + QString::fromStdString(choice);
  }
  layout->addWidget(quietLabel(choices, card));
  if (!session.isOpenElsewhere()) {
    auto* button =
        new QPushButton(tr("Open with %1").arg(QString::fromStdString(session.participant)), card);
    layout->addWidget(button, 0, Qt::AlignLeft);
    const auto id = static_cast<qlonglong>(session.id);
    connect(button, &QPushButton::clicked, this, [this, id] { emit goOnRequested(id); });
  }
  return card;
}

}  // namespace study::gui
