#include "study/gui/authoring/orders_page.h"

#include <algorithm>

#include <fmt/ranges.h>

#include <QHBoxLayout>
#include <QHeaderView>
#include <QRegularExpressionValidator>
#include <QVBoxLayout>

#include "protocols/orders/schedule.h"
#include "study/gui/widgets/desk_language.h"
#include "study/gui/widgets/labels.h"
#include "study/gui/widgets/read_only_table.h"

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

std::string inWords(const protocols::Balance& balance) {
  if (balance.multipleOf == 1) return translated("the same order for everyone");
  if (balance.multipleOf == 0) return translated("drawn for everyone, and never balanced exactly");
  return translated(
      balance.isBalanced ? "balanced; it is for every multiple of {}"
                         : "not balanced; it is for every multiple of {}",
      balance.multipleOf);
}

/// "6 · 0 · 0"
std::string joined(const std::vector<int>& counts) {
  return fmt::format("{}", fmt::join(counts, " · "));
}

/// How often each condition has each position and directly follows each other one, for the first
/// cohort.
DataTable balanceTable(
    const protocols::Protocol& protocol, std::size_t participants, std::uint64_t seed) {
  const auto titleOf = [&](const std::string& id) { return protocol.condition(id)->title; };
  DataTable table{
      .name = "balance",
      .description = translated("Balance"),
      .columns = {
          Heading::ofWords(translated("Part")),
          Heading::ofWords(translated("Condition")),
          Heading::ofWords(translated("Balance")),
          Heading::ofWords(translated("Times at position 1, 2, …")),
          Heading::ofWords(translated("Times right after"))}};
  for (const auto& phase : protocol.phases) {
    if (phase.type != protocols::PhaseType::Block) continue;
    const auto balance =
        protocols::balanceOf(protocol, phase, seed, protocol.cohorts.front().id, participants);
    for (std::size_t i = 0; i < balance.conditions.size(); ++i) {
      std::vector<std::string> after;
      for (std::size_t j = 0; j < balance.conditions.size(); ++j) {
        if (j == i) continue;
        after.push_back(fmt::format("{} {}", titleOf(balance.conditions[j]), balance.after[i][j]));
      }
      table.rows.push_back(
          {phaseTitle(phase.id).toStdString(),
           titleOf(balance.conditions[i]),
           inWords(balance),
           joined(balance.positionCounts[i]),
           fmt::format("{}", fmt::join(after, " · "))});
    }
  }
  return table;
}

int plannedParticipants(const protocols::Protocol& protocol) {
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
      balance_(new ResultTable(this)) {
  participants_->setRange(1, kMostOrders);
  participants_->setAccessibleName(tr("Participants of every cohort"));
  seed_->setAccessibleName(tr("Seed"));
  seed_->setValidator(
      new QRegularExpressionValidator(QRegularExpression(QStringLiteral("[0-9]{0,15}")), seed_));
  makeReadOnly(*table_);
  table_->setSelectionBehavior(QAbstractItemView::SelectRows);
  table_->horizontalHeader()->setStretchLastSection(true);
  table_->setAccessibleName(tr("Orders"));
  connect(balance_, &ResultTable::columnsFitted, this, [this] {
    balance_->setMaximumHeight(balance_->wholeHeight());
  });
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
  layout->addWidget(balance_, 1);
  connect(participants_, &QSpinBox::valueChanged, this, &OrdersPage::fill);
  connect(seed_, &QLineEdit::textChanged, this, &OrdersPage::fill);
}

void OrdersPage::clear() {
  protocol_.reset();
  table_->setRowCount(0);
  balance_->show(DataTable());
}

void OrdersPage::show(const protocols::Protocol& protocol) {
  const bool isFirst = !protocol_;
  protocol_ = protocol;
  const QString drawn = tr("1 (the protocol has no seed)");
  seed_->setPlaceholderText(protocol.seed ? QString::number(*protocol.seed) : drawn);
  if (isFirst) participants_->setValue(plannedParticipants(protocol));
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
  balance_->show(
      balanceTable(*protocol_, static_cast<std::size_t>(participants_->value()), seed()));
}

}  // namespace study::gui
