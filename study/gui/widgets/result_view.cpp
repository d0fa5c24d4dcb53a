#include "study/gui/widgets/result_view.h"

#include <algorithm>
#include <functional>

#include <QApplication>
#include <QClipboard>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QKeyEvent>
#include <QPushButton>
#include <QScrollBar>
#include <QVBoxLayout>

#include "study/gui/widgets/attempt.h"
#include "study/gui/widgets/labels.h"
#include "study/gui/widgets/path_field.h"
#include "study/gui/widgets/read_only_table.h"
#include "study/gui/widgets/written_file.h"
#include "study/model/new_file.h"

namespace study::gui {
namespace {

/// Numbers as programs read them: with a hyphen for the minus sign.
QString forPrograms(QString text) {
  return text.replace(u'−', u'-');
}

/// A table whose columns are as wide as their words, up to a limit. Those with more words share the
/// room that is left.
class FittedTable final : public QTableWidget {
 public:
  FittedTable(QWidget* parent, std::function<void()> copy)
      : QTableWidget(parent), copy_(std::move(copy)) {}

  void fit() {
    constexpr int kAround = 16;  // [px] of a cell
    constexpr int kWidest = 190;
    int left = width() - 2 * frameWidth() - verticalScrollBar()->sizeHint().width();
    std::vector<int> wideColumns;
    for (int column = 0; column < columnCount(); ++column) {
      const int cells = sizeHintForColumn(column) + kAround;
      if (cells > kWidest) wideColumns.push_back(column);
      const int heading = horizontalHeader()->sectionSizeHint(column);
      setColumnWidth(column, std::max(heading, std::min(kWidest, cells)));
      left -= columnWidth(column);
    }
    for (const int column : wideColumns) {
      const int more = left / static_cast<int>(wideColumns.size());
      if (more > 0) setColumnWidth(column, columnWidth(column) + more);
    }
    resizeRowsToContents();
  }

 protected:
  void resizeEvent(QResizeEvent* event) override {
    QTableWidget::resizeEvent(event);
    fit();
  }
  void keyPressEvent(QKeyEvent* event) override {
    if (event->matches(QKeySequence::Copy)) return copy_();  // Qt copies one cell
    QTableWidget::keyPressEvent(event);
  }

 private:
  std::function<void()> copy_;
};

QString textOf(const Cell& cell) {
  const auto* text = std::get_if<std::string>(&cell);
  return text == nullptr ? QString() : asText(*text);
}

}  // namespace

ResultView::ResultView(QWidget* parent)
    : QWidget(parent),
      answer_(bodyLabel({}, this)),
      results_(new QWidget(this)),
      choice_(new QComboBox(this)),
      cells_(new FittedTable(this, [this] { copy(); })) {
  constexpr int kLeastHeight = 200;  // [px]
  constexpr int kUsualHeight = 320;
  answer_->setObjectName(QStringLiteral("answer"));
  answer_->setProperty("role", QStringLiteral("text"));
  answer_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  choice_->setAccessibleName(tr("Table"));
  choice_->setObjectName(QStringLiteral("table"));
  makeReadOnly(*cells_);
  cells_->setObjectName(QStringLiteral("results"));
  cells_->setWordWrap(true);
  cells_->setTextElideMode(Qt::ElideNone);
  cells_->setMinimumHeight(kLeastHeight);
  cells_->verticalHeader()->hide();
  cells_->horizontalHeader()->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
  auto* copy = new QPushButton(tr("Copy"), this);
  auto* save = new QPushButton(tr("Save as CSV…"), this);
  copy->setObjectName(QStringLiteral("copy"));
  save->setObjectName(QStringLiteral("save"));
  auto* buttons = new QHBoxLayout;
  buttons->addWidget(choice_, 1);
  for (auto* button : {copy, save}) {
    button->setAutoDefault(false);
    button->setProperty("role", QStringLiteral("tool"));
    buttons->addWidget(button);
  }
  auto* inside = new QVBoxLayout(results_);
  inside->setContentsMargins(0, 0, 0, 0);
  inside->addLayout(buttons);
  inside->addWidget(cells_, 1);
  results_->setMinimumHeight(kUsualHeight);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(answer_);
  layout->addWidget(results_, 1);
  connect(choice_, &QComboBox::currentIndexChanged, this, &ResultView::fill);
  connect(copy, &QPushButton::clicked, this, &ResultView::copy);
  connect(save, &QPushButton::clicked, this, &ResultView::save);
}

void ResultView::show(const QString& answer, std::vector<DataTable> tables) {
  tables_ = std::move(tables);
  answer_->setText(answer);
  results_->setVisible(!tables_.empty());
  const QSignalBlocker quiet(choice_);
  choice_->clear();
  for (const auto& table : tables_) choice_->addItem(asText(table.description));
  fill();
}

void ResultView::fill() {
  cells_->clear();
  cells_->setRowCount(0);
  cells_->setColumnCount(0);
  if (tables_.empty()) return;
  const auto& shown = table();
  QStringList headings;
  for (const auto& column : shown.columns) headings << asText(column.name);
  cells_->setAccessibleName(asText(shown.description));
  cells_->setColumnCount(static_cast<int>(headings.size()));
  cells_->setHorizontalHeaderLabels(headings);
  cells_->setRowCount(static_cast<int>(shown.rows.size()));
  for (int row = 0; row < cells_->rowCount(); ++row) {
    const auto& texts = shown.rows[static_cast<std::size_t>(row)];
    for (int column = 0; column < cells_->columnCount(); ++column) {
      auto* cell = new QTableWidgetItem(textOf(texts[static_cast<std::size_t>(column)]));
      cell->setTextAlignment(Qt::AlignTop | Qt::AlignLeft);
      cells_->setItem(row, column, cell);
    }
  }
  static_cast<FittedTable*>(cells_)->fit();
}

void ResultView::copy() const {
  const bool isAll = cells_->selectedItems().size() < 2;  // one cell is always the current one
  QStringList lines;
  QStringList headings;
  for (int column = 0; column < cells_->columnCount(); ++column) {
    headings << cells_->horizontalHeaderItem(column)->text();
  }
  if (isAll) lines << headings.join(u'\t');
  for (int row = 0; row < cells_->rowCount(); ++row) {
    QStringList texts;
    for (int column = 0; column < cells_->columnCount(); ++column) {
      const auto* cell = cells_->item(row, column);
      if (isAll || cell->isSelected()) texts << cell->text();
    }
    if (!texts.isEmpty()) lines << texts.join(u'\t');
  }
  QApplication::clipboard()->setText(forPrograms(lines.join(u'\n') + u'\n'));
}

void ResultView::saveTo(const QString& path) const {
  writeNewFile(path.toStdString(), forPrograms(asText(asCsv(table()))).toStdString());
}

void ResultView::save() {
  const auto start = QDir(documentsFolder()).filePath(asText(table().name));
  QString path = QFileDialog::getSaveFileName(
      this,
      tr("Save the table"),
      unusedPath(start, QStringLiteral(".csv")),
      tr("Tables (*.csv)"),
      nullptr,
      QFileDialog::DontConfirmOverwrite);  // existing files are never overwritten
  if (path.isEmpty()) return;
  if (QFileInfo(path).suffix().isEmpty()) path += QStringLiteral(".csv");
  if (attempt(this, MessageTopic::TableNotSaved, [&] { saveTo(path); })) {
    showWrittenFileMessage(this, path);
  }
}

}  // namespace study::gui
