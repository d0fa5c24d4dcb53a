#include "study/gui/widgets/cohort_bar.h"

#include <algorithm>

#include <QProgressBar>
#include <QVBoxLayout>

#include "study/gui/widgets/labels.h"

namespace study::gui {

CohortBar::CohortBar(const QString& title, int completed, int planned, QWidget* parent)
    : QWidget(parent) {
  const QString words = planned > 0
                            ? tr("%1: %2 of %3 completed").arg(title).arg(completed).arg(planned)
                            : tr("%1: %2 completed").arg(title).arg(completed);
  setProperty("role", QStringLiteral("plain"));
  auto* lines = withoutMargins<QVBoxLayout>(this);
  lines->addWidget(bodyLabel(words, this));
  if (planned == 0) return;
  auto* bar = new QProgressBar(this);
  bar->setTextVisible(false);
  bar->setRange(0, planned);
  bar->setValue(std::min(completed, planned));
  bar->setAccessibleName(words);
  lines->addWidget(bar);
}

}  // namespace study::gui
