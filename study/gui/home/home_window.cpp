#include "study/gui/home/home_window.h"

#include <algorithm>
#include <type_traits>
#include <utility>

#include <QDir>
#include <QEvent>
#include <QFileDialog>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLocale>
#include <QMenuBar>
#include <QPainter>
#include <QScrollArea>
#include <QScrollBar>
#include <QStyle>
#include <QStyledItemDelegate>
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
#include "study/gui/widgets/labels.h"
#include "study/gui/widgets/message_box.h"
#include "study/gui/widgets/read_only_table.h"
#include "study/gui/widgets/studio_settings.h"
#include "study/gui/widgets/theme.h"

namespace study::gui {
namespace {

/// Paints a progress bar below the text of a study's cell.
class ProgressDelegate final : public QStyledItemDelegate {
 public:
  /// The role of the share of the planned sessions that are completed, 0 to 1; no bar without it.
  static constexpr int kShare = Qt::UserRole;

  using QStyledItemDelegate::QStyledItemDelegate;

  void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index)
      const override {
    QStyledItemDelegate::paint(painter, option, index);
    const auto share = index.data(kShare);
    if (!share.isValid()) return;
    const auto& colours = themeOf(*option.widget);
    const bool isSelected = option.state.testFlag(QStyle::State_Selected);
    const QColor ink = isSelected ? colours.selection.text : colours.accent.background;
    QRectF track = QRectF(option.rect).adjusted(kMargin + 3.0, 0.0, -kMargin, -kMargin);
    track.setTop(track.bottom() - kHeight);
    painter->save();
    painter->setRenderHint(QPainter::Antialiasing);
    painter->setPen(ink);
    painter->drawRoundedRect(track, kHeight / 2, kHeight / 2);
    track.setWidth(track.width() * share.toDouble());
    painter->setBrush(ink);
    if (track.width() > 0.0) painter->drawRoundedRect(track, kHeight / 2, kHeight / 2);
    painter->restore();
  }

  QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override {
    const auto own = QStyledItemDelegate::sizeHint(option, index);
    const bool hasBar = index.data(kShare).isValid();
    return hasBar ? own + QSize(0, static_cast<int>(kHeight + kMargin)) : own;
  }

