#include "study/gui/operator/sessions_page.h"

#include <algorithm>
#include <array>
#include <exception>

#include <QFormLayout>
#include <QFrame>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QHideEvent>
#include <QVBoxLayout>

#include "study/gui/widgets/attempt.h"
#include "study/gui/widgets/cohort_bar.h"
#include "study/gui/widgets/desk_language.h"
#include "study/gui/widgets/labels.h"
#include "study/gui/widgets/message_box.h"
#include "study/gui/widgets/read_only_table.h"

namespace study::gui {
namespace {

enum SessionColumn { kCode, kSite, kCohort, kRunMode, kLanguage, kBegun, kStatus, kSessionColumns };

}  // namespace

SessionsPage::SessionsPage(Study& study, StationPush& push, QWidget* parent)
    : QWidget(parent),
      study_(study),
      push_(push),
      columns_(new QHBoxLayout(this)),
      table_(new QTableWidget(0, kSessionColumns, this)),
      details_(quietLabel({}, this)),
      cohortProgress_(new QVBoxLayout),
      cohort_(new QComboBox(this)),
      mode_(new QComboBox(this)),
      language_(new QComboBox(this)),
      actions_(new QGridLayout),
      code_(bodyLabel({}, this)),
      enrol_(new QPushButton(tr("New participant"), this)),
      resume_(new QPushButton(tr("Continue session"), this)),
      resumeLine_(quietLabel(tr("What was answered in it is still there."), this)),
      arrived_(bodyLabel({}, this)),
      send_(new QPushButton(tr("Send now"), this)) {
  columns_->setContentsMargins(0, 0, 0, 0);
  columns_->setSpacing(20);
  columns_->addWidget(makeList(), 1);
  columns_->addWidget(makeEnrolment());

  connect(enrol_, &QPushButton::clicked, this, [this] {
    emit enrolRequested(
        {.cohort = cohort_->currentData().toString().toStdString(),
         .runMode = static_cast<RunMode>(mode_->currentData().toInt()),
         .language = language_->currentData().toString().toStdString(),
         .code = {}});
  });
  connect(resume_, &QPushButton::clicked, this, [this] {
    if (const auto* one = selectedUnfinished()) resumeSession(*one);
  });
  connect(table_, &QTableWidget::itemSelectionChanged, this, &SessionsPage::showSelected);
  connect(send_, &QPushButton::clicked, &push_, &StationPush::send);
  connect(&push_, &StationPush::changed, this, &SessionsPage::showPush);
  connect(&again_, &QTimer::timeout, this, &SessionsPage::lookElsewhere);
  constexpr int kLookInterval = 2000;  // [ms]
  again_.start(kLookInterval);
  refresh();
  chooseUsualLanguage();
}

/// Lists the sessions again if one that was open elsewhere is so no longer.
void SessionsPage::lookElsewhere() {
  if (!isVisible() || openElsewhereIn(unfinished_) == 0) return;
  try {
    const auto now = unfinishedSessions(study_);
    if (openElsewhereIn(now) != openElsewhereIn(unfinished_)) refresh();
  } catch (const std::exception&) {
    // The list stays as it is, and is read again soon.
  }
}

/// Chooses the language of the latest session of a person; in a new study, that of the desk.
void SessionsPage::chooseUsualLanguage() {
  chooseLanguage(*language_, deskLanguage());
  for (const auto& session : storage::Records(study_.database()).sessions()) {
    if (session.runMode != RunMode::Simulated) chooseLanguage(*language_, session.language);
  }
}

QWidget* SessionsPage::makeList() {
  table_->setAccessibleName(tr("Sessions"));
  table_->setHorizontalHeaderLabels(
      {tr("Participant"),
       tr("Site"),
       tr("Cohort"),
       tr("Run mode"),
       tr("Language"),
       tr("Begun"),
       tr("Status")});
  table_->setHorizontalScrollMode(QAbstractItemView::ScrollPerPixel);
  table_->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  table_->horizontalHeader()->setSectionResizeMode(kCohort, QHeaderView::Stretch);
  // Queued: a header that resizes its rows knows their sum only afterwards.
  connect(
      table_->verticalHeader(),
      &QHeaderView::sectionResized,
      this,
      &SessionsPage::setMinimumHeights,
      Qt::QueuedConnection);
  table_->verticalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  table_->setSelectionBehavior(QAbstractItemView::SelectRows);
  table_->setSelectionMode(QAbstractItemView::SingleSelection);
  makeReadOnly(*table_);

  auto* list = new QWidget(this);
  auto* layout = withoutMargins<QVBoxLayout>(list);
  auto* head = new QHBoxLayout;
  head->addWidget(headingLabel(tr("Sessions"), list), 1);
  auto* close = new QPushButton(tr("Close study"), list);
  close->setProperty("role", QStringLiteral("tool"));
  connect(close, &QPushButton::clicked, this, &SessionsPage::closeRequested);
  head->addWidget(close);
  layout->addLayout(head);
  constexpr int kTableStretch = 1000;  // the table takes what its rows need, and the rest is empty
  layout->addWidget(table_, kTableStretch);
  layout->addWidget(details_);
  addAction(*resume_, *resumeLine_);
  const auto add = [&](const QString& words,
                       const QString& what,
                       SessionEvent event,
                       MessageTopic topic,
                       End end) {
    auto* button = new QPushButton(words, list);
    endings_.push_back({button, quietLabel(what, list), event});
    addAction(*button, *endings_.back().line);
    connect(button, &QPushButton::clicked, this, [=, this] { endSelected(topic, end); });
  };
  add(tr("Participant withdraws…"),
      tr("Ends it because the participant wants to; answers are kept as withdrawn."),
      SessionEvent::Withdrew,
      MessageTopic::Withdrawal,
      &Session::withdraw);
  add(tr("Reject session…"),
      tr("Ends it for a reason that you give; answers are kept and do not count."),
      SessionEvent::WasRejected,
      MessageTopic::Rejection,
      &Session::reject);
  add(tr("Device failed…"),
      tr("Ends it because its device cannot go on."),
      SessionEvent::GaveUpOnDevice,
      MessageTopic::DeviceFailure,
      &Session::giveUpOnDevice);
  actions_->setColumnStretch(1, 1);
  layout->addLayout(actions_);
  arrived_->setObjectName(QStringLiteral("arrived"));
  send_->setObjectName(QStringLiteral("send"));
  send_->setProperty("role", QStringLiteral("tool"));
  auto* collecting = new QHBoxLayout;
  collecting->addWidget(arrived_, 1);
  collecting->addWidget(send_);
  layout->addLayout(collecting);
  layout->addStretch(1);
  return list;
}

void SessionsPage::addAction(QPushButton& button, QLabel& line) {
  button.setAccessibleDescription(line.text());
  const int row = actions_->rowCount();
  actions_->addWidget(&button, row, 0);
  actions_->addWidget(&line, row, 1);
}

QWidget* SessionsPage::makeEnrolment() {
  const auto& protocol = study_.protocol().protocol;
  if (protocol.cohorts.size() > 1) cohort_->addItem(tr("Choose…"), QString());
  for (const auto& cohort : protocol.cohorts) {
    cohort_->addItem(cohortTitle(protocol, cohort.id), QString::fromStdString(cohort.id));
  }
  mode_->addItem(tr("live"), static_cast<int>(RunMode::Live));
  mode_->addItem(tr("pilot (does not count)"), static_cast<int>(RunMode::Pilot));
  addLanguages(*language_, protocol.languages);
  auto* card = new QFrame(this);
  card->setProperty("role", QStringLiteral("card"));
  constexpr int kCardWidth = 440;  // [px]
  card->setFixedWidth(kCardWidth);
  auto* layout = withMargins<QVBoxLayout>(card, {20, 16, 20, 16}, 12);
  layout->addWidget(headingLabel(tr("Next participant"), card));
  cohortProgress_->setSpacing(8);
  layout->addLayout(cohortProgress_);
  layout->addSpacing(4);
  auto* form = new QFormLayout;
  form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
  form->setRowWrapPolicy(QFormLayout::WrapAllRows);  // the titles of cohorts are long
  const std::array<std::pair<QString, QComboBox*>, 3> rows{
      {{tr("Cohort"), cohort_}, {tr("Run mode"), mode_}, {tr("Language"), language_}}};
  for (const auto& [words, box] : rows) {
    box->setAccessibleName(words);
    box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    form->addRow(words, box);
  }
  layout->addLayout(form);
  code_->setObjectName(QStringLiteral("next-code"));
  layout->addWidget(code_);
  layout->addWidget(enrol_);
  connect(mode_, &QComboBox::currentIndexChanged, this, &SessionsPage::showNextCode);
  const auto enable = [this] { enrol_->setEnabled(!cohort_->currentData().toString().isEmpty()); };
  connect(cohort_, &QComboBox::currentIndexChanged, this, enable);
  enable();
  layout->addStretch(1);
  return card;
}

/// Puts the list beside the enrolment, or above it in a narrow window.
void SessionsPage::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  constexpr int kLeastWidthOfTwoColumns = 860;  // [px]
  constexpr int kLeastTableHeight = 120;        // above the enrolment
  const bool isWide = width() >= kLeastWidthOfTwoColumns;
  columns_->setDirection(isWide ? QBoxLayout::LeftToRight : QBoxLayout::TopToBottom);
  table_->setMinimumHeight(isWide ? 0 : kLeastTableHeight);
  setMinimumHeights();
  fitColumns();
}

