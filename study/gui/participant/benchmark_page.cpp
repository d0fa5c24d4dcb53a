#include "study/gui/participant/benchmark_page.h"

#include "study/gui/participant/column.h"
#include "study/gui/participant/cut_counter.h"
#include "study/gui/widgets/labels.h"
#include "study/gui/widgets/theme.h"

namespace study::gui {

BenchmarkPage::BenchmarkPage(
    const QString& text, int minimumCuts, QWidget* picture, QWidget* parent)
    : QWidget(parent), minimumCuts_(minimumCuts), count_(new CutCounter(minimumCuts, this)) {
  auto* column = addColumn(*this);
  column->setSpacing(scaled(*this, 40));
  column->addStretch(1);
  auto* words = textLabel(text, this);
  words->setProperty("role", QStringLiteral("statement"));
  words->setAlignment(Qt::AlignCenter);
  column->addWidget(words);
  if (picture != nullptr) column->addWidget(picture, 6);
  column->addWidget(count_);
  column->addStretch(2);
  setCuts(0);
}

void BenchmarkPage::setCuts(int cuts) {
  count_->setCount(cuts, tr("Cuts: %1 of at least %2").arg(cuts).arg(minimumCuts_));
}

}  // namespace study::gui
