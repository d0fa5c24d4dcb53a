#include "study/gui/participant/benchmark_page.h"

#include <QVBoxLayout>

#include "study/gui/widgets/labels.h"

namespace study::gui {

BenchmarkPage::BenchmarkPage(const QString& text, int minimumCuts, QWidget* parent)
    : QWidget(parent), minimumCuts_(minimumCuts), count_(nullptr) {
  auto* layout = new QVBoxLayout(this);
  layout->setSpacing(22);
  layout->addStretch(1);
  auto* words = titleLabel(text, this);
  words->setAlignment(Qt::AlignCenter);
  layout->addWidget(words);
  count_ = quietLabel({}, this);
  count_->setAlignment(Qt::AlignCenter);
  layout->addWidget(count_);
  auto* button = new QPushButton(tr("I have made a cut"), this);
  button->setProperty("role", QStringLiteral("next"));
  layout->addWidget(button, 0, Qt::AlignCenter);
  layout->addStretch(2);
  setFocusProxy(button);
  connect(button, &QPushButton::clicked, this, &BenchmarkPage::cutMade);
}

void BenchmarkPage::setCuts(int cuts) {
  count_->setText(tr("Cuts: %1 of at least %2").arg(cuts).arg(minimumCuts_));
}

}  // namespace study::gui
