#include "study/gui/operator/findings_dialog.h"

#include <algorithm>
#include <array>

#include <QDialogButtonBox>
#include <QHeaderView>
#include <QPushButton>
#include <QTableWidget>
#include <QVBoxLayout>

#include "study/gui/widgets/desk_language.h"
#include "study/gui/widgets/message_box.h"
#include "study/gui/widgets/read_only_table.h"

namespace study::gui {
namespace {

using haptics::devices::Finding;

QString signOf(Finding finding) {
  switch (finding) {
    case Finding::Pass:
      return QStringLiteral("✔ ");
    case Finding::Warn:
      return QStringLiteral("▲ ");
    case Finding::Fail:
      return QStringLiteral("✖ ");
  }
  return {};
}

void addRow(
    QTableWidget& table, const std::string& part, const haptics::devices::CheckResult& result) {
  const int row = table.rowCount();
  table.insertRow(row);
  const std::array<QString, 5> cells{
      deskText(part),
      deskText(haptics::devices::nameOf(result.finding)),
      deskText(result.what),
      deskText(result.measured),
      deskText(result.fix)};
  for (int column = 0; column < table.columnCount(); ++column) {
    auto* cell = new QTableWidgetItem(cells[static_cast<std::size_t>(column)]);
    table.setItem(row, column, cell);
  }
  auto* verdict = table.item(row, 1);
  verdict->setText(signOf(result.finding) + verdict->text());
  auto font = verdict->font();
  font.setBold(result.finding != Finding::Pass);
  verdict->setFont(font);
}

QTableWidget* emptyTable(QWidget* parent) {
  auto* table = new QTableWidget(0, 5, parent);
  table->setHorizontalHeaderLabels(
      {FindingsDialog::tr("Part"),
       FindingsDialog::tr("Result"),
       FindingsDialog::tr("What"),
       FindingsDialog::tr("Measured"),
       FindingsDialog::tr("What to do")});
  makeReadOnly(*table);
  table->setSelectionMode(QAbstractItemView::NoSelection);
  table->setFocusPolicy(Qt::NoFocus);
  table->setWordWrap(true);
  table->verticalHeader()->hide();
  table->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  table->horizontalHeader()->setSectionResizeMode(3, QHeaderView::Stretch);
  table->horizontalHeader()->setSectionResizeMode(4, QHeaderView::Stretch);
  // Row heights depend on the column widths, which are known when the window is shown.
  table->verticalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  return table;
}

}  // namespace

FindingsDialog::FindingsDialog(
    const std::vector<Found>& found, Question asks, const CheckAgain& checkAgain, QWidget* parent)
    : QDialog(parent), verdict_(nullptr), table_(emptyTable(this)) {
  setWindowTitle(asks == Question::StartDespiteFailures ? tr("Before the session") : tr("Devices"));
  auto* layout = new QVBoxLayout(this);
  const bool isQuestion = asks == Question::StartDespiteFailures;
  auto* words = addBoxWords(
      *layout,
      isQuestion ? MessageRow::Kind::Question : MessageRow::Kind::Information,
      {},
      isQuestion ? QStringList(tr("Trials on a device that failed may break off, and are marked. "
                                  "Nothing is saved yet."))
                 : QStringList(tr("A check saves nothing.")),
      *this);
  verdict_ = qobject_cast<QLabel*>(words->itemAt(0)->widget());
  verdict_->setObjectName(QStringLiteral("verdict"));
  auto* buttons = new QDialogButtonBox(this);
  QPushButton* close = nullptr;
  if (asks == Question::StartDespiteFailures) {
    start_ = buttons->addButton(tr("Start anyway"), QDialogButtonBox::AcceptRole);
    start_->setAutoDefault(false);
    close = buttons->addButton(tr("Do not start"), QDialogButtonBox::RejectRole);
  } else {
    close = buttons->addButton(QDialogButtonBox::Close);
  }
  close->setDefault(true);
  if (checkAgain) {
    auto* again = buttons->addButton(tr("Check again"), QDialogButtonBox::ActionRole);
    again->setObjectName(QStringLiteral("check-again"));
    again->setAutoDefault(false);
    connect(again, &QPushButton::clicked, this, [this, checkAgain] { show(checkAgain()); });
  }
  connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  layout->addWidget(table_, 1);
  layout->addWidget(buttons);
  resize(1000, 520);
  close->setFocus();
  show(found);
}

void FindingsDialog::show(const std::vector<Found>& found) {
  table_->setRowCount(0);
  for (const auto& part : found) {
    for (const auto& result : part.results) addRow(*table_, part.part, result);
  }
  const bool isBad = hasFailed(found);
  if (start_ == nullptr) {
    verdict_->setText(isBad ? tr("Some checks failed.") : tr("All checks passed."));
    return;
  }
  verdict_->setText(
      isBad ? tr("Start the session although some checks failed?") : tr("All checks passed."));
  start_->setText(isBad ? tr("Start anyway") : tr("Start"));
}

bool FindingsDialog::hasFailed(const std::vector<Found>& found) {
  return std::any_of(found.begin(), found.end(), [](const Found& part) {
    return std::any_of(part.results.begin(), part.results.end(), [](const auto& result) {
      return result.finding == Finding::Fail;
    });
  });
}

}  // namespace study::gui