/// The cohort has to be chosen for each participant: the previous one would be taken by mistake.
void SessionsPage::hideEvent(QHideEvent* event) {
  QWidget::hideEvent(event);
  if (!event->spontaneous()) cohort_->setCurrentIndex(0);
}

/// Hides columns of a narrow table: first the language, then the time and the run mode. The codes
/// of pilot and simulated participants show the run mode as well.
void SessionsPage::fitColumns() {
  constexpr int kRoomForTheLanguage = 740;  // [px]
  constexpr int kRoomForTheMode = 600;
  const bool isBeside = columns_->direction() == QBoxLayout::LeftToRight;
  const int card = isBeside ? enrol_->parentWidget()->maximumWidth() + columns_->spacing() : 0;
  const int site = study_.station().isNone() ? 0 : table_->columnWidth(kSite);
  const int room = width() - card - site;
  table_->setColumnHidden(kSite, study_.station().isNone());
  table_->setColumnHidden(kLanguage, room < kRoomForTheLanguage);
  table_->setColumnHidden(kRunMode, room < kRoomForTheMode);
  table_->setColumnHidden(kBegun, room < kRoomForTheMode);
}

/// Shows what has arrived at the server, and offers to send the rest.
void SessionsPage::showPush() {
  const auto words = push_.inWords();
  const bool isStation = push_.isPossible() && !words.empty();
  arrived_->setVisible(isStation);
  send_->setVisible(isStation);
  send_->setEnabled(!push_.isSending());
  arrived_->setText(push_.isSending() ? tr("Sending…") : QString::fromStdString(words));
  setRole(*arrived_, push_.isOverdue() && !push_.isSending() ? "warn" : "body");
}

