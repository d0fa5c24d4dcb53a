#include "study/gui/widgets/result_view.h"

#include <algorithm>

#include <QApplication>
#include <QClipboard>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QPushButton>
#include <QVBoxLayout>

#include "study/gui/widgets/attempt.h"
#include "study/gui/widgets/labels.h"
#include "study/gui/widgets/path_field.h"
#include "study/gui/widgets/result_table.h"
#include "study/gui/widgets/written_file.h"
#include "study/model/new_file.h"

namespace study::gui {
namespace {

constexpr int kSomeRows = 240;  // [px]: the least height of a table that is scrolled

/// Numbers as programs read them: with a hyphen for the minus sign.
QString withHyphenMinus(QString text) {
  return text.replace(u'−', u'-');
}

}  // namespace

ResultView::ResultView(QWidget* parent)
    : QWidget(parent),
      finding_(bodyLabel({}, this)),
      more_(quietLabel({}, this)),
      results_(new QWidget(this)),
      title_(bodyLabel({}, this)),
      choice_(new QComboBox(this)),
      cells_(new ResultTable(this)),
      caveatsHeading_(bodyLabel(tr("What to keep in mind"), this)),
      caveats_(new NoteList(this)) {
  finding_->setObjectName(QStringLiteral("finding"));
  finding_->setProperty("role", QStringLiteral("finding"));
  more_->setObjectName(QStringLiteral("more-of-answer"));
  for (auto* words : {finding_, more_}) words->setTextInteractionFlags(Qt::TextSelectableByMouse);
  caveatsHeading_->setProperty("role", QStringLiteral("section"));
  caveats_->setObjectName(QStringLiteral("caveats"));
  choice_->setAccessibleName(tr("Table"));
  choice_->setObjectName(QStringLiteral("table"));
  cells_->setObjectName(QStringLiteral("results"));
  auto* copy = new QPushButton(tr("Copy"), this);
  auto* save = new QPushButton(tr("Save as CSV…"), this);
  copy->setObjectName(QStringLiteral("copy"));
  save->setObjectName(QStringLiteral("save"));
  auto* buttons = new QHBoxLayout;
  title_->setProperty("role", QStringLiteral("section"));
  buttons->addWidget(title_, 1);
  buttons->addWidget(choice_, 1);
  for (auto* button : {copy, save}) {
    button->setAutoDefault(false);
    button->setProperty("role", QStringLiteral("tool"));
    buttons->addWidget(button);
  }
  auto* inside = withoutMargins<QVBoxLayout>(results_);
  inside->addLayout(buttons);
  inside->addWidget(cells_);
  results_->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Maximum);
  auto* layout = withoutMargins<QVBoxLayout>(this, 10);
  layout->addWidget(finding_);
  layout->addWidget(results_);
  layout->addWidget(more_);
  layout->addWidget(caveatsHeading_);
  layout->addWidget(caveats_);
  layout->addStretch(1);
  giveTableRoom(kSomeRows);
  connect(choice_, &QComboBox::currentIndexChanged, this, &ResultView::fill);
  connect(copy, &QPushButton::clicked, this, &ResultView::copy);
  connect(save, &QPushButton::clicked, this, &ResultView::save);
  connect(cells_, &ResultTable::copyRequested, this, &ResultView::copy);
  connect(cells_, &ResultTable::columnsFitted, this, &ResultView::tableChanged);
}

void ResultView::show(const report::Answer& answer, std::vector<DataTable> tables) {
  tables_ = std::move(tables);
  finding_->setText(asText(answer.finding));
  finding_->setVisible(!answer.finding.empty());
  more_->setText(asText(answer.more));
  more_->setVisible(!answer.more.empty());
  std::vector<Note> caveats;
  for (const auto& caveat : answer.caveats) caveats.push_back({asText(caveat)});
  caveats_->show(caveats);
  caveats_->setVisible(!caveats.empty());
  caveatsHeading_->setVisible(!caveats.empty());
  results_->setVisible(!tables_.empty());
  const QSignalBlocker quiet(choice_);
  choice_->clear();
  for (const auto& table : tables_) choice_->addItem(asText(table.description));
  const bool isAlone = tables_.size() == 1;
  title_->setText(isAlone ? choice_->itemText(0) : QString());
  title_->setVisible(isAlone);
  choice_->setVisible(!isAlone);
  fill();
}

void ResultView::fill() {
  if (!tables_.empty()) cells_->show(table());
}

void ResultView::giveTableRoom(int room) {
  const int whole = cells_->wholeHeight();
  tableHeight_ = room < std::min(whole, kSomeRows) ? whole : std::min(whole, room);
  cells_->setFixedHeight(tableHeight_);
  // The layouts above ask again at once, and not only in the next round of events.
  results_->updateGeometry();
  updateGeometry();
}

void ResultView::copy() const {
  const bool isAll = cells_->selectedItems().size() < 2;  // one cell is always the current one
  QStringList lines;
  if (isAll) {
    QStringList headings;
    for (const auto& column : table().columns) headings << asText(column.name);
    lines << headings.join(u'\t');
  }
  lines << cells_->lines(isAll);
  QApplication::clipboard()->setText(withHyphenMinus(lines.join(u'\n') + u'\n'));
}

void ResultView::saveTo(const QString& path) const {
  writeNewFile(path.toStdString(), withHyphenMinus(asText(asCsv(table()))).toStdString());
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
