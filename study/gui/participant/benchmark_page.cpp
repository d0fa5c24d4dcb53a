#include "study/gui/participant/benchmark_page.h"

#include "study/gui/participant/column.h"
#include "study/gui/participant/cut_counter.h"
#include "study/gui/widgets/labels.h"
#include "study/gui/widgets/theme.h"

namespace study::gui {

BenchmarkPage::BenchmarkPage(
    const QString& text, int minimumCuts, QWidget* picture, QWidget* parent)
    : QWidget(parent),
      minimumCuts_(minimumCuts),
      count_(new CutCounter(minimumCuts, this)),
      next_(bodyLabel({}, this)) {
  auto* column = addColumn(*this);
  column->setSpacing(scaled(*this, 8));
  column->addStretch(1);
  auto* words = textLabel(text, this);
  words->setProperty("role", QStringLiteral("statement"));
  next_->setProperty("role", QStringLiteral("text"));
  for (auto* label : {words, next_}) label->setAlignment(Qt::AlignCenter);
  column->addWidget(words);
  column->addWidget(count_);
  column->addWidget(next_);
  if (picture != nullptr) column->addWidget(picture, 12);
  column->addStretch(1);
  setCuts(0);
}

void BenchmarkPage::setCuts(int cuts) {
  count_->setCount(
      cuts,
      cuts == 0 ? tr("Cuts: make %1 or more").arg(minimumCuts_)
                : tr("Cuts: %1 (make %2 or more)").arg(cuts).arg(minimumCuts_));
  next_->setText(
      cuts < minimumCuts_ ? tr("The researcher counts your cuts.")
                          : tr("That is enough. Press Next, or make more cuts first."));
}

}  // namespace study::gui
