#include "study/gui/home/study_panel.h"

#include <algorithm>

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
constexpr int kGap = 6;             // [px] between buttons of a row

}  // namespace

StudyPanel::StudyPanel(QWidget* parent)
    : QFrame(parent),
      title_(bodyLabel({}, this)),
      what_(quietLabel({}, this)),
      sessions_(bodyLabel({}, this)),
      arrivals_(bodyLabel({}, this)),
      folder_(quietLabel({}, this)),
      keyRemark_(bodyLabel(
          tr("There is no copy of this study's key. Without the key its results are lost."), this)),
      textsRemark_(bodyLabel({}, this)),
      problem_(bodyLabel({}, this)),
      buttons_(new QVBoxLayout),
      unfinished_(new QVBoxLayout),
      open_(new QPushButton(tr("Open sessions"), this)),
      start_(makeStart()),
      removeButton_(new QPushButton(tr("Remove from list"), this)),
      place_(new QWidget(this)),
      parts_(new QVBoxLayout(place_)) {
  setProperty("role", QStringLiteral("card"));
  title_->setProperty("role", QStringLiteral("heading"));
  keyRemark_->setObjectName(QStringLiteral("key-remark"));
  textsRemark_->setObjectName(QStringLiteral("texts-remark"));
  problem_->setProperty("role", QStringLiteral("bad"));
  problem_->setObjectName(QStringLiteral("problem"));
  open_->setProperty("role", QStringLiteral("main"));
  open_->setObjectName(QStringLiteral("open"));
  removeButton_->setObjectName(QStringLiteral("forget"));
  folder_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  connect(open_, &QPushButton::clicked, this, &StudyPanel::openRequested);
  connect(removeButton_, &QPushButton::clicked, this, &StudyPanel::listRemovalRequested);
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
  layout->addWidget(makeRemark(*keyRemark_, tr("Save a copy…"), &StudyPanel::keyRequested));
  layout->addWidget(
      makeRemark(*textsRemark_, tr("Fill in the texts…"), &StudyPanel::textsRequested));
  layout->addLayout(unfinished_);
  layout->addWidget(open_);
  layout->addWidget(start_);
  layout->addWidget(scroll, 1);
  layout->addLayout(buttons_);
  layout->addWidget(removeButton_);
  makeButtons();
  clear();
}

void StudyPanel::makeButtons() {
  const auto group = [&](const QString& title) {
    auto* heading = quietLabel(title, this);
    heading->setWordWrap(false);
    groups_.push_back({heading, {}});
  };
  const auto add = [&](const QString& words, const char* name, void (StudyPanel::*wanted)()) {
    auto* button = new QPushButton(words, this);
    button->setObjectName(QString::fromUtf8(name));
    button->setProperty("role", QStringLiteral("link"));
    button->setAccessibleDescription(groups_.back().heading->text());
    groups_.back().buttons.push_back(button);
    connect(button, &QPushButton::clicked, this, wanted);
    return button;
  };
  group(tr("Results"));
  add(tr("Report…"), "report", &StudyPanel::reportRequested);
  add(tr("Export…"), "export", &StudyPanel::exportRequested);
  add(tr("Statistics…"), "statistics", &StudyPanel::statisticsRequested);
  group(tr("Protocol"));
  add(tr("Fill in the texts…"), "texts", &StudyPanel::textsRequested);
  add(tr("Preview…"), "preview", &StudyPanel::previewRequested);
  add(tr("Change the protocol…"), "amend", &StudyPanel::amendmentRequested);
  add(tr("Plan…"), "plan", &StudyPanel::planRequested);
  add(tr("Simulate…"), "simulate", &StudyPanel::simulationRequested);
  group(tr("Keep and erase"));
  add(tr("Back up…"), "backup", &StudyPanel::backupRequested);
  add(tr("Verify…"), "verify", &StudyPanel::verifyRequested);
  add(tr("Key…"), "key", &StudyPanel::keyRequested)
      ->setToolTip(tr(
          "The key says which condition an alternative was: save a copy, or take it from a file"));
  add(tr("Erase a participant…"), "erase", &StudyPanel::erasureRequested);
  buttons_->setContentsMargins(0, 0, 0, 0);
  buttons_->setSpacing(4);
}