/// Sets the minimum heights for wrapped text. A scrolled page gets the minimum height of its
/// layout, which does not include the lines into which titles of cohorts and details of a session
/// wrap.
void SessionsPage::setMinimumHeights() {
  const int rows = table_->verticalHeader()->length() + 2 * table_->frameWidth();
  const int heads = table_->horizontalHeader()->sizeHint().height();
  table_->setMaximumHeight(std::max(table_->minimumHeight(), heads + rows));
  auto* card = enrol_->parentWidget();
  card->setMinimumHeight(card->layout()->totalHeightForWidth(card->maximumWidth()));
  auto* list = table_->parentWidget();
  const bool isBeside = columns_->direction() == QBoxLayout::LeftToRight;
  const int besides = isBeside ? card->maximumWidth() + columns_->spacing() : 0;
  const int width = this->width() - besides;
  list->setMinimumHeight(list->layout()->totalHeightForWidth(width));
}

/// The code that the next participant gets.
void SessionsPage::showNextCode() {
  const auto mode = static_cast<RunMode>(mode_->currentData().toInt());
  const auto code = study_.sessions().freeCode(mode, study_.station().label);
  code_->setText(tr("Code: %1").arg(QString::fromStdString(code)));
}

void SessionsPage::refresh() {
  attempt(this, MessageTopic::SessionsNotListed, [&] {
    auto sessions = storage::Records(study_.database()).sessions();
    // Simulated sessions have times of their own, and are listed below those of people.
    const auto isOfPerson = [](const auto& one) { return one.runMode != RunMode::Simulated; };
    const auto simulated = std::stable_partition(sessions.begin(), sessions.end(), isOfPerson);
    lastOfPeople_ = static_cast<int>(simulated - sessions.begin()) - 1;
    unfinished_ = unfinishedSessions(study_);
    const auto& protocol = study_.protocol().protocol;
    fillTable(sessions, protocol);
    fillCohorts(sessions, protocol);
    showPush();
    showNextCode();
  });
  fitColumns();
  // Selects the latest unfinished session, because it should be continued first.
  for (int row = table_->rowCount() - 1; row >= 0 && selectedUnfinished() == nullptr; --row) {
    table_->selectRow(row);
  }
  if (unfinished_.empty()) table_->clearSelection();
  showSelected();
  setMinimumHeights();
}

void SessionsPage::offerPilot() {
  mode_->setCurrentIndex(mode_->findData(static_cast<int>(RunMode::Pilot)));
}

