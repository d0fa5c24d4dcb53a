#include "study/gui/operator/findings_dialog.h"

#include <algorithm>
#include <utility>

#include <QCoreApplication>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QPushButton>
#include <QVBoxLayout>

#include "study/gui/widgets/findings_table.h"
#include "study/gui/widgets/labels.h"
#include "study/gui/widgets/message_box.h"

namespace study::gui {

using haptics::devices::Finding;

FindingsDialog::FindingsDialog(
    const std::vector<PartFindings>& found,
    Question asks,
    const CheckAgain& checkAgain,
    QWidget* parent)
    : QDialog(parent),
      verdict_(new QLabel(this)),
      consequences_(new QWidget(this)),
      table_(new FindingsTable(this)),
      start_(new QPushButton(this)) {
  const bool isQuestion = asks == Question::StartDespiteFailures;
  setWindowTitle(isQuestion ? tr("Before the session") : tr("Devices"));
  auto* layout = withMargins<QVBoxLayout>(this, {20, 18, 20, 16}, 16);
  verdict_->setObjectName(QStringLiteral("verdict"));
  verdict_->setWordWrap(true);
  layout->addWidget(verdict_);
  layout->addWidget(consequences_);
  auto* words = new QVBoxLayout(consequences_);
  if (isQuestion) {
    addBoxWords(
        *words,
        MessageRow::Kind::Question,
        tr("Start the session all the same?"),
        {tr("The handle may jerk; trials may break off, and are marked. Nothing is saved yet.")},
        *consequences_);
  } else {
    words->addWidget(quietLabel(tr("A check saves nothing."), consequences_));
  }
  words->setContentsMargins(0, 0, 0, 0);
  table_->setFocusPolicy(Qt::NoFocus);
  auto* close = new QPushButton(isQuestion ? tr("Do not start") : tr("Close"), this);
  close->setDefault(true);
  auto* again = new QPushButton(tr("Check again"), this);
  again->setObjectName(QStringLiteral("check-again"));
  auto* help = new QPushButton(tr("Help"), this);
  help->setObjectName(QStringLiteral("help"));
  help->setProperty("role", QStringLiteral("link"));
  start_->setVisible(isQuestion);
  auto* buttons = new QHBoxLayout;
  buttons->addWidget(start_);
  buttons->addWidget(help);
  buttons->addStretch(1);
  buttons->addWidget(again);
  buttons->addWidget(close);
  for (auto* other : {again, start_, help}) other->setAutoDefault(false);
  connect(help, &QPushButton::clicked, this, &FindingsDialog::openHelp);
  connect(again, &QPushButton::clicked, this, [this, checkAgain] {
    const auto nowFound = checkAgain();
    show(nowFound);
    if (start_->isHidden() || hasFailed(nowFound)) return;
    start_->setDefault(true);
    start_->setFocus();
  });
  connect(start_, &QPushButton::clicked, this, &QDialog::accept);
  connect(close, &QPushButton::clicked, this, &QDialog::reject);
  constexpr int kAlmostAll = 1000;  // the table takes what its rows need, and the rest is empty
  layout->addWidget(table_, kAlmostAll);
  layout->addStretch(1);
  layout->addLayout(buttons);
  resizeOnScreen(*this, {1000, 460});
  close->setFocus();
  show(found);
}

/// The application shows help on F1.
void FindingsDialog::openHelp() {
  QKeyEvent press(QEvent::KeyPress, Qt::Key_F1, Qt::NoModifier);
  QCoreApplication::sendEvent(this, &press);
}

void FindingsDialog::show(const std::vector<PartFindings>& found) {
  std::vector<FindingLine> lines;
  for (const auto& part : found) {
    for (const auto& result : part.results) lines.push_back({part.part, result});
  }
  const auto worst = std::ranges::max_element(
      lines, {}, [](const FindingLine& line) { return line.found.finding; });
  const auto finding = worst == lines.end() ? Finding::Pass : worst->found.finding;
  const auto failed = std::ranges::count_if(
      lines, [](const FindingLine& line) { return line.found.finding == Finding::Fail; });
  const bool isAboutTime = std::ranges::any_of(lines, [](const FindingLine& line) {
    const auto& fix = line.found.fix.key();
    return fix == "check.round_trip.fix" || fix == "check.session.fix";
  });
  setProperty("help", isAboutTime ? "devices.md#Real time" : "devices.md#Trouble");
  table_->show(std::move(lines));
  const bool isBad = finding == Finding::Fail;
  setRole(*verdict_, isBad ? "bad" : finding == Finding::Warn ? "warn" : "good");
  verdict_->setText(
      !isBad && finding == Finding::Warn
          ? tr("!  Nothing failed. Look at the lines that are marked \"!\".")
      : !isBad ? tr("✓  All checks passed.")
      : start_->isHidden()
          ? tr("✕  Checks that failed: %1. Fix what is marked \"✕\", then check again.").arg(failed)
          : tr("✕  Checks that failed: %1.").arg(failed));
  consequences_->setVisible(isBad || start_->isHidden());
  start_->setText(isBad ? tr("Start anyway") : tr("Start"));
}

bool FindingsDialog::hasFailed(const std::vector<PartFindings>& found) {
  return std::any_of(found.begin(), found.end(), [](const PartFindings& part) {
    return std::any_of(part.results.begin(), part.results.end(), [](const auto& result) {
      return result.finding == Finding::Fail;
    });
  });
}

}  // namespace study::gui