 private:
  static constexpr double kHeight = 6.0;  // [px]
  static constexpr double kMargin = 6.0;
};

/// The share of the planned sessions that are completed; invalid if no number is planned.
QVariant shareOf(const StudySummary& study) {
  int completed = 0;
  int planned = 0;
  for (const auto& cohort : study.cohorts) {
    completed += std::min(cohort.completed, cohort.planned);
    planned += cohort.planned;
  }
  return planned == 0 ? QVariant() : QVariant(static_cast<double>(completed) / planned);
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
  reading_.setSingleShot(true);
  connect(&reading_, &QTimer::timeout, this, &HomeWindow::loadNextVisibleSummary);
  makeContents();
  resize(1240, 740);
}

void HomeWindow::makeContents() {
  language_ = deskLanguage();
  list_ = new QTableWidget(0, 3, this);
  panel_ = new StudyPanel(this);
  auto* inside = new QWidget(this);
  columns_ = new QHBoxLayout(inside);
  columns_->setContentsMargins(24, 12, 24, 20);
  columns_->setSpacing(20);
  columns_->addWidget(makeList(), 1);
  columns_->addWidget(panel_, 1);
  auto* scroll = new QScrollArea(this);
  scroll->setWidgetResizable(true);
  scroll->setFocusPolicy(Qt::NoFocus);
  scroll->setWidget(inside);
  setCentralWidget(scroll);
  menuBar()->clear();
  makeMenus();
  connectPanel();
  arrange();
  refresh();
}

void HomeWindow::arrange() {
  constexpr int kRoomForTwo = 1000;  // [px]
  constexpr int kLeastOfList = 170;
  const bool isWide = width() >= kRoomForTwo;
  columns_->setDirection(isWide ? QBoxLayout::LeftToRight : QBoxLayout::TopToBottom);
  list_->setMinimumHeight(kLeastOfList);
  const auto margins = columns_->contentsMargins();
  const int bar = style()->pixelMetric(QStyle::PM_ScrollBarExtent, nullptr, this);
  const int room = width() - margins.left() - margins.right() - bar;
  const int both = room - columns_->spacing();
  const int list = columns_->itemAt(0)->minimumSize().width();
  panel_->fitInto(isWide ? std::min(both / 2, both - list) : room);
}

void HomeWindow::resizeEvent(QResizeEvent* event) {
  QMainWindow::resizeEvent(event);
  arrange();
  reading_.start();
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
  list_->setHorizontalHeaderLabels({tr("Study"), tr("Sessions"), tr("Last opened")});
  list_->setAccessibleName(tr("Studies"));
  list_->setObjectName(QStringLiteral("studies"));
  list_->setSelectionBehavior(QAbstractItemView::SelectRows);
  list_->setSelectionMode(QAbstractItemView::SingleSelection);
  makeReadOnly(*list_);
  list_->setShowGrid(false);
  list_->setWordWrap(true);
  list_->verticalHeader()->hide();
  list_->verticalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  auto* heads = list_->horizontalHeader();
  heads->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
  heads->setSectionResizeMode(0, QHeaderView::Stretch);
  heads->setSectionResizeMode(1, QHeaderView::Interactive);
  heads->setSectionResizeMode(2, QHeaderView::ResizeToContents);
  list_->setColumnWidth(1, 170);
  list_->setItemDelegateForColumn(1, new ProgressDelegate(list_));
  connect(
      list_->verticalScrollBar(), &QScrollBar::valueChanged, this, [this] { reading_.start(); });
  connect(list_, &QTableWidget::itemSelectionChanged, this, &HomeWindow::showChosen);
  connect(list_, &QTableWidget::cellDoubleClicked, this, [this] {
    const auto* study = chosen();
    if (study != nullptr) openStudy(QString::fromStdString(study->folder));
  });
  none_ = quietLabel(tr("The studies that you make or open are listed here."), side);
  auto* make = new QPushButton(tr("New study…"), side);
  make->setObjectName(QStringLiteral("new-study"));
  auto* open = new QPushButton(tr("Open a folder…"), side);
  auto* read = new QPushButton(tr("Check protocol…"), side);
  connect(make, &QPushButton::clicked, this, &HomeWindow::makeStudy);
  connect(open, &QPushButton::clicked, this, &HomeWindow::chooseFolder);
  connect(read, &QPushButton::clicked, this, &HomeWindow::askForProtocol);
  auto* buttons = new QHBoxLayout;
  for (auto* button : {make, open, read}) buttons->addWidget(button, 1);
  auto* layout = new QVBoxLayout(side);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(12);
  layout->addWidget(titleLabel(tr("Studies"), side));
  layout->addWidget(list_, 1);
  layout->addWidget(none_);
  layout->addLayout(buttons);
  layout->addStretch(0);
  return side;
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
  study->addAction(tr("&Open a folder…"), QKeySequence::Open, this, &HomeWindow::chooseFolder);
  study->addAction(tr("Check &protocol…"), this, &HomeWindow::askForProtocol);
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
    const bool hasBegun = opened.protocols().current().frozenUtc.has_value();
    TextsDialog form(
        protocol, hasBegun ? TextsDialog::Reason::Needed : TextsDialog::Reason::NotNeeded, this);
    if (form.exec() != QDialog::Accepted || form.texts() == protocol.protocol.texts) return;
    questionnaires::Problems problems;
    const auto filled = protocols::withTexts(protocol, form.texts(), problems);
    if (!filled) throw UserError(questionnaires::describe(problems.all()));
    opened.amend(*filled, form.reason().toStdString());
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
  connect(panel_, &StudyPanel::newStudyRequested, this, &HomeWindow::makeStudy);
  connect(panel_, &StudyPanel::tourRequested, this, &HomeWindow::showTour);
  connect(panel_, &StudyPanel::systemCheckRequested, this, &HomeWindow::testComputer);
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
    const QString opened = study.opened.toLocalTime().toString(QStringLiteral("yyyy-MM-dd HH:mm"));
    auto* day = new QTableWidgetItem(opened.section(u' ', 0, 0));
    day->setToolTip(opened);
    list_->setItem(row, 2, day);
    fillRow(row++);
  }
  list_->setVisible(!recent.empty());
  none_->setVisible(recent.empty());
  reading_.start();
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
  auto& [summary, isRead] = studies_[static_cast<std::size_t>(row)];
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
    return reading_.start();
  }
}