void SessionsPage::fillTable(
    const std::vector<storage::SessionRecord>& sessions, const protocols::Protocol& protocol) {
  table_->setRowCount(static_cast<int>(sessions.size()));
  for (int row = 0; row < table_->rowCount(); ++row) {
    const auto& s = sessions[static_cast<std::size_t>(row)];
    const std::array<QString, kSessionColumns> cells{
        QString::fromStdString(s.participant),
        QString::fromStdString(s.site),
        cohortTitle(protocol, s.cohort),
        deskText(nameOf(s.runMode)),
        nativeName(QString::fromStdString(s.language)),
        localTime(s.startedUtc),
        statusInWords(s.state)};
    for (int column = 0; column < kSessionColumns; ++column) {
      auto* cell = new QTableWidgetItem(cells[static_cast<std::size_t>(column)]);
      cell->setData(Qt::UserRole, static_cast<qlonglong>(s.id));
      cell->setToolTip(cells[static_cast<std::size_t>(column)]);
      table_->setItem(row, column, cell);
    }
  }
  table_->clearSelection();
  const bool isLast = lastOfPeople_ + 1 == table_->rowCount();
  if (lastOfPeople_ < 0 || isLast) return table_->scrollToBottom();
  table_->scrollToItem(table_->item(lastOfPeople_, kCode));
}

/// Shows how many participants of each cohort have completed.
void SessionsPage::fillCohorts(
    const std::vector<storage::SessionRecord>& sessions, const protocols::Protocol& protocol) {
  while (auto* item = cohortProgress_->takeAt(0)) {
    delete item->widget();
    delete item;
  }
  for (const auto& cohort : protocol.cohorts) {
    const auto done = std::count_if(sessions.begin(), sessions.end(), [&](const auto& s) {
      return s.cohort == cohort.id && s.runMode == RunMode::Live && s.isCompleted();
    });
    cohortProgress_->addWidget(new CohortBar(
        cohortTitle(protocol, cohort.id), static_cast<int>(done), cohort.planned, this));
  }
}

void SessionsPage::resumeSession(const UnfinishedSession& session) {
  const auto id = static_cast<qlonglong>(session.id);
  if (!session.mayBeTakenOver()) return emit resumeRequested(id, {});
  const auto reason = askForText(
      this,
      MessageTopic::TakeOver,
      {QString::fromStdString(session.holder->station), localTime(session.lastStoredUtc)});
  if (reason) emit resumeRequested(id, reason->trimmed());
}

/// Ends the selected session without its windows.
void SessionsPage::endSelected(MessageTopic topic, End end) {
  const auto* one = selectedUnfinished();
  if (one == nullptr) return;
  const auto id = one->id;
  const auto reason = askForText(this, topic);
  if (!reason) return;
  attempt(this, MessageTopic::StepNotDone, [&] {
    auto session = Session::resume(study_, id);
    (session.*end)(reason->trimmed().toStdString());
  });
  refresh();
  push_.send();
}

const UnfinishedSession* SessionsPage::selectedUnfinished() const {
  const auto selected = table_->selectedItems();
  if (selected.isEmpty()) return nullptr;
  const auto id = selected.front()->data(Qt::UserRole).toLongLong();
  const auto found = std::find_if(unfinished_.begin(), unfinished_.end(), [id](const auto& one) {
    return static_cast<qlonglong>(one.id) == id;
  });
  return found == unfinished_.end() ? nullptr : &*found;
}

/// Shows what happened to the selected unfinished session, and enables the actions for it.
void SessionsPage::showSelected() {
  const auto* one = selectedUnfinished();
  const bool isTakenOver = one != nullptr && one->mayBeTakenOver();
  resume_->setEnabled(one != nullptr && (!one->isOpenElsewhere() || isTakenOver));
  resume_->setText(isTakenOver ? tr("Take over session…") : tr("Continue session"));
  setRole(*resume_, resume_->isEnabled() ? "main" : "");
  setRole(*enrol_, unfinished_.empty() ? "main" : "");
  resumeLine_->setVisible(resume_->isEnabled());
  for (const auto& [button, line, event] : endings_) {
    const auto state = one == nullptr ? SessionState::Completed : one->state;
    // A trial that was running counts as broken off when its session is opened.
    const auto found = state == SessionState::InTrial ? SessionState::Interrupted : state;
    const bool isPossible = one != nullptr && !one->isOpenElsewhere() && next(found, event);
    // A device can only fail at a trial.
    const bool isItsStep =
        event != SessionEvent::GaveUpOnDevice || (isPossible && one->at.kind == StepKind::Trial);
    button->setVisible(isPossible && isItsStep);
    line->setVisible(isPossible && isItsStep);
  }
  if (one == nullptr) {
    details_->setText(
        table_->rowCount() == 0 ? tr("No participants yet.")
        : unfinished_.empty()   ? tr("All sessions are finished.")
                                : tr("Select a session that is in progress to continue it."));
    return;
  }
  QString words = describeUnfinished(*one);
  // Otherwise the buttons below say what can be done.
  if (one->isOpenElsewhere()) {
    for (const auto& choice : choicesFor(*one)) words += QStringLiteral("\n•  ") + choice;
  }
  details_->setText(words);
  setMinimumHeights();
}

}  // namespace study::gui
