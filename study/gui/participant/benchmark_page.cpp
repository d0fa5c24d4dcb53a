#include "study/gui/participant/benchmark_page.h"

#include <algorithm>

#include "study/gui/participant/column.h"
#include "study/gui/participant/cut_counter.h"
#include "study/gui/participant/stage.h"
#include "study/gui/widgets/labels.h"

namespace study::gui {

BenchmarkPage::BenchmarkPage(const Content& content, QWidget* picture, QWidget* parent)
    : QWidget(parent),
      minimumCuts_(content.minimumCuts),
      stage_(new Stage(tr("Benchmark: real cuts"), picture, Stage::Panel::Card, this)),
      cutCounter_(new CutCounter(content.minimumCuts, {tr("cut"), tr("cuts")}, this)),
      enoughHint_(bodyLabel(tr("That is enough. Press Next, or make more cuts first."), this)),
      next_(new QPushButton(content.next, this)) {
  addColumn(*this, ColumnWidth::Page)->addWidget(stage_);
  stage_->setCaption(tr("The real instrument, not the simulator"));
  stage_->stopHint().setText(
      tr("To pause or stop: put the instrument down, and tell the researcher."));
  // what stands before the steps is a warning
  const auto steps = content.text.indexOf(QStringLiteral("\n\n1. "));
  auto* warning = bodyLabel(content.text.left(std::max<qsizetype>(0, steps)), this);
  auto* text = textLabel(content.text.mid(steps < 0 ? 0 : steps + 2), this);
  auto* purpose =
      bodyLabel(tr("You will compare what you feel on the simulator with these cuts."), this);
  warning->setProperty("role", QStringLiteral("key"));
  warning->setVisible(steps > 0);
  for (auto* label : {text, purpose}) label->setProperty("role", QStringLiteral("statement"));
  enoughHint_->setProperty("role", QStringLiteral("text"));
  for (auto* label : {warning, text, purpose, enoughHint_}) stage_->words().addWidget(label);
  stage_->setCounter(cutCounter_);
  stage_->addButton(next_);
  connect(next_, &QPushButton::clicked, this, &BenchmarkPage::finishRequested);
  setCuts(0);
}

void BenchmarkPage::setCuts(int cuts) {
  const int left = minimumCuts_ - cuts;
  cutCounter_->setCount(cuts);
  enoughHint_->setVisible(left <= 0);
  next_->setEnabled(left <= 0);
  stage_->setReason(left > 0 ? tr("The researcher counts your cuts.") : QString());
}

}  // namespace study::gui
