#include "study/gui/home/home_window.h"

#include <algorithm>
#include <type_traits>
#include <utility>

#include <QApplication>
#include <QDir>
#include <QEvent>
#include <QFileDialog>
#include <QLocale>
#include <QMenuBar>
#include <QPushButton>
#include <QScreen>
#include <QScrollBar>
#include <QStyle>
#include <QVBoxLayout>

#include "protocols/load_protocol.h"
#include "study/gui/authoring/preview_window.h"
#include "study/gui/authoring/protocol_window.h"
#include "study/gui/authoring/texts_dialog.h"
#include "study/gui/desk/erase_dialog.h"
#include "study/gui/desk/export_dialog.h"
#include "study/gui/desk/help_window.h"
#include "study/gui/desk/key_dialog.h"
#include "study/gui/desk/key_question.h"
#include "study/gui/desk/measurement_dialogs.h"
#include "study/gui/desk/new_study_dialog.h"
#include "study/gui/desk/recent_studies.h"
#include "study/gui/desk/self_test_dialog.h"
#include "study/gui/desk/shape_window.h"
#include "study/gui/desk/study_dialogs.h"
#include "study/gui/desk/task_dialogs.h"
#include "study/gui/desk/tour.h"
#include "study/gui/widgets/attempt.h"
#include "study/gui/widgets/desk_language.h"
#include "study/gui/widgets/fitting_scroll.h"
#include "study/gui/widgets/labels.h"
#include "study/gui/widgets/message_box.h"
#include "study/gui/widgets/studio_settings.h"
#include "study/gui/widgets/theme.h"

namespace study::gui {
namespace {

/// The share of the planned sessions that are completed; none if no number is planned.
std::optional<double> shareOf(const StudySummary& study) {
  const auto [completed, planned] = progressOf(study);
  return planned == 0 ? std::nullopt : std::optional(static_cast<double>(completed) / planned);
}

}  // namespace

/// A study and its window. Each member uses those before it.
struct HomeWindow::OpenStudy {
  OpenStudy(const std::string& folder, const std::string& deviceFile)
      : study(Study::open(folder)), window(study, deviceFile) {}