void HomeWindow::fillRow(int row) {
  const auto& [study, isRead] = studies_[static_cast<std::size_t>(row)];
  const QString folder = QString::fromStdString(study.folder);
  auto* title = new QTableWidgetItem(
      QString::fromStdString(study.title) + QLatin1Char('\n') + QDir(folder).dirName());
  title->setToolTip(folder);
  const QString sign = study.problem.empty() ? QString() : QStringLiteral("✕ ");
  const QString words = QString::fromStdString(sessionsInWords(study));
  auto* sessions = new QTableWidgetItem(isRead ? sign + words : QStringLiteral("…"));
  sessions->setData(ProgressDelegate::kShare, shareOf(study));
  list_->setItem(row, 0, title);
  list_->setItem(row, 1, sessions);
  for (int column = 0; column < list_->columnCount(); ++column) {
    list_->item(row, column)->setTextAlignment(Qt::AlignTop | Qt::AlignLeft);
  }
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
  return open_ ? &open_->window : nullptr;
}

void HomeWindow::openStudy(const QString& folder, std::optional<SessionId> session) {
  if (open_) return;
  askForPassphraseOfKey(folder.toStdString(), this);
  askForPassphraseOfNames(folder.toStdString(), this);
  const bool isOpen = attempt(this, MessageTopic::StudyNotOpened, [&] {
    open_ = std::make_unique<OpenStudy>(folder.toStdString(), deviceFile_);
  });
  if (!isOpen) return;
  const auto& title = open_->study.protocol().protocol.study.title;
  addRecentStudy(folder, QString::fromStdString(title));
  open_->window.installEventFilter(this);
  open_->window.show();
  hide();
  if (session) open_->window.resumeAfterChecks(*session);
}

bool HomeWindow::eventFilter(QObject* watched, QEvent* event) {
  const bool isOperator = open_ && watched == &open_->window;
  if (isOperator && event->type() == QEvent::Hide && !event->spontaneous()) {
    show();  // before Qt quits because the last window was closed
    QTimer::singleShot(0, this, &HomeWindow::closeStudy);
  }
  return QMainWindow::eventFilter(watched, event);
}

void HomeWindow::closeStudy() {
  if (!open_) return;
  open_->window.removeEventFilter(this);
  open_.reset();
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
  QStringList names{tr("A file of my own…")};
  const auto shipped = protocols::libraryProtocols();
  for (const auto& name : shipped) {
    names << tr("%1 (ships with the program)").arg(QString::fromStdString(name));
  }
  const auto chosen = askForChoice(this, MessageTopic::WhichProtocol, names);
  if (!chosen) return;
  if (*chosen > 0) {
    const auto index = static_cast<std::size_t>(*chosen) - 1;
    return openProtocolWindow(QString::fromStdString(shipped[index]));
  }
  const QString file = QFileDialog::getOpenFileName(
      this, tr("A protocol"), protocolFolder(), tr("Protocols (*.json)"));
  if (file.isEmpty()) return;
  rememberProtocolFolder(file);
  openProtocolWindow(file);
}

void HomeWindow::openProtocolWindow(const QString& source) {
  auto* window = new ProtocolWindow(source);
  window->setAttribute(Qt::WA_DeleteOnClose);
  window->setAttribute(Qt::WA_QuitOnClose, false);  // the program ends with the home window
  connect(this, &QObject::destroyed, window, &QObject::deleteLater);
  window->show();
}

}  // namespace study::gui