/// Something that is still to be done, with the button that does it.
QWidget* StudyPanel::makeRemark(
    QLabel& remark, const QString& words, void (StudyPanel::*wanted)()) {
  auto* row = new QWidget(this);
  row->setProperty("role", QStringLiteral("plain"));
  auto* button = new QPushButton(words, row);
  button->setProperty("role", QStringLiteral("tool"));
  button->setObjectName(remark.objectName() + QStringLiteral("-button"));
  remark.setProperty("role", QStringLiteral("warn"));
  auto* line = new QHBoxLayout(row);
  line->setContentsMargins(0, 0, 0, 0);
  line->addWidget(&remark, 1);
  line->addWidget(button);
  connect(button, &QPushButton::clicked, this, wanted);
  return row;
}

/// A row of buttons that starts with the heading of its group, or with an empty space of the same
/// width.
QHBoxLayout* StudyPanel::addRow(QWidget* heading, int headingWidth) {
  auto* row = new QHBoxLayout;
  row->setSpacing(kGap);
  if (heading != nullptr) {
    heading->setFixedWidth(headingWidth);
    row->addWidget(heading);
  } else {
    row->addSpacing(headingWidth + kGap);
  }
  buttons_->addLayout(row);
  return row;
}

void StudyPanel::fitInto(int width) {
  const auto margins = layout()->contentsMargins();
  const int room = width - margins.left() - margins.right() - 2 * frameWidth();
  int headingWidth = 0;
  for (const auto& group : groups_) {
    group.heading->ensurePolished();
    group.heading->setMinimumWidth(0);
    group.heading->setMaximumWidth(QWIDGETSIZE_MAX);
    headingWidth = std::max(headingWidth, group.heading->sizeHint().width());
  }
  while (auto* row = buttons_->takeAt(0)) delete row;
  for (const auto& group : groups_) {
    auto* row = addRow(group.heading, headingWidth);
    int left = room - headingWidth;
    for (auto* button : group.buttons) {
      button->ensurePolished();
      const int needed = button->sizeHint().width() + kGap;
      if (needed > left && row->count() > 1) {
        row->addStretch(1);
        row = addRow(nullptr, headingWidth);
        left = room - headingWidth;
      }
      row->addWidget(button);
      left -= needed;
    }
    row->addStretch(1);
  }
}

/// The buttons for a user without a study.
QWidget* StudyPanel::makeStart() {
  auto* start = new QWidget(this);
  start->setProperty("role", QStringLiteral("plain"));
  auto* lines = new QVBoxLayout(start);
  lines->setContentsMargins(0, 0, 0, 0);
  const auto add = [&](const QString& words, const char* role, void (StudyPanel::*wanted)()) {
    auto* button = new QPushButton(words, start);
    button->setProperty("role", QString::fromUtf8(role));
    lines->addWidget(button);
    connect(button, &QPushButton::clicked, this, wanted);
  };
  add(tr("New study…"), "main", &StudyPanel::newStudyRequested);
  add(tr("Tour in three steps…"), "tool", &StudyPanel::tourRequested);
  add(tr("System check…"), "tool", &StudyPanel::systemCheckRequested);
  return start;
}

/// Shows the buttons for a user without a study, or else those for a study.
void StudyPanel::showStart(bool isEmpty) {
  start_->setVisible(isEmpty);
  open_->setVisible(!isEmpty);
  for (auto* label : {sessions_, folder_}) label->setVisible(!isEmpty && !label->text().isEmpty());
  for (const auto& group : groups_) {
    group.heading->setVisible(!isEmpty);
    for (auto* button : group.buttons) button->setVisible(!isEmpty);
  }
}

