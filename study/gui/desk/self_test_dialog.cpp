#include "study/gui/desk/self_test_dialog.h"

#include <algorithm>
#include <utility>

#include <QHBoxLayout>
#include <QVBoxLayout>

#include "study/gui/widgets/background_task.h"
#include "study/gui/widgets/labels.h"
#include "study/gui/widgets/written_file.h"

namespace study::gui {
using haptics::devices::Finding;

SelfTestDialog::SelfTestDialog(SelfTestOptions options, QWidget* parent)
    : QDialog(parent),
      options_(std::move(options)),
      outcome_(bodyLabel({}, this)),
      table_(new FindingsTable(this)),
      details_(new QCheckBox(tr("Show measurements"), this)),
      beginButton_(new QPushButton(tr("Check"), this)) {
  setWindowTitle(tr("System check"));
  outcome_->setObjectName(QStringLiteral("outcome"));
  outcome_->setVisible(false);
  table_->setObjectName(QStringLiteral("lines"));
  auto* heading = headingLabel(tr("System check"), this);
  beginButton_->setObjectName(QStringLiteral("go"));
  beginButton_->setProperty("role", QStringLiteral("main"));
  beginButton_->setFocus();
  auto* close = new QPushButton(tr("Close"), this);
  auto* buttons = new QHBoxLayout;
  buttons->addWidget(details_);
  buttons->addStretch(1);
  buttons->addWidget(close);
  buttons->addWidget(beginButton_);
  const QString where =
      options_.study.empty()
          ? tr("No study is chosen: its files are left out.")
          : tr("Study: %1").arg(shownPath(QString::fromStdString(options_.study.string())));
  auto* layout = withMargins<QVBoxLayout>(this, {24, 20, 24, 20});
  layout->addWidget(heading);
  layout->addWidget(
      quietLabel(tr("Checks devices, timing, saving and screens in a few seconds."), this));
  layout->addWidget(quietLabel(where, this));
  layout->addWidget(outcome_);
  constexpr int kAlmostAll = 1000;  // the table takes what its rows need, and the rest is empty
  layout->addWidget(table_, kAlmostAll);
  layout->addStretch(1);
  layout->addLayout(buttons);
  connect(close, &QPushButton::clicked, this, &QDialog::reject);
  connect(beginButton_, &QPushButton::clicked, this, &SelfTestDialog::test);
  connect(details_, &QCheckBox::toggled, this, &SelfTestDialog::fill);
  details_->setVisible(false);
  resizeOnScreen(*this, {1100, 640});
}

void SelfTestDialog::test() {
  std::vector<FindingLine> lines;
  const bool isDone = BackgroundTask::run(
      this, tr("Testing"), MessageTopic::SystemNotChecked, [&](const Progress& progress) {
        lines = testComputer(options_, progress);
      });
  if (!isDone) return;
  for (auto& line : testScreens()) lines.push_back(std::move(line));
  lines_ = std::move(lines);
  fill();
}

void SelfTestDialog::fill() {
  table_->show(lines_, details_->isChecked());
  Finding worst = Finding::Pass;
  for (const auto& line : lines_) worst = std::max(worst, line.found.finding);
  const auto tested = std::ranges::count_if(lines_, &FindingLine::isTested);
  const auto ofThese = std::ranges::count_if(
      lines_, [worst](const FindingLine& line) { return line.found.finding == worst; });
  static constexpr const char* kRoles[]{"good", "warn", "bad"};
  setRole(*outcome_, kRoles[static_cast<std::size_t>(worst)]);
  outcome_->setText(
      worst == Finding::Pass ? tr("✓  What was tested is as it should be.")
      : worst == Finding::Warn
          ? tr("!  A study can be run. What could be better: %1 of %2.")
          : tr("✕  Before a participant comes, what has to be mended: %1 of %2."));
  if (worst != Finding::Pass) {
    outcome_->setText(outcome_->text().arg(ofThese).arg(tested));
  }
  if (tested < std::ssize(lines_)) {
    outcome_->setText(outcome_->text() + QLatin1Char(' ') + tr("No device was tested."));
  }
  beginButton_->setText(tr("Check again"));
  setRole(*beginButton_, "");
  outcome_->setVisible(true);
  details_->setVisible(true);
}

}  // namespace study::gui
