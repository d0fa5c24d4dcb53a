#include "study/gui/home/study_panel.h"

#include <algorithm>

#include <QEvent>
#include <QFileInfo>
#include <QHBoxLayout>

#include "study/gui/desk/recent_studies.h"
#include "study/gui/widgets/cohort_bar.h"
#include "study/gui/widgets/desk_language.h"
#include "study/gui/widgets/labels.h"
#include "study/gui/widgets/written_file.h"

namespace study::gui {
namespace {

constexpr std::size_t kMostDocumentsShown = 6;
constexpr int kBetweenParts = 12;    // [px]
constexpr int kBetweenColumns = 16;  // [px]

void clearLayout(QLayout& layout) {
  while (auto* item = layout.takeAt(0)) {
    delete item->widget();
    delete item;
  }
}

/// The facts on sessions that the bars of the cohorts do not show.
QString aboutSessions(const StudySummary& summary) {
  QStringList parts;
  const auto others = QString::fromStdString(otherSessionsInWords(summary));
  if (!others.isEmpty()) parts << others;
  if (!summary.lastSessionUtc.empty()) {
    parts << StudyPanel::tr("Last session: %1").arg(localTime(summary.lastSessionUtc));
  }
  return parts.isEmpty() ? capitalised(QString::fromStdString(sessionsInWords(summary)))
                         : parts.join(QStringLiteral(". "));
}

}  // namespace

StudyPanel::StudyPanel(QWidget* parent)
    : QFrame(parent),
      title_(headingLabel({}, this)),
      sessions_(quietLabel({}, this)),
      arrivals_(bodyLabel({}, this)),
      keyRemark_(bodyLabel(
          tr("There is no copy of this study's key. Without the key its results are lost."), this)),
      textsRemark_(bodyLabel({}, this)),
      problem_(bodyLabel({}, this)),
      progress_(new QVBoxLayout),
      unfinished_(new QVBoxLayout),
      open_(new QPushButton(tr("Run sessions…"), this)),
      actions_(new QGridLayout),
      removeButton_(new QPushButton(tr("Remove from list"), this)),
      documents_(new QWidget(this)),
      documentRows_(new QVBoxLayout),
      blindingRemark_(bodyLabel(
          tr("Sessions are still to come. Their operators should open no report and no unblinded "
             "export: they name the conditions."),
          this)),
      foot_(quietLabel({}, this)) {
  setProperty("role", QStringLiteral("card"));
  arrivals_->setObjectName(QStringLiteral("arrivals"));
  keyRemark_->setObjectName(QStringLiteral("key-remark"));
  textsRemark_->setObjectName(QStringLiteral("texts-remark"));
  problem_->setProperty("role", QStringLiteral("bad"));
  problem_->setObjectName(QStringLiteral("problem"));
  open_->setProperty("role", QStringLiteral("main"));
  open_->setObjectName(QStringLiteral("open"));
  removeButton_->setObjectName(QStringLiteral("forget"));
  foot_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  documents_->setProperty("role", QStringLiteral("plain"));
  connect(open_, &QPushButton::clicked, this, &StudyPanel::openRequested);
  connect(removeButton_, &QPushButton::clicked, this, &StudyPanel::listRemovalRequested);
  makeActions();
  auto* documents = withoutMargins<QVBoxLayout>(documents_);
  documents->addWidget(makeSeparator());
  documents->addWidget(sectionLabel(tr("Reports and exports"), documents_));
  setRole(*blindingRemark_, "warn");
  blindingRemark_->setObjectName(QStringLiteral("blinding-remark"));
  documents->addWidget(blindingRemark_);
  documents->addLayout(documentRows_);
  documentRows_->setSpacing(0);
  auto* layout = withMargins<QVBoxLayout>(this, {24, 20, 24, 16}, kBetweenParts);
  auto* head = new QHBoxLayout;
  head->setSpacing(kBetweenColumns);
  head->addWidget(title_, 1);
  head->addWidget(open_, 0, Qt::AlignTop);
  head->addWidget(removeButton_, 0, Qt::AlignTop);
  layout->addLayout(head);
  for (auto* label : {sessions_, problem_, arrivals_}) layout->addWidget(label);
  layout->addWidget(makeRemark(*keyRemark_, tr("Save a copy…"), &StudyPanel::keyRequested));
  layout->addWidget(
      makeRemark(*textsRemark_, tr("Fill in the texts…"), &StudyPanel::textsRequested));
  layout->addLayout(progress_);
  layout->addLayout(unfinished_);
  layout->addWidget(makeSeparator());
  layout->addLayout(actions_);
  layout->addWidget(documents_);
  layout->addStretch(1);
  layout->addWidget(makeSeparator());
  layout->addWidget(foot_);
  clear();
}

QFrame* StudyPanel::makeSeparator() {
  auto* line = new QFrame(this);
  line->setProperty("role", QStringLiteral("rule"));
  return line;
}

void StudyPanel::makeActions() {
  const auto group = [&](const QString& title) {
    auto* column = new QWidget(this);
    column->setProperty("role", QStringLiteral("plain"));
    auto* lines = withoutMargins<QVBoxLayout>(column, 0);
    lines->addWidget(sectionLabel(title, column));
    lines->addSpacing(4);
    column->setAccessibleName(title);
    groups_.push_back({column, {}});
  };
  const auto add =
      [&](const QString& words, const char* name, void (StudyPanel::*requestSignal)()) {
        auto* column = groups_.back().column;
        auto* button = new QPushButton(words, column);
        button->setObjectName(QString::fromUtf8(name));
        button->setProperty("role", QStringLiteral("link"));
        button->setAccessibleDescription(column->accessibleName());
        column->layout()->addWidget(button);
        groups_.back().buttons.push_back(button);
        connect(button, &QPushButton::clicked, this, requestSignal);
        return button;
      };
  group(tr("Prepare"));
  add(tr("Fill in the texts…"), "texts", &StudyPanel::textsRequested);
  add(tr("Preview…"), "preview", &StudyPanel::previewRequested);
  add(tr("Plan…"), "plan", &StudyPanel::planRequested);
  add(tr("Simulate…"), "simulate", &StudyPanel::simulationRequested);
  add(tr("Change the protocol…"), "amend", &StudyPanel::amendmentRequested);
  group(tr("Results"));
  add(tr("Report…"), "report", &StudyPanel::reportRequested);
  add(tr("Statistics…"), "statistics", &StudyPanel::statisticsRequested);
  add(tr("Export…"), "export", &StudyPanel::exportRequested);
  group(tr("Keep and erase"));
  add(tr("Back up…"), "backup", &StudyPanel::backupRequested);
  add(tr("Verify…"), "verify", &StudyPanel::verifyRequested);
  add(tr("Key…"), "key", &StudyPanel::keyRequested)
      ->setToolTip(tr(
          "The key says which condition an alternative was: save a copy, or take it from a file"));
  add(tr("Erase a participant…"), "erase", &StudyPanel::erasureRequested);
  actions_->setHorizontalSpacing(kBetweenColumns);
  actions_->setVerticalSpacing(kBetweenParts);
  for (std::size_t i = 0; i < groups_.size(); ++i) {
    actions_->addWidget(groups_[i].column, static_cast<int>(i), 0, Qt::AlignTop);
  }
}

/// Makes a row for a task that is still open: a remark, and the button that does the task.
QWidget* StudyPanel::makeRemark(
    QLabel& remark, const QString& words, void (StudyPanel::*requestSignal)()) {
  auto* row = new QWidget(this);
  row->setProperty("role", QStringLiteral("plain"));
  auto* button = new QPushButton(words, row);
  button->setProperty("role", QStringLiteral("tool"));
  button->setObjectName(remark.objectName() + QStringLiteral("-button"));
  remark.setProperty("role", QStringLiteral("warn"));
  auto* line = withoutMargins<QHBoxLayout>(row);
  line->addWidget(&remark, 1);
  line->addWidget(button);
  connect(button, &QPushButton::clicked, this, requestSignal);
  return row;
}

void StudyPanel::fitInto(int width) {
  const auto margins = layout()->contentsMargins();
  const int room = width - margins.left() - margins.right() - 2 * frameWidth();
  int widest = 1;
  for (const auto& group : groups_) {
    for (auto* button : group.buttons) button->ensurePolished();
    widest = std::max(widest, group.column->sizeHint().width());
  }
  const int groups = static_cast<int>(groups_.size());
  const int columns = std::clamp((room + kBetweenColumns) / (widest + kBetweenColumns), 1, groups);
  for (int i = 0; i < groups; ++i) {
    auto* column = groups_[static_cast<std::size_t>(i)].column;
    actions_->removeWidget(column);
    actions_->addWidget(column, i / columns, i % columns, Qt::AlignTop);
  }
  for (int i = 0; i < groups; ++i) actions_->setColumnStretch(i, i < columns ? 1 : 0);
}

bool StudyPanel::event(QEvent* event) {
  const bool isDone = QFrame::event(event);
  if (event->type() == QEvent::LayoutRequest || event->type() == QEvent::Resize)
    setMinimumHeights();
  return isDone;
}

/// A scrolled page gets the minimum height of its layout, which does not include the lines into
/// which texts wrap.
void StudyPanel::setMinimumHeights() {
  setMinimumHeight(layout()->totalHeightForWidth(width()));
}

void StudyPanel::enableActions(bool isEnabled) {
  for (const auto& group : groups_) {
    for (auto* button : group.buttons) button->setEnabled(isEnabled);
  }
}

void StudyPanel::clear() {
  show(StudySummary{});
  open_->setEnabled(false);
  enableActions(false);
}

void StudyPanel::show(const StudySummary& summary) {
  const bool isSound = summary.problem.empty();
  title_->setText(QString::fromStdString(summary.title));
  sessions_->setText(aboutSessions(summary));
  sessions_->setVisible(isSound);
  const auto arrivals = QString::fromStdString(arrivalsInWords(summary));
  arrivals_->setText(arrivals);
  arrivals_->setVisible(!arrivals.isEmpty());
  setRole(*arrivals_, isArrivalOverdue(summary) ? "warn" : "body");
  problem_->setText(QStringLiteral("✕  ") + QString::fromStdString(summary.problem));
  problem_->setVisible(!isSound);
  open_->setEnabled(isSound);
  open_->setVisible(isSound);
  removeButton_->setVisible(!isSound);
  enableActions(isSound);
  keyRemark_->parentWidget()->setVisible(summary.lacksKeyBackup);
  textsRemark_->setText(
      summary.blanks == 1 ? tr("1 text is still blank.")
                          : tr("%1 texts are still blank.").arg(summary.blanks));
  textsRemark_->parentWidget()->setVisible(summary.blanks > 0);
  QStringList foot;
  if (!summary.protocol.empty()) foot << QString::fromStdString(summary.protocol);
  foot << tr("Folder: %1").arg(shownPath(QString::fromStdString(summary.folder)));
  foot_->setText(foot.join(QStringLiteral("\n")));
  foot_->setVisible(!summary.folder.empty());  // hidden if empty, because it can have the focus
  showUnfinished(summary);
  showProgress(summary);
  showDocuments(summary);
}

/// A bar for each cohort: as in "Orthopaedic surgeons: 3 of 12 completed".
void StudyPanel::showProgress(const StudySummary& summary) {
  clearLayout(*progress_);
  for (const auto& cohort : summary.cohorts) {
    progress_->addWidget(new CohortBar(
        QString::fromStdString(cohort.title), cohort.completed, cohort.planned, this));
  }
}

/// A row for each of the latest documents: its name, when it was written, and what opens it.
void StudyPanel::showDocuments(const StudySummary& summary) {
  clearLayout(*documentRows_);
  const auto documents = documentsOf(QString::fromStdString(summary.folder));
  documents_->setVisible(!summary.folder.empty());
  const auto [completed, planned] = progressOf(summary);
  const bool isUnderWay = countIn(summary.sessions, RunMode::Live) > 0 &&
                          (completed < planned || !summary.unfinished.empty());
  blindingRemark_->setVisible(isUnderWay && !summary.isOpenLabel && !documents.empty());
  if (documents.empty()) {
    documentRows_->addWidget(
        quietLabel(tr("Those that you write are listed here, and can be opened."), documents_));
  }
  for (std::size_t i = 0; i < std::min(documents.size(), kMostDocumentsShown); ++i) {
    const auto& document = documents[i];
    auto* row = new QWidget(documents_);
    row->setProperty("role", QStringLiteral("plain"));
    auto* line = withoutMargins<QHBoxLayout>(row, kBetweenColumns);
    auto* name = bodyLabel(QFileInfo(document.path).fileName(), row);
    name->setToolTip(document.path);
    auto* day = quietLabel(
        document.written.toLocalTime().toString(QStringLiteral("yyyy-MM-dd HH:mm")), row);
    day->setWordWrap(false);
    auto* buttons = new WrittenFile(row);
    buttons->show(document.path);
    for (auto* button : buttons->findChildren<QPushButton*>()) setRole(*button, "link");
    line->addWidget(name, 1);
    line->addWidget(day);
    line->addWidget(buttons);
    documentRows_->addWidget(row);
  }
}

void StudyPanel::showUnfinished(const StudySummary& summary) {
  clearLayout(*unfinished_);
  const auto first = std::ranges::find_if(
      summary.unfinished, [](const auto& session) { return !session.isOpenElsewhere(); });
  setRole(*open_, first == summary.unfinished.end() ? "main" : "");
  for (auto session = summary.unfinished.begin(); session != summary.unfinished.end(); ++session) {
    unfinished_->addWidget(makeCard(*session, session == first));
  }
}

/// Makes the card of an unfinished session: one sentence and the buttons, which a small screen
/// shows as well; details are shown on demand.
/// @param isMain  whether its button is the main one of the panel.
QWidget* StudyPanel::makeCard(const UnfinishedSession& session, bool isMain) {
  auto* card = new QFrame(this);
  card->setProperty("role", QStringLiteral("card"));
  card->setObjectName(
      QStringLiteral("unfinished-%1").arg(QString::fromStdString(session.participant)));
  auto* layout = new QVBoxLayout(card);
  layout->addWidget(bodyLabel(
      QString::fromStdString(translated(
          session.isOpenElsewhere() ? "Unfinished: {} ({}), step {} of {}; open in another window."
                                    : "Unfinished: {} ({}), step {} of {}.",
          session.participant,
          translated(nameOf(session.runMode)),
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
  for (const auto& choice : choicesFor(session)) words += QStringLiteral("\n•  ") + choice;
  auto* more = quietLabel(words, card);
  more->setVisible(false);
  layout->addWidget(more);
  connect(details, &QPushButton::toggled, more, &QWidget::setVisible);
  return card;
}

}  // namespace study::gui
