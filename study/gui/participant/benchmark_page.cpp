#include "study/gui/participant/benchmark_page.h"

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
  auto* text = textLabel(content.text, this);
  auto* key =
      bodyLabel(tr("You will compare what you feel on the simulator with these cuts."), this);
  text->setProperty("role", QStringLiteral("statement"));
  key->setProperty("role", QStringLiteral("key"));
  enoughHint_->setProperty("role", QStringLiteral("text"));
  for (auto* label : {text, key, enoughHint_}) stage_->words().addWidget(label);
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
