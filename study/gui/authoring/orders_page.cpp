#include "study/gui/authoring/orders_page.h"

#include <algorithm>

#include <QHBoxLayout>
#include <QHeaderView>
#include <QRegularExpressionValidator>
#include <QVBoxLayout>

#include "protocols/orders/schedule.h"
#include "study/gui/widgets/labels.h"
#include "study/gui/widgets/read_only_table.h"
#include "study/results/balance_words.h"

namespace study::gui {
namespace {

constexpr int kMostOrders = 200;  // per cohort; the command line prints more

/// The conditions of a block in the order of its trials: "2 KF · 1 Interpolation".
QString inOrder(const protocols::PlannedBlock& block, const protocols::Protocol& protocol) {
  QStringList trials;
  for (const auto& trial : block.trials) {
    trials << QStringLiteral("%1 %2")
                  .arg(trial.label)
                  .arg(QString::fromStdString(protocol.condition(trial.condition)->title));
  }
  return trials.join(QStringLiteral(" · "));
}

int plannedOf(const protocols::Protocol& protocol) {
  int most = 0;
  for (const auto& cohort : protocol.cohorts) most = std::max(most, cohort.planned);
  return most > 0 ? std::min(most, kMostOrders) : 12;
}

}  // namespace

OrdersPage::OrdersPage(QWidget* parent)
    : QWidget(parent),
      participants_(new QSpinBox(this)),
      seed_(new QLineEdit(this)),
      table_(new QTableWidget(this)),
      balance_(new QTextBrowser(this)) {
  participants_->setRange(1, kMostOrders);
  participants_->setAccessibleName(tr("Participants of every cohort"));
  seed_->setAccessibleName(tr("Seed"));
  seed_->setValidator(
      new QRegularExpressionValidator(QRegularExpression(QStringLiteral("[0-9]{0,15}")), seed_));
  makeReadOnly(*table_);
  table_->setSelectionBehavior(QAbstractItemView::SelectRows);
  table_->verticalHeader()->hide();
  table_->horizontalHeader()->setStretchLastSection(true);
  table_->setAccessibleName(tr("Orders"));
  balance_->setMaximumHeight(120);
  balance_->setAccessibleName(tr("Balance"));
  balance_->setLineWrapMode(QTextEdit::NoWrap);
  balance_->setStyleSheet(QStringLiteral("font-family: 'DejaVu Sans Mono'; font-size: 14px;"));
  auto* choices = new QHBoxLayout;
  choices->addWidget(new QLabel(tr("Participants of every cohort"), this));
  choices->addWidget(participants_);
  choices->addWidget(new QLabel(tr("Seed"), this));
  choices->addWidget(seed_, 1);
  auto* layout = new QVBoxLayout(this);
  layout->addLayout(choices);
  layout->addWidget(quietLabel(
      tr("Number of the alternative, then the condition: do not look if you must stay blinded."),
      this));
  layout->addWidget(table_, 1);
  layout->addWidget(balance_);
  connect(participants_, &QSpinBox::valueChanged, this, &OrdersPage::fill);
  connect(seed_, &QLineEdit::textChanged, this, &OrdersPage::fill);
}

void OrdersPage::clear() {
  protocol_.reset();
  table_->setRowCount(0);
  balance_->clear();
}

void OrdersPage::show(const protocols::Protocol& protocol) {
  const bool isFirst = !protocol_;
  protocol_ = protocol;
  const QString drawn = tr("1 (the protocol has no seed)");
  seed_->setPlaceholderText(protocol.seed ? QString::number(*protocol.seed) : drawn);
  if (isFirst) participants_->setValue(plannedOf(protocol));
  fill();
}

std::uint64_t OrdersPage::seed() const {
  bool isNumber = false;
  const auto own = seed_->text().toULongLong(&isNumber);
  return isNumber ? own : protocol_->seed.value_or(1);
}

void OrdersPage::fill() {
  if (!protocol_) return;
  QStringList heads{tr("Cohort"), tr("Participant")};
  std::vector<std::string> blocks;
  for (const auto& phase : protocol_->phases) {
    if (phase.type != protocols::PhaseType::Block) continue;
    blocks.push_back(phase.id);
    heads << phaseTitle(phase.id);
  }
  table_->setColumnCount(static_cast<int>(heads.size()));
  table_->setHorizontalHeaderLabels(heads);
  table_->setRowCount(static_cast<int>(protocol_->cohorts.size()) * participants_->value());
  int row = 0;
  for (const auto& cohort : protocol_->cohorts) {
    for (int slot = 0; slot < participants_->value(); ++slot, ++row) {
      const auto schedule =
          protocols::scheduleFor(*protocol_, seed(), cohort.id, static_cast<std::uint64_t>(slot));
      table_->setItem(row, 0, new QTableWidgetItem(cohortTitle(*protocol_, cohort.id)));
      table_->setItem(row, 1, new QTableWidgetItem(QString::number(slot + 1)));
      for (int column = 2; column < heads.size(); ++column) {
        const auto* block = schedule.block(blocks[static_cast<std::size_t>(column) - 2]);
        table_->setItem(row, column, new QTableWidgetItem(inOrder(*block, *protocol_)));
      }
    }
  }
  table_->resizeColumnsToContents();
  balance_->setPlainText(
      QString::fromStdString(
          balanceInWords(*protocol_, static_cast<std::size_t>(participants_->value()), seed()))
          .trimmed());
}

}  // namespace study::gui
