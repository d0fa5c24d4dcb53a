#include "study/gui/authoring/protocol_window.h"

#include <algorithm>

#include <QFileInfo>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QScrollArea>
#include <QScrollBar>
#include <QShortcut>
#include <QSignalBlocker>
#include <QSplitter>
#include <QTextBlock>
#include <QTime>
#include <QVBoxLayout>

#include "protocols/load_protocol.h"
#include "questionnaires/json/document.h"
#include "study/gui/authoring/orders_page.h"
#include "study/gui/authoring/preview_window.h"
#include "study/gui/authoring/protocol_summary.h"
#include "study/gui/authoring/save_own_protocol.h"
#include "study/gui/authoring/texts_dialog.h"
#include "study/gui/authoring/timeline_page.h"
#include "study/gui/widgets/attempt.h"
#include "study/gui/widgets/desk_language.h"
#include "study/gui/widgets/fitting_scroll.h"
#include "study/gui/widgets/labels.h"
#include "study/gui/widgets/read_only_table.h"
#include "study/gui/widgets/theme.h"
#include "study/gui/widgets/written_file.h"
#include "study/model/user_error.h"
#include "study/report/marked_text.h"

namespace study::gui {
namespace {

/// The line of the protocol's @p text, from 0, to which a problem refers.
int lineOf(const std::string& text, const questionnaires::Problem& problem) {
  // "information-punch $.introduction.en" refers to another file: use the line that names the file.
  const auto name = problem.path.substr(0, problem.path.find(' '));
  if (name.empty() || name.front() == '$') {
    return problem.line ? *problem.line : questionnaires::lineOf(text, problem.path);
  }
  const auto place = text.find('"' + name + '"');
  if (place == std::string::npos) return 0;
  return static_cast<int>(std::count(text.begin(), text.begin() + static_cast<long>(place), '\n'));
}

}  // namespace

using questionnaires::Severity;

ProtocolWindow::ProtocolWindow(const QString& source, QWidget* parent)
    : QMainWindow(parent),
      source_(source),
      title_(headingLabel({}, this)),
      verdict_(bodyLabel({}, this)),
      readAtLabel_(quietLabel({}, this)),
      previewButton_(new QPushButton(tr("Preview as participant…"), this)),
      fillButton_(new QPushButton(tr("Fill in the texts…"), this)),
      copyButton_(new QPushButton(tr("Save a copy…"), this)),
      showSourceButton_(new QPushButton(tr("Show source"), this)),
      summary_(bodyLabel({}, this)),
      text_(new QPlainTextEdit(this)),
      aboutProblems_(quietLabel({}, this)),
      problems_(new QTableWidget(0, 4, this)),
      pages_(new QTabWidget(this)),
      timeline_(new TimelinePage(this)),
      orders_(new OrdersPage(this)) {
  pages_->addTab(makeSummary(), tr("Summary"));
  pages_->addTab(timeline_, tr("Timeline"));
  pages_->addTab(orders_, tr("Orders"));
  pages_->addTab(makeProblems(), tr("Problems"));
  auto* sides = new QSplitter(Qt::Horizontal, this);
  sides->addWidget(pages_);
  sides->addWidget(text_);
  sides->setSizes({600, 600});
  prepareText();
  auto* inside = new QWidget(this);
  auto* layout = withMargins<QVBoxLayout>(inside, {24, 20, 24, 20}, 12);
  layout->addLayout(makeHead());
  layout->addWidget(verdict_);
  layout->addWidget(sides, 1);
  layout->addLayout(makeButtons());
  constexpr int kLeastHeight = 520;  // [px]; a lower window is scrolled
  inside->setMinimumHeight(kLeastHeight);
  setCentralWidget(scrolled(inside, this));
  resizeOnScreen(*this, {1240, 820});
  connectAll();
  showSource(source);
}

QHBoxLayout* ProtocolWindow::makeHead() {
  verdict_->setObjectName(QStringLiteral("verdict"));
  showSourceButton_->setObjectName(QStringLiteral("show-source"));
  showSourceButton_->setProperty("role", QStringLiteral("tool"));
  showSourceButton_->setCheckable(true);
  auto* titles = new QVBoxLayout;
  titles->addWidget(title_);
  titles->addWidget(readAtLabel_);
  auto* head = new QHBoxLayout;
  head->addLayout(titles, 1);
  head->addWidget(showSourceButton_, 0, Qt::AlignTop);
  return head;
}

QHBoxLayout* ProtocolWindow::makeButtons() {
  previewButton_->setObjectName(QStringLiteral("preview"));
  previewButton_->setProperty("role", QStringLiteral("main"));
  fillButton_->setObjectName(QStringLiteral("texts"));
  copyButton_->setObjectName(QStringLiteral("save-as"));
  copyButton_->setToolTip(tr("Saves the protocol as one of your own, to be changed there"));
  auto* buttons = new QHBoxLayout;
  buttons->addWidget(copyButton_);
  buttons->addStretch(1);
  buttons->addWidget(fillButton_);
  buttons->addWidget(previewButton_);
  return buttons;
}

void ProtocolWindow::connectAll() {
  connect(
      previewButton_, &QPushButton::clicked, this, [this] { openPreview(*checked_.loaded, this); });
  connect(showSourceButton_, &QPushButton::toggled, text_, &QWidget::setVisible);
  connect(fillButton_, &QPushButton::clicked, this, &ProtocolWindow::fillInTexts);
  connect(copyButton_, &QPushButton::clicked, this, &ProtocolWindow::saveAs);
  connect(new QShortcut(Qt::Key_Escape, this), &QShortcut::activated, this, &QWidget::close);
  connect(&watch_, &FileWatch::changed, this, &ProtocolWindow::reload);
  connect(problems_, &QTableWidget::currentCellChanged, this, &ProtocolWindow::goToProblem);
  connect(problems_, &QTableWidget::cellClicked, this, &ProtocolWindow::goToProblem);
  connect(timeline_, &TimelinePage::phaseChosen, this, [this](int phase) {
    const auto path = "$.phases[" + std::to_string(phase) + "]";
    mark(questionnaires::lineOf(checked_.text, path));
  });
}

QWidget* ProtocolWindow::makeSummary() {
  auto* scroll = new QScrollArea(this);
  scroll->setWidgetResizable(true);
  scroll->setAccessibleName(tr("Summary"));
  summary_->setObjectName(QStringLiteral("summary"));
  summary_->setAlignment(Qt::AlignTop);
  summary_->setTextFormat(Qt::RichText);
  summary_->setMargin(12);
  scroll->setWidget(summary_);
  return scroll;
}

void ProtocolWindow::prepareText() {
  text_->setVisible(false);
  text_->setReadOnly(true);
  text_->setLineWrapMode(QPlainTextEdit::WidgetWidth);
  text_->setStyleSheet(QStringLiteral("font-family: 'DejaVu Sans Mono'; font-size: 14px;"));
  text_->setAccessibleName(tr("Text of the protocol"));
}

QWidget* ProtocolWindow::makeProblems() {
  prepareProblems();
  aboutProblems_->setObjectName(QStringLiteral("about-problems"));
  auto* page = new QWidget(this);
  auto* layout = new QVBoxLayout(page);
  layout->addWidget(aboutProblems_);
  layout->addWidget(problems_, 1);
  return page;
}

void ProtocolWindow::prepareProblems() {
  problems_->setHorizontalHeaderLabels({QString(), tr("Where"), tr("Problem"), tr("What to do")});
  problems_->setAccessibleName(tr("Problems"));
  makeReadOnly(*problems_);
  problems_->setSelectionBehavior(QAbstractItemView::SelectRows);
  problems_->setSelectionMode(QAbstractItemView::SingleSelection);
  problems_->setWordWrap(true);
  auto* heads = problems_->horizontalHeader();
  heads->setSectionResizeMode(0, QHeaderView::ResizeToContents);
  heads->setSectionResizeMode(1, QHeaderView::Interactive);
  heads->setSectionResizeMode(2, QHeaderView::Stretch);
  heads->setSectionResizeMode(3, QHeaderView::Stretch);
  problems_->setColumnWidth(1, 230);
  // A scroll bar that appears leaves the columns less room, and the rows then need more.
  connect(heads, &QHeaderView::sectionResized, problems_, &QTableWidget::resizeRowsToContents);
  problems_->verticalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
}

bool ProtocolWindow::isShipped() const {
  const auto shipped = protocols::libraryProtocols();
  return std::find(shipped.begin(), shipped.end(), checked_.source) != shipped.end();
}

QStringList ProtocolWindow::filesToWatch() const {
  return isShipped() ? QStringList() : checked_.files();
}

void ProtocolWindow::reload() {
  checked_ = checkProtocol(source_.toStdString(), filled_ ? &*filled_ : nullptr);
  watch_.watch(filesToWatch());
  const QString now = QTime::currentTime().toString(QStringLiteral("HH:mm:ss"));
  readAtLabel_->setText(
      filesToWatch().isEmpty()
          ? tr("%1 ships with the program").arg(source_)
          : tr("%1, read at %2; read again whenever it changes").arg(shownPath(source_), now));
  title_->setText(
      checked_.loaded ? QString::fromStdString(checked_.loaded->protocol.study.title)
                      : QFileInfo(source_).fileName());
  showVerdict();
  showText();
  showProblems();
  if (checked_.loaded) {
    summary_->setText(report::asHtml(protocolSummary(*checked_.loaded)));
    timeline_->show(*checked_.loaded);
    orders_->show(checked_.loaded->protocol);
  } else {
    summary_->setText(tr("The summary appears here once the protocol has no errors."));
    timeline_->clear();
    orders_->clear();
  }
  previewButton_->setEnabled(checked_.loaded.has_value());
  fillButton_->setEnabled(checked_.loaded.has_value() && !checked_.loaded->blanks.empty());
  copyButton_->setVisible(isShipped());
}

void ProtocolWindow::showSource(const QString& source) {
  source_ = source;
  filled_.reset();
  const auto name = QFileInfo(source_).fileName();
  setWindowTitle(tr("Protocol — %1").arg(name));
  reload();
}

void ProtocolWindow::keepTextsOf(const protocols::LoadedProtocol& filled) {
  filled_ = filled;
  reload();
}

void ProtocolWindow::saveAs() {
  const auto file = saveAsOwn(*checked_.loaded, this);
  if (!file.isEmpty()) showSource(file);
}

void ProtocolWindow::fillInTexts() {
  const auto loaded = *checked_.loaded;  // the file may change meanwhile
  TextsDialog form(loaded, TextsDialog::Reason::NotNeeded, this);
  if (form.exec() != QDialog::Accepted || form.texts() == loaded.protocol.texts) return;
  QString file = source_;
  const bool isSaved = attempt(this, MessageTopic::TextsNotSaved, [&] {
    questionnaires::Problems problems;
    const auto filled = protocols::withTexts(loaded, form.texts(), problems);
    if (!filled) throw UserError(questionnaires::describe(problems.all()));
    if (isShipped()) {
      file = saveAsOwn(*filled, this);
    } else {
      writeProtocol(file, filled->text);
    }
  });
  if (!isSaved || file.isEmpty()) return;
  showWrittenFileMessage(this, file);
  showSource(file);
}

/// Whether there is a warning on the design, and not only on blanks in texts.
bool ProtocolWindow::hasWeaknesses() const {
  return checked_.warnings() > (blanksLeft(*checked_.loaded) > 0 ? 1 : 0);
}

/// What is found first in results: that conditions are judged by different statements; otherwise
/// the first warning on the design.
QString ProtocolWindow::gravestProblem() const {
  const auto& problems = checked_.problems;
  auto found = std::ranges::find_if(
      problems, [](const auto& problem) { return problem.what.key() == "unlike_statements"; });
  if (found == problems.end())
    found = hasWeaknesses() && blanksLeft(*checked_.loaded) > 0 ? problems.begin() + 1
                                                                : problems.begin();
  return checked_.inWords(found->what);
}

void ProtocolWindow::showVerdict() {
  const bool isUsable = checked_.loaded.has_value();
  showMarked(
      *verdict_,
      checked_.mark(),
      QString::fromStdString(checked_.verdict()) +
          (checked_.mark() == Mark::Warning
               ? tr(", under Problems. The first: %1.").arg(gravestProblem())
               : QString()));
  aboutProblems_->setText(
      checked_.problems.empty() ? tr("Nothing was found.")
      : isUsable && isShipped() && hasWeaknesses()
          ? tr("The design is kept as published, with its weaknesses. For a study of your own "
               "begin with punch-counterbalanced.")
          : QString());
  aboutProblems_->setVisible(!aboutProblems_->text().isEmpty());
  const int place = pages_->count() - 1;
  pages_->setTabText(
      place,
      checked_.problems.empty() ? tr("Problems")
                                : tr("Problems (%1)").arg(checked_.problems.size()));
  if (!isUsable) pages_->setCurrentIndex(place);
}

void ProtocolWindow::showText() {
  const QString text = QString::fromStdString(checked_.text);
  if (text_->toPlainText() == text) return;
  const int place = text_->verticalScrollBar()->value();
  text_->setPlainText(text);
  text_->verticalScrollBar()->setValue(place);
  mark(-1);
}

/// The place of a problem, with a capital unless it begins with the name of a file.
QString ProtocolWindow::placeOf(const questionnaires::Problem& problem) const {
  const auto place = checked_.placeInWords(problem.path);
  const auto file = problem.path.substr(0, problem.path.find(' '));
  const bool isFile = !file.empty() && place.startsWith(QString::fromStdString(file));
  return isFile ? place : capitalised(place);
}

void ProtocolWindow::showProblems() {
  const QSignalBlocker quiet(problems_);
  problems_->setRowCount(static_cast<int>(checked_.problems.size()));
  const auto& colours = theme();
  for (int row = 0; row < problems_->rowCount(); ++row) {
    const auto& problem = checked_.problems[static_cast<std::size_t>(row)];
    const bool isError = problem.severity == Severity::Error;
    const QString cells[]{
        signOf(isError ? Mark::Bad : Mark::Warning),
        placeOf(problem),
        capitalised(checked_.inWords(problem.what)),
        capitalised(checked_.inWords(problem.fix))};
    for (int column = 0; column < 4; ++column) {
      auto* cell = new QTableWidgetItem(cells[column]);
      cell->setTextAlignment(Qt::AlignTop | Qt::AlignLeft);
      if (column == 1) cell->setToolTip(QString::fromStdString(problem.path));
      if (column == 0) {
        const auto& fill = isError ? colours.paleBad : colours.paleWarn;
        cell->setBackground(fill.background);
        cell->setForeground(fill.text);
        cell->setTextAlignment(Qt::AlignTop | Qt::AlignHCenter);
        const auto kind = isError ? tr("error") : tr("warning");
        cell->setToolTip(kind);
        cell->setData(Qt::AccessibleTextRole, kind);
      }
      problems_->setItem(row, column, cell);
    }
  }
  problems_->setVisible(!checked_.problems.empty());
  problems_->setCurrentCell(-1, -1);
}

void ProtocolWindow::changeEvent(QEvent* event) {
  QMainWindow::changeEvent(event);
  if (event->type() != QEvent::StyleChange) return;
  showProblems();
  mark(markedLine_);
}

void ProtocolWindow::goToProblem(int row) {
  if (row < 0 || row >= static_cast<int>(checked_.problems.size())) return;
  mark(lineOf(checked_.text, checked_.problems[static_cast<std::size_t>(row)]));
}

void ProtocolWindow::mark(int line) {
  markedLine_ = line;
  const auto block = text_->document()->findBlockByNumber(line);
  if (line < 0 || !block.isValid()) {
    text_->setExtraSelections({});
    return;
  }
  QTextEdit::ExtraSelection selection;
  selection.cursor = QTextCursor(block);
  selection.format.setBackground(themeOf(*this).paleWarn.background);
  selection.format.setForeground(themeOf(*this).paleWarn.text);
  selection.format.setProperty(QTextFormat::FullWidthSelection, true);
  text_->setExtraSelections({selection});
  text_->setTextCursor(selection.cursor);
  text_->centerCursor();
}

}  // namespace study::gui
