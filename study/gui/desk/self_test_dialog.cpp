#include "study/gui/desk/self_test_dialog.h"

#include <algorithm>
#include <utility>

#include <QHBoxLayout>
#include <QHeaderView>
#include <QVBoxLayout>

#include "study/gui/widgets/background_task.h"
#include "study/gui/widgets/desk_language.h"
#include "study/gui/widgets/labels.h"
#include "study/gui/widgets/read_only_table.h"
#include "study/gui/widgets/theme.h"
#include "study/gui/widgets/written_file.h"

namespace study::gui {
namespace {

using haptics::devices::Finding;

const Fill& rowFill(const Theme& colours, Finding finding) {
  return finding == Finding::Pass   ? colours.paleGood
         : finding == Finding::Warn ? colours.paleWarn
                                    : colours.paleBad;
}

QString describe(Finding finding) {
  return finding == Finding::Pass   ? SelfTestDialog::tr("✓ good")
         : finding == Finding::Warn ? SelfTestDialog::tr("! look at it")
                                    : SelfTestDialog::tr("✕ fix it");
}

}  // namespace

SelfTestDialog::SelfTestDialog(SelfTestOptions order, QWidget* parent)
    : QDialog(parent),
      order_(std::move(order)),
      outcome_(bodyLabel({}, this)),
      table_(new QTableWidget(0, 5, this)),
      details_(new QCheckBox(tr("Show measurements"), this)) {
  setWindowTitle(tr("System check"));
  outcome_->setObjectName(QStringLiteral("outcome"));
  outcome_->setVisible(false);
  table_->setObjectName(QStringLiteral("lines"));
  table_->setAccessibleName(tr("What was found"));
  table_->setHorizontalHeaderLabels(
      {tr("Part"), tr("Result"), tr("What"), tr("Finding"), tr("What to do")});
  makeReadOnly(*table_);
  table_->setSelectionMode(QAbstractItemView::NoSelection);
  table_->setWordWrap(true);
  table_->setTextElideMode(Qt::ElideNone);
  table_->verticalHeader()->hide();
  table_->verticalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  auto* heads = table_->horizontalHeader();
  heads->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
  heads->setSectionResizeMode(QHeaderView::ResizeToContents);
  heads->setSectionResizeMode(3, QHeaderView::Stretch);
  heads->setSectionResizeMode(4, QHeaderView::Stretch);
  // A scroll bar that appears leaves the columns less room, and the rows then need more.
  connect(heads, &QHeaderView::sectionResized, table_, &QTableWidget::resizeRowsToContents);
  auto* heading = bodyLabel(tr("System check"), this);
  heading->setProperty("role", QStringLiteral("heading"));
  auto* go = new QPushButton(tr("Test"), this);
  go->setObjectName(QStringLiteral("go"));
  go->setProperty("role", QStringLiteral("main"));
  auto* close = new QPushButton(tr("Close"), this);
  auto* buttons = new QHBoxLayout;
  buttons->addWidget(details_);
  buttons->addStretch(1);
  buttons->addWidget(close);
  buttons->addWidget(go);
  const QString where = order_.study.empty()
                            ? tr("No study is chosen: its files are left out.")
                            : shownPath(QString::fromStdString(order_.study.string()));
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(24, 20, 24, 20);
  layout->addWidget(heading);
  layout->addWidget(quietLabel(
      tr("Checks devices, timing, saving and screens in a few seconds. %1").arg(where), this));
  layout->addWidget(outcome_);
  layout->addWidget(table_, 1);
  layout->addLayout(buttons);
  connect(close, &QPushButton::clicked, this, &QDialog::reject);
  connect(go, &QPushButton::clicked, this, &SelfTestDialog::test);
  connect(details_, &QCheckBox::toggled, this, &SelfTestDialog::fill);
  details_->setVisible(false);
  resize(1100, 640);
}

void SelfTestDialog::test() {
  std::vector<SelfTestLine> lines;
  const bool isDone = BackgroundTask::run(
      this, tr("Testing"), Matter::SystemNotChecked, [&](const Progress& progress) {
        lines = testComputer(order_, progress);
      });
  if (!isDone) return;
  for (auto& line : testScreens()) lines.push_back(std::move(line));
  lines_ = std::move(lines);
  fill();
}

void SelfTestDialog::fill() {
  table_->clearSpans();
  table_->setRowCount(static_cast<int>(lines_.size()));
  int first = 0;  // row of the part
  Finding worst = Finding::Pass;
  for (int row = 0; row < table_->rowCount(); ++row) {
    const auto& [part, found, details] = lines_[static_cast<std::size_t>(row)];
    worst = std::max(worst, found.finding);
    const QString cells[]{
        capitalised(deskText(part)),
        describe(found.finding),
        capitalised(deskText(found.what)),
        details_->isChecked() && !details.empty()
            ? deskText(found.measured) + QLatin1Char('\n') + asText(details)
            : deskText(found.measured),
        deskText(found.fix)};
    for (int column = 0; column < 5; ++column) {
      auto* cell = new QTableWidgetItem(cells[column]);
      cell->setTextAlignment(Qt::AlignTop | Qt::AlignLeft);
      if (column == 1) {
        const auto& fill = rowFill(themeOf(*this), found.finding);
        cell->setBackground(fill.background);
        cell->setForeground(fill.text);
      }
      table_->setItem(row, column, cell);
    }
    if (lines_[static_cast<std::size_t>(first)].part != part) first = row;
    if (row > first) table_->setSpan(first, 0, row - first + 1, 1);
  }
  static constexpr const char* kRoles[]{"good", "warn", "bad"};
  setRole(*outcome_, kRoles[static_cast<std::size_t>(worst)]);
  outcome_->setText(
      worst == Finding::Pass ? tr("✓  Everything is as it should be.")
      : worst == Finding::Warn
          ? tr("!  A study can be run. Look at the lines that are marked \"!\".")
          : tr("✕  Fix the lines that are marked \"✕\" before a participant comes."));
  outcome_->setVisible(true);
  details_->setVisible(true);
}

}  // namespace study::gui
