#include "study/gui/desk/study_panel.h"

#include <algorithm>

#include <QDateTime>
#include <QFileInfo>
#include <QScrollArea>

#include "study/gui/desk/recent_studies.h"
#include "study/gui/widgets/cohort_bar.h"
#include "study/gui/widgets/desk_language.h"
#include "study/gui/widgets/labels.h"
#include "study/gui/widgets/written_file.h"

namespace study::gui {
namespace {

constexpr std::size_t kMostDocumentsShown = 6;
constexpr int kLeastOfParts = 110;  // [px]

QString localTime(const std::string& utc) {
  const auto time = QDateTime::fromString(QString::fromStdString(utc), Qt::ISODate);
  return time.toLocalTime().toString(QStringLiteral("yyyy-MM-dd HH:mm"));
}

}  // namespace

StudyPanel::StudyPanel(QWidget* parent)
    : QFrame(parent),
      title_(bodyLabel({}, this)),
      what_(quietLabel({}, this)),
      sessions_(bodyLabel({}, this)),
      arrivals_(bodyLabel({}, this)),
      folder_(quietLabel({}, this)),
      problem_(bodyLabel({}, this)),
      buttons_(new QGridLayout),
      open_(new QPushButton(tr("Open"), this)),
      forget_(new QPushButton(tr("Remove from list"), this)),
      place_(new QWidget(this)),
      parts_(new QVBoxLayout(place_)) {
  setProperty("role", QStringLiteral("card"));
  title_->setProperty("role", QStringLiteral("heading"));
  problem_->setProperty("role", QStringLiteral("bad"));
  problem_->setObjectName(QStringLiteral("problem"));
  open_->setProperty("role", QStringLiteral("main"));
  open_->setObjectName(QStringLiteral("open"));
  forget_->setObjectName(QStringLiteral("forget"));
  folder_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  connect(open_, &QPushButton::clicked, this, &StudyPanel::openRequested);
  connect(forget_, &QPushButton::clicked, this, &StudyPanel::forgetRequested);
  place_->setProperty("role", QStringLiteral("plain"));
  parts_->setContentsMargins(0, 0, 0, 0);
  auto* scroll = new QScrollArea(this);
  scroll->setWidgetResizable(true);
  scroll->setWidget(place_);
  scroll->setFocusPolicy(Qt::NoFocus);
  scroll->setMinimumHeight(kLeastOfParts);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(20, 18, 20, 18);
  layout->setSpacing(10);
  arrivals_->setObjectName(QStringLiteral("arrivals"));
  for (auto* label : {title_, what_, sessions_, arrivals_, folder_, problem_})
    layout->addWidget(label);
  layout->addWidget(open_);
  layout->addWidget(scroll, 1);
  layout->addLayout(buttons_);
  makeButtons();
  fitInto(0);
  clear();
}

void StudyPanel::makeButtons() {
  const auto add = [&](const QString& words, const char* name, void (StudyPanel::*wanted)()) {
    auto* button = new QPushButton(words, this);
    button->setObjectName(QString::fromUtf8(name));
    button->setProperty("role", QStringLiteral("tool"));
    actions_.push_back(button);
    connect(button, &QPushButton::clicked, this, wanted);
    return button;
  };
  add(tr("Report…"), "report", &StudyPanel::reportRequested);
  add(tr("Export…"), "export", &StudyPanel::exportRequested);
  add(tr("Statistics…"), "statistics", &StudyPanel::statisticsRequested);
  texts_ = add(tr("Fill in the texts…"), "texts", &StudyPanel::textsRequested);
  add(tr("Preview…"), "preview", &StudyPanel::previewRequested);
  add(tr("Change the protocol…"), "amend", &StudyPanel::amendmentRequested);
  add(tr("Plan…"), "plan", &StudyPanel::planRequested);
  add(tr("Simulate…"), "simulate", &StudyPanel::simulationRequested);
  add(tr("Back up…"), "backup", &StudyPanel::backupRequested);
  add(tr("Verify…"), "verify", &StudyPanel::verifyRequested);
  add(tr("Erase a participant…"), "erase", &StudyPanel::erasureRequested);
  key_ = add(tr("Key…"), "key", &StudyPanel::keyRequested);
}

void StudyPanel::fitInto(int width) {
  constexpr int kMostColumns = 3;
  constexpr int kCounted = 36;  // [px]: " (16)" after the words
  const auto margins = layout()->contentsMargins();
  const int room = width - margins.left() - margins.right() - 2 * frameWidth();
  int widest = 0;
  for (auto* button : actions_) {
    button->ensurePolished();
    const bool isCounted = button == texts_ && !button->text().contains(u'(');
    widest = std::max(widest, button->sizeHint().width() + (isCounted ? kCounted : 0));
  }
  const int gap = buttons_->horizontalSpacing();
  const int columns = std::clamp((room + gap) / (widest + gap), 1, kMostColumns);
  while (buttons_->count() > 0) delete buttons_->takeAt(0);
  int place = 0;
  for (auto* button : actions_) {
    buttons_->addWidget(button, place / columns, place % columns);
    ++place;
  }
  buttons_->addWidget(forget_, place / columns + 1, 0, 1, columns);
  for (int column = 0; column < kMostColumns; ++column) {
    buttons_->setColumnStretch(column, column < columns ? 1 : 0);
  }
}

void StudyPanel::clear() {
  show(StudySummary{});
  title_->setText(tr("No study is selected"));
  what_->setText(tr("Create one from a protocol, or open the folder of an existing study."));
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
  QString sessions = QString::fromStdString(sessionsInWords(summary));
  if (!summary.lastSessionUtc.empty()) {
    sessions += tr(". Last session: %1").arg(localTime(summary.lastSessionUtc));
  }
  sessions_->setText(sessions);
  const auto arrivals = QString::fromStdString(arrivalsInWords(summary));
  arrivals_->setText(arrivals);
  arrivals_->setVisible(!arrivals.isEmpty());
  setRole(*arrivals_, isArrivalOverdue(summary) ? "warn" : "body");
  folder_->setText(shownPath(QString::fromStdString(summary.folder)));
  folder_->setVisible(!summary.folder.empty());  // it can have the focus
  problem_->setText(QStringLiteral("✕  ") + QString::fromStdString(summary.problem));
  problem_->setVisible(!isSound);
  open_->setEnabled(isSound);
  forget_->setVisible(!isSound);
  for (auto* button : actions_) button->setEnabled(isSound);
  texts_->setText(
      summary.blanks == 0 ? tr("Fill in the texts…")
                          : tr("Fill in the texts… (%1)").arg(summary.blanks));
  texts_->setToolTip(
      summary.blanks == 0 ? QString()
                          : tr("%1 blanks in texts for participants").arg(summary.blanks));
  key_->setText(summary.isOnlyCopyOfKey ? tr("Key… (!)") : tr("Key…"));
  key_->setToolTip(
      summary.isOnlyCopyOfKey ? tr("No copy of the study's key was saved yet") : QString());
  while (auto* item = parts_->takeAt(0)) {
    delete item->widget();
    delete item;
  }
  showUnfinished(summary);
  showProgress(summary);
  showDocuments(summary);
  parts_->addStretch(1);
}

void StudyPanel::addHeading(const QString& text) {
  auto* heading = bodyLabel(text, place_);
  heading->setProperty("role", QStringLiteral("heading"));
  parts_->addWidget(heading);
}

/// A bar for each cohort: as in "Orthopaedic surgeons: 3 of 12 completed".
void StudyPanel::showProgress(const StudySummary& summary) {
  for (const auto& cohort : summary.cohorts) {
    parts_->addWidget(new CohortBar(
        QString::fromStdString(cohort.title), cohort.completed, cohort.planned, place_));
  }
}

void StudyPanel::showDocuments(const StudySummary& summary) {
  if (summary.folder.empty()) return;
  const auto documents = documentsOf(QString::fromStdString(summary.folder));
  if (documents.empty()) return;
  addHeading(tr("Reports and exports"));
  for (std::size_t i = 0; i < std::min(documents.size(), kMostDocumentsShown); ++i) {
    auto* row = new QWidget(place_);
    row->setProperty("role", QStringLiteral("plain"));
    auto* line = new QHBoxLayout(row);
    line->setContentsMargins(0, 0, 0, 0);
    auto* name = bodyLabel(QFileInfo(documents[i].path).fileName(), row);
    name->setToolTip(documents[i].path);
    auto* buttons = new WrittenFile(row);
    buttons->show(documents[i].path);
    line->addWidget(name, 1);
    line->addWidget(buttons);
    parts_->addWidget(row);
  }
}

void StudyPanel::showUnfinished(const StudySummary& summary) {
  if (!summary.unfinished.empty()) addHeading(tr("Unfinished sessions"));
  for (const auto& session : summary.unfinished) parts_->addWidget(makeCard(session));
}

QWidget* StudyPanel::makeCard(const UnfinishedSession& session) {
  auto* card = new QFrame(place_);
  card->setProperty("role", QStringLiteral("card"));
  card->setObjectName(
      QStringLiteral("unfinished-%1").arg(QString::fromStdString(session.participant)));
  auto* layout = new QVBoxLayout(card);
  layout->addWidget(bodyLabel(describeUnfinished(session), card));
  QString choices = session.isOpenElsewhere() ? QString() : tr("You can:");
  for (const auto& choice : session.choices) {
    choices += (choices.isEmpty() ? QStringLiteral("") : QStringLiteral("\n")) +
               QStringLiteral("•  ") + spoken(choice);
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
