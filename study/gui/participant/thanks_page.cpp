#include "study/gui/participant/thanks_page.h"

#include <QFrame>
#include <QScrollArea>
#include <QVBoxLayout>

#include "study/gui/participant/column.h"
#include "study/gui/widgets/labels.h"
#include "study/gui/widgets/theme.h"

namespace study::gui {

ThanksPage::ThanksPage(
    const QString& title, const QString& debrief, const QStringList& now, QWidget* parent)
    : QWidget(parent) {
  auto* outer = new QVBoxLayout(this);
  outer->setContentsMargins(0, 0, 0, 0);
  auto* scroll = new QScrollArea(this);
  scroll->setWidgetResizable(true);
  auto* inside = new QWidget(scroll);
  auto* column = addColumn(*inside);
  column->setSpacing(scaled(*this, 20));
  column->addStretch(2);
  auto* sign = hugeLabel(QStringLiteral("✓"), inside);
  sign->setProperty("role", QStringLiteral("done"));
  sign->setWordWrap(false);
  column->addWidget(sign, 0, Qt::AlignHCenter);
  auto* heading = titleLabel(title, inside);
  heading->setAlignment(Qt::AlignCenter);
  column->addWidget(heading);

  auto* card = new QFrame(inside);
  card->setProperty("role", QStringLiteral("card"));
  auto* lines = new QVBoxLayout(card);
  const int side = scaled(*this, 20);
  lines->setContentsMargins(side, side, side, side);
  lines->setSpacing(scaled(*this, 10));
  for (const auto& line : now) {
    auto* words = bodyLabel(line, card);
    words->setProperty("role", QStringLiteral("statement"));
    lines->addWidget(words);
  }
  column->addWidget(card);
  if (!debrief.isEmpty()) column->addWidget(textLabel(debrief, inside));
  column->addStretch(3);
  scroll->setWidget(inside);
  scroll->setFocusPolicy(Qt::StrongFocus);  // the keyboard scrolls a long debrief
  scroll->setAccessibleName(title);
  setFocusProxy(scroll);
  outer->addWidget(scroll);
}

}  // namespace study::gui