  Study study;
  OperatorWindow window;
};

HomeWindow::HomeWindow(std::string deviceFile, QWidget* parent)
    : QMainWindow(parent), deviceFile_(std::move(deviceFile)) {
  setWindowTitle(tr("Palpate"));
  readTimer_.setSingleShot(true);
  connect(&readTimer_, &QTimer::timeout, this, &HomeWindow::loadNextVisibleSummary);
  connect(&lookTimer_, &QTimer::timeout, this, &HomeWindow::lookElsewhere);
  constexpr int kLookInterval = 2000;  // [ms]
  lookTimer_.start(kLookInterval);
  makeContents();
  // A study with a few documents is seen without scrolling where the screen is high enough.
  constexpr QSize kLeast(1240, 740);
  constexpr int kMostHeight = 860;
  constexpr int kBars = 80;  // of the desktop
  resize(
      kLeast.width(),
      std::clamp(screen()->availableSize().height() - kBars, kLeast.height(), kMostHeight));
}

void HomeWindow::makeContents() {
  delete takeCentralWidget();  // at once: while it is there, its texts keep their letters with Alt
  language_ = deskLanguage();
  list_ = new StudyList(this);
  panel_ = new StudyPanel(this);
  welcome_ = new Welcome(this);
  listColumn_ = makeList();
  auto* inside = new QWidget(this);
  columns_ = new QHBoxLayout(inside);
  columns_->setSpacing(24);
  columns_->addWidget(listColumn_, 2);
  columns_->addWidget(panel_, 3);
  columns_->addWidget(welcome_, 1);
  setCentralWidget(scrolled(inside, this));
  menuBar()->clear();
  makeMenus();
  connectPanel();
  connectWelcome();
  arrange();
  refresh();
}

void HomeWindow::arrange() {
  constexpr int kLeastWidthOfTwoColumns = 1000;  // [px]
  constexpr int kMostRoom = 1560;                // more would part what belongs together
  constexpr int kLeastMargin = 24;
  const bool isWide = width() >= kLeastWidthOfTwoColumns;
  columns_->setDirection(isWide ? QBoxLayout::LeftToRight : QBoxLayout::TopToBottom);
  const int aside = std::max(kLeastMargin, (width() - kMostRoom) / 2);
  columns_->setContentsMargins(aside, 12, aside, 20);
  const auto margins = columns_->contentsMargins();
  const int bar = style()->pixelMetric(QStyle::PM_ScrollBarExtent, nullptr, this);
  const int room = width() - margins.left() - margins.right() - bar;
  const int both = room - columns_->spacing();
  const int list = std::max(both * 2 / 5, columns_->itemAt(0)->minimumSize().width());
  panel_->fitInto(isWide ? both - list : room);
}

void HomeWindow::resizeEvent(QResizeEvent* event) {
  QMainWindow::resizeEvent(event);
  arrange();
  readTimer_.start();
}

void HomeWindow::changeEvent(QEvent* event) {
  QMainWindow::changeEvent(event);
  if (event->type() == QEvent::StyleChange && panel_ != nullptr) arrange();
  if (event->type() != QEvent::LanguageChange || language_ == deskLanguage()) return;
  // The menu that chose the language is still open.
  QTimer::singleShot(0, this, [this] {
    const auto* study = chosen();
    const auto folder = study == nullptr ? QString() : QString::fromStdString(study->folder);
    makeContents();
    select(folder);
  });
}

HomeWindow::~HomeWindow() = default;

QWidget* HomeWindow::makeList() {
  auto* side = new QWidget(this);
  list_->setAccessibleName(tr("Studies"));
  list_->setObjectName(QStringLiteral("studies"));
  connect(
      list_->verticalScrollBar(), &QScrollBar::valueChanged, this, [this] { readTimer_.start(); });
  connect(list_, &QTableWidget::itemSelectionChanged, this, &HomeWindow::showChosen);
  connect(list_, &QTableWidget::cellDoubleClicked, this, [this] {
    const auto* study = chosen();
    if (study != nullptr) openStudy(QString::fromStdString(study->folder));
  });
  auto* layout = withoutMargins<QVBoxLayout>(side, 12);
  layout->addWidget(titleLabel(tr("Studies"), side));
  constexpr int kTableStretch = 1000;  // the list takes what its rows need, and the rest is empty
  layout->addWidget(list_, kTableStretch);
  layout->addWidget(makeTools(side));
  layout->addStretch(1);
  return side;
}

/// The buttons for tasks that need no chosen study.
QWidget* HomeWindow::makeTools(QWidget* parent) {
  auto* tools = new QWidget(parent);
  auto* make = new QPushButton(tr("New study…"), tools);
  make->setObjectName(QStringLiteral("new-study"));
  auto* open = new QPushButton(tr("Open a study…"), tools);
  connect(make, &QPushButton::clicked, this, &HomeWindow::makeStudy);
  connect(open, &QPushButton::clicked, this, &HomeWindow::chooseFolder);
  auto* buttons = new QHBoxLayout;
  buttons->setSpacing(12);
  for (auto* button : {make, open}) buttons->addWidget(button, 1);
  auto* layout = withoutMargins<QVBoxLayout>(tools, 0);
  layout->addLayout(buttons);
  layout->addSpacing(12);
  const auto add = [&](const QString& words, void (HomeWindow::*requestSignal)()) {
    auto* link = new QPushButton(words, tools);
    link->setProperty("role", QStringLiteral("link"));
    layout->addWidget(link, 0, Qt::AlignLeft);
    connect(link, &QPushButton::clicked, this, requestSignal);
  };
  add(tr("Check protocol…"), &HomeWindow::askForProtocol);
  add(tr("System check…"), &HomeWindow::testComputer);
  add(tr("Tour in three steps…"), &HomeWindow::showTour);
  return tools;
}

template <typename Dialog>
void HomeWindow::openTool() {
  auto* dialog = new Dialog(this);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->open();
}

void HomeWindow::makeMenus() {
  auto* study = menuBar()->addMenu(tr("&Study"));
  study->addAction(tr("&New study…"), QKeySequence::New, this, &HomeWindow::makeStudy);
  study->addAction(tr("&Open a study…"), QKeySequence::Open, this, &HomeWindow::chooseFolder);
  study->addAction(tr("Check &protocol…"), this, &HomeWindow::askForProtocol);
  removeAction_ =
      study->addAction(tr("&Remove from list"), this, &HomeWindow::removeSelectedFromList);
  study->addAction(tr("Re&fresh"), QKeySequence::Refresh, this, &HomeWindow::refresh);
  study->addSeparator();
  study->addAction(tr("&Quit"), QKeySequence::Quit, this, &QWidget::close);
  auto* measured = menuBar()->addMenu(tr("&Measurements"));
  measured->addAction(tr("&Import a recording…"), this, &HomeWindow::openTool<ImportCutDialog>);
  measured->addAction(tr("&Fit a material…"), this, &HomeWindow::openTool<FitMaterialDialog>);
  measured->addAction(
      tr("&Build a bone of spheres…"), this, &HomeWindow::openTool<BuildBoneDialog>);
  auto* shapes = measured->addMenu(tr("&Look at a bone or a knee"));
  shapes->addAction(tr("Built-in &bone"), this, [this] { openBuiltInBone(this); });
  shapes->addAction(tr("Built-in &knee"), this, [this] { openBuiltInKnee(this); });
  shapes->addAction(tr("From a &file…"), this, [this] { chooseAndOpenShape(this); });
  auto* view = menuBar()->addMenu(tr("&View"));
  addThemesTo(*view->addMenu(tr("&Theme")));
  addLanguagesTo(*view->addMenu(tr("&Language")));
  auto* help = menuBar()->addMenu(tr("&Help"));
  // installHelpKey() handles F1 itself, wherever the focus is.
  help->addAction(
      tr("&Help for this window\tF1"), this, [this] { showHelp(helpTopicOf(*this), this); });
  help->addAction(tr("&Tour in three steps…"), this, &HomeWindow::showTour);
  help->addAction(tr("&System check…"), this, &HomeWindow::testComputer);
}

template <typename Dialog>
void HomeWindow::openDialog() {
  const auto* study = chosen();
  if (study == nullptr) return;
  askForPassphraseOfKey(study->folder, this);
  constexpr bool kNeedsNames = std::is_same_v<Dialog, EraseDialog> ||
                               std::is_same_v<Dialog, ExportDialog> ||
                               std::is_same_v<Dialog, KeyDialog>;
  if (kNeedsNames) askForPassphraseOfNames(study->folder, this);
  auto* dialog = new Dialog(*study, this);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  // The dialog may have changed what the panel shows.
  connect(dialog, &QDialog::finished, this, &HomeWindow::refresh);
  dialog->open();
}

void HomeWindow::fillInTexts() {
  const auto* study = chosen();
  if (study == nullptr) return;
  const auto folder = study->folder;
  attempt(this, MessageTopic::TextsNotChanged, [&] {
    auto opened = Study::open(folder);
    const auto& protocol = opened.protocol();
    const bool hasBegun = opened.protocols().isAnyFrozen();
    TextsDialog form(
        protocol, hasBegun ? TextsDialog::Reason::Needed : TextsDialog::Reason::NotNeeded, this);
    while (form.exec() == QDialog::Accepted && form.texts() != protocol.protocol.texts) {
      questionnaires::Problems problems;
      const auto filled = protocols::withTexts(protocol, form.texts(), problems);
      if (!filled) throw UserError(questionnaires::describe(problems.all()));
      const auto changes = changesInWords(opened, *filled).join(QStringLiteral("\n•  "));
      const bool isMeant =
          changes.isEmpty() ||
          ask(this, MessageTopic::TextsChangeMeaning, {}, QStringLiteral("•  ") + changes);
      if (!isMeant) continue;
      opened.amend(*filled, form.reason().toStdString());
      break;
    }
  });
  refresh();
}

void HomeWindow::previewChosen() {
  const auto* study = chosen();
  if (study == nullptr) return;
  attempt(this, MessageTopic::PreviewNotShown, [&] {
    auto opened = Study::open(study->folder, storage::Database::Access::ReadOnly);
    openPreview(opened.protocol(), this);
  });
}

void HomeWindow::connectPanel() {
  connect(panel_, &StudyPanel::openRequested, this, [this] {
    if (const auto* study = chosen()) openStudy(QString::fromStdString(study->folder));
  });
  connect(panel_, &StudyPanel::resumeSessionRequested, this, [this](qlonglong id) {
    if (const auto* study = chosen()) {
      openStudy(QString::fromStdString(study->folder), SessionId{id});
    }
  });
  connect(panel_, &StudyPanel::listRemovalRequested, this, &HomeWindow::removeSelectedFromList);
  connect(panel_, &StudyPanel::backupRequested, this, &HomeWindow::openDialog<BackupDialog>);
  connect(panel_, &StudyPanel::verifyRequested, this, &HomeWindow::openDialog<VerifyDialog>);
  connect(panel_, &StudyPanel::erasureRequested, this, &HomeWindow::openDialog<EraseDialog>);
  connect(panel_, &StudyPanel::keyRequested, this, &HomeWindow::openDialog<KeyDialog>);
  connect(panel_, &StudyPanel::reportRequested, this, &HomeWindow::openDialog<ReportDialog>);
  connect(panel_, &StudyPanel::exportRequested, this, &HomeWindow::openDialog<ExportDialog>);
  connect(
      panel_, &StudyPanel::statisticsRequested, this, &HomeWindow::openDialog<StatisticsDialog>);
  connect(panel_, &StudyPanel::planRequested, this, &HomeWindow::openDialog<PlanDialog>);
  connect(panel_, &StudyPanel::simulationRequested, this, &HomeWindow::openDialog<SimulateDialog>);
  connect(panel_, &StudyPanel::amendmentRequested, this, &HomeWindow::openDialog<AmendDialog>);
  connect(panel_, &StudyPanel::textsRequested, this, &HomeWindow::fillInTexts);
  connect(panel_, &StudyPanel::previewRequested, this, &HomeWindow::previewChosen);
}

void HomeWindow::connectWelcome() {
  connect(welcome_, &Welcome::tourRequested, this, &HomeWindow::showTour);
  connect(welcome_, &Welcome::systemCheckRequested, this, &HomeWindow::testComputer);
  connect(welcome_, &Welcome::newStudyRequested, this, &HomeWindow::makeStudy);
  connect(welcome_, &Welcome::folderRequested, this, &HomeWindow::chooseFolder);
  connect(welcome_, &Welcome::protocolCheckRequested, this, &HomeWindow::askForProtocol);
}

void HomeWindow::removeSelectedFromList() {
  const auto* study = chosen();
  if (study == nullptr) return;
  removeRecentStudy(QString::fromStdString(study->folder));
  refresh();
}

void HomeWindow::refresh() {
  const auto* before = chosen();
  const std::string folder = before == nullptr ? std::string() : before->folder;
  studies_.clear();
  const auto recent = recentStudies();
  list_->setRowCount(static_cast<int>(recent.size()));
  int row = 0;
  for (const auto& study : recent) {
    studies_.push_back(
        {.summary = {.folder = study.folder.toStdString(), .title = study.title.toStdString()}});
    studies_.back().opened =
        study.opened.toLocalTime().toString(QStringLiteral("yyyy-MM-dd HH:mm"));
    fillRow(row++);
  }
  welcome_->setVisible(recent.empty());
  listColumn_->setVisible(!recent.empty());
  panel_->setVisible(!recent.empty());
  removeAction_->setEnabled(!recent.empty());
  readTimer_.start();
  select(QString::fromStdString(folder));
}

void HomeWindow::select(const QString& folder) {
  int row = 0;
  for (; row < list_->rowCount(); ++row) {
    if (studies_[static_cast<std::size_t>(row)].summary.folder == folder.toStdString()) break;
  }
  list_->selectRow(row < list_->rowCount() ? row : 0);
  showChosen();
}

void HomeWindow::read(int row) {
  auto& [summary, opened, isRead] = studies_[static_cast<std::size_t>(row)];
  if (isRead) return;
  const auto titleWhenLastOpened = summary.title;
  summary = summaryOf(summary.folder);
  if (summary.title.empty()) summary.title = titleWhenLastOpened;
  isRead = true;
  fillRow(row);
}

/// Reads one study only, so that the window stays responsive.
void HomeWindow::loadNextVisibleSummary() {
  const auto sight = list_->viewport()->rect();
  for (int row = 0; row < static_cast<int>(studies_.size()); ++row) {
    if (studies_[static_cast<std::size_t>(row)].isRead) continue;
    if (!list_->visualRect(list_->model()->index(row, 0)).intersects(sight)) continue;
    read(row);
    return readTimer_.start();
  }
}

void HomeWindow::fillRow(int row) {
  const auto& [study, opened, isRead] = studies_[static_cast<std::size_t>(row)];
  const QString folder = QString::fromStdString(study.folder);
  const QString sign = study.problem.empty() ? QString() : QStringLiteral("✕ ");
  list_->setRow(
      row,
      {.title = QString::fromStdString(study.title),
       .place = tr("%1, last opened %2").arg(QDir(folder).dirName(), opened.section(u' ', 0, 0)),
       .progress =
           isRead ? sign + QString::fromStdString(sessionsInWords(study)) : QStringLiteral("…"),
       .share = shareOf(study),
       .isBroken = !study.problem.empty()});
  list_->item(row, 0)->setToolTip(folder + QLatin1Char('\n') + tr("Last opened: %1").arg(opened));
}

/// Shows the chosen study again if a session that was open elsewhere is so no longer.
void HomeWindow::lookElsewhere() {
  const auto* study = chosen();
  const bool isLookedAt = isVisible() && QApplication::activeModalWidget() == nullptr;
  if (!isLookedAt || study == nullptr || openElsewhereIn(study->unfinished) == 0) return;
  const auto now = summaryOf(study->folder);
  if (openElsewhereIn(now.unfinished) != openElsewhereIn(study->unfinished)) refresh();
}

const StudySummary* HomeWindow::chosen() const {
  const int row = list_->currentRow();
  const bool isThere = row >= 0 && row < static_cast<int>(studies_.size());
  return isThere ? &studies_[static_cast<std::size_t>(row)].summary : nullptr;
}

void HomeWindow::showChosen() {
  const auto* study = chosen();
  if (study == nullptr) return panel_->clear();
  read(list_->currentRow());
  panel_->show(*study);
}

void HomeWindow::choose(const QString& folder) {
  const auto summary = summaryOf(folder.toStdString());
  addRecentStudy(folder, QString::fromStdString(summary.title));
  refresh();
  list_->selectRow(0);
}

OperatorWindow* HomeWindow::operatorWindow() const noexcept {
  return openStudy_ ? &openStudy_->window : nullptr;
}

void HomeWindow::openStudy(const QString& folder, std::optional<SessionId> session) {
  if (openStudy_) return;
  askForPassphraseOfKey(folder.toStdString(), this);
  askForPassphraseOfNames(folder.toStdString(), this);
  const bool isOpen = attempt(this, MessageTopic::StudyNotOpened, [&] {
    openStudy_ = std::make_unique<OpenStudy>(folder.toStdString(), deviceFile_);
  });
  if (!isOpen) return;
  const auto& title = openStudy_->study.protocol().protocol.study.title;
  addRecentStudy(folder, QString::fromStdString(title));
  openStudy_->window.installEventFilter(this);
  openStudy_->window.show();
  hide();
  if (session) openStudy_->window.resumeAfterChecks(*session);
}

bool HomeWindow::eventFilter(QObject* watched, QEvent* event) {
  const bool isOperator = openStudy_ && watched == &openStudy_->window;
  if (isOperator && event->type() == QEvent::Hide && !event->spontaneous()) {
    show();  // before Qt quits because the last window was closed
    QTimer::singleShot(0, this, &HomeWindow::closeStudy);
  }
  return QMainWindow::eventFilter(watched, event);
}

void HomeWindow::closeStudy() {
  if (!openStudy_) return;
  openStudy_->window.removeEventFilter(this);
  openStudy_.reset();
  refresh();
  list_->selectRow(0);
}

void HomeWindow::makeStudy() {
  auto* dialog = new NewStudyDialog(this);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  connect(dialog, &NewStudyDialog::created, this, &HomeWindow::choose);
  connect(dialog, &NewStudyDialog::protocolRequested, this, &HomeWindow::openProtocolWindow);
  dialog->setWindowModality(Qt::NonModal);
  dialog->show();
}

void HomeWindow::showTour() {
  auto* tour = new Tour(this);
  tour->setAttribute(Qt::WA_DeleteOnClose);
  connect(tour, &QDialog::accepted, this, &HomeWindow::makeStudy);
  tour->open();
}

void HomeWindow::testComputer() {
  const auto* study = chosen();
  const bool isSound = study != nullptr && study->problem.empty();
  auto* dialog = new SelfTestDialog(
      {.study = isSound ? study->folder : std::string(), .deviceFile = deviceFile_}, this);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->open();
}

void HomeWindow::chooseFolder() {
  const QString folder =
      QFileDialog::getExistingDirectory(this, tr("The folder of a study"), QDir::homePath());
  if (!folder.isEmpty()) choose(folder);
}

void HomeWindow::askForProtocol() {
  QStringList names;
  const auto shipped = protocols::libraryProtocols();
  for (const auto& name : shipped) {
    names << tr("%1 (ships with the program)").arg(QString::fromStdString(name));
  }
  names << tr("A file of my own…");  // the last one, as in a new study
  const auto chosen = askForChoice(this, MessageTopic::WhichProtocol, names);
  if (!chosen) return;
  const auto index = static_cast<std::size_t>(*chosen);
  if (index < shipped.size()) return openProtocolWindow(QString::fromStdString(shipped[index]));
  const QString file = QFileDialog::getOpenFileName(
      this, tr("A protocol"), protocolFolder(), tr("Protocols (*.json)"));
  if (file.isEmpty()) return;
  rememberProtocolFolder(file);
  openProtocolWindow(file);
}

void HomeWindow::openProtocolWindow(const QString& source, const protocols::LoadedProtocol* shown) {
  auto* window = new ProtocolWindow(source);
  if (shown != nullptr) window->keepTextsOf(*shown);
  window->setAttribute(Qt::WA_DeleteOnClose);
  window->setAttribute(Qt::WA_QuitOnClose, false);  // the program ends with the home window
  connect(this, &QObject::destroyed, window, &QObject::deleteLater);
  window->show();
}

}  // namespace study::gui
