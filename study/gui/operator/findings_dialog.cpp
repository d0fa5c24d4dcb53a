#include "study/gui/operator/findings_dialog.h"

#include <algorithm>
#include <array>

#include <QDialogButtonBox>
#include <QHeaderView>
#include <QPushButton>
#include <QTableWidget>
#include <QVBoxLayout>

#include "study/gui/widgets/labels.h"
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
      QString::fromStdString(part),
      QString::fromStdString(haptics::devices::nameOf(result.finding)),
      QString::fromStdString(result.what),
      QString::fromStdString(result.measured),
      QString::fromStdString(result.fix)};
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

QTableWidget* tableOf(const std::vector<FindingsDialog::Found>& found, QWidget* parent) {
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
  for (const auto& part : found) {
    for (const auto& result : part.results) addRow(*table, part.part, result);
  }
  table->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  table->horizontalHeader()->setSectionResizeMode(3, QHeaderView::Stretch);
  table->horizontalHeader()->setSectionResizeMode(4, QHeaderView::Stretch);
  // Row heights depend on the column widths, which are known when the window is shown.
  table->verticalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  return table;
}

}  // namespace

FindingsDialog::FindingsDialog(const std::vector<Found>& found, Asks asks, QWidget* parent)
    : QDialog(parent) {
  setWindowTitle(asks == Asks::GoWithout ? tr("Before the session") : tr("Devices"));
  auto* layout = new QVBoxLayout(this);
  auto* buttons = new QDialogButtonBox(this);
  if (asks == Asks::GoWithout) {
    layout->addWidget(bodyLabel(
        tr("Not everything is fit for this session. Begin all the same? Trials on a device that "
           "failed may break off, and they are marked; what stands in a text is read as it is."),
        this));
    auto* without = buttons->addButton(tr("Begin all the same"), QDialogButtonBox::AcceptRole);
    without->setAutoDefault(false);
    auto* no = buttons->addButton(tr("No"), QDialogButtonBox::RejectRole);
    no->setDefault(true);
    no->setFocus();
  } else {
    buttons->addButton(QDialogButtonBox::Close);
  }
  connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  layout->addWidget(tableOf(found, this), 1);
  layout->addWidget(buttons);
  resize(1000, 520);
}

bool FindingsDialog::hasFailed(const std::vector<Found>& found) {
  return std::any_of(found.begin(), found.end(), [](const Found& part) {
    return std::any_of(part.results.begin(), part.results.end(), [](const auto& result) {
      return result.finding == Finding::Fail;
    });
  });
}

}  // namespace study::gui