void StudyPanel::enableActions(bool isEnabled) {
  for (const auto& group : groups_) {
    for (auto* button : group.buttons) button->setEnabled(isEnabled);
  }
}

void StudyPanel::clear() {
  show(StudySummary{});
  title_->setText(tr("Begin here"));
  what_->setText(tr("Create a study from a protocol, or open the folder of an existing one."));
  sessions_->clear();
  folder_->clear();
  open_->setEnabled(false);
  removeButton_->setVisible(false);
  showStart(true);
  enableActions(false);
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
  folder_->setVisible(!summary.folder.empty());  // hidden if empty, because it can have the focus
  problem_->setText(QStringLiteral("✕  ") + QString::fromStdString(summary.problem));
  problem_->setVisible(!isSound);
  open_->setEnabled(isSound);
  removeButton_->setVisible(!isSound);
  enableActions(isSound);
  keyRemark_->parentWidget()->setVisible(summary.lacksKeyBackup);
  textsRemark_->setText(
      summary.blanks == 1 ? tr("1 text is still blank.")
                          : tr("%1 texts are still blank.").arg(summary.blanks));
  textsRemark_->parentWidget()->setVisible(summary.blanks > 0);
  showStart(false);
  for (auto* shown : {unfinished_, parts_}) {
    while (auto* item = shown->takeAt(0)) {
      delete item->widget();
      delete item;
    }
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
  constexpr int kMostAbove = 2;  // the others are scrolled
  const auto first = std::ranges::find_if(
      summary.unfinished, [](const auto& session) { return !session.isOpenElsewhere(); });
  setRole(*open_, first == summary.unfinished.end() ? "main" : "");
  for (auto session = summary.unfinished.begin(); session != summary.unfinished.end(); ++session) {
    auto* lines = unfinished_->count() < kMostAbove ? unfinished_ : parts_;
    lines->addWidget(makeCard(*session, session == first));
  }
}

/// One sentence and the buttons, which are in sight on a small screen; the rest is shown on demand.
/// @param isMain  whether its button is the one to press next.
QWidget* StudyPanel::makeCard(const UnfinishedSession& session, bool isMain) {
  auto* card = new QFrame(this);
  card->setProperty("role", QStringLiteral("card"));
  card->setObjectName(
      QStringLiteral("unfinished-%1").arg(QString::fromStdString(session.participant)));
  auto* layout = new QVBoxLayout(card);
  layout->addWidget(bodyLabel(
      QString::fromStdString(said(
          session.isOpenElsewhere() ? "Unfinished: {} ({}), step {} of {}; open in another window."
                                    : "Unfinished: {} ({}), step {} of {}.",
          session.participant,
          said(nameOf(session.runMode)),
          session.step + 1,
          session.steps)),
      card));
  auto* buttons = new QHBoxLayout;
  if (!session.isOpenElsewhere()) {
    auto* button = new QPushButton(
        tr("Continue with %1").arg(QString::fromStdString(session.participant)), card);
    button->setProperty("role", isMain ? QStringLiteral("main") : QStringLiteral("tool"));
    buttons->addWidget(button);
    const auto id = static_cast<qlonglong>(session.id);
    connect(button, &QPushButton::clicked, this, [this, id] { emit resumeSessionRequested(id); });
  }
  auto* details = new QPushButton(tr("Details"), card);
  details->setObjectName(QStringLiteral("details"));
  details->setProperty("role", QStringLiteral("tool"));
  details->setCheckable(true);
  buttons->addWidget(details);
  buttons->addStretch(1);
  layout->addLayout(buttons);
  QString words = describeUnfinished(session);
  if (!session.isOpenElsewhere()) words += QStringLiteral("\n") + tr("You can:");
  for (const auto& choice : session.choices) {
    words += QStringLiteral("\n•  ") + deskText(choice);
  }
  auto* more = quietLabel(words, card);
  more->setVisible(false);
  layout->addWidget(more);
  connect(details, &QPushButton::toggled, more, &QWidget::setVisible);
  return card;
}

}  // namespace study::gui
