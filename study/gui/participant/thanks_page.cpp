#include "study/gui/participant/thanks_page.h"

#include <QFrame>
#include <QScrollArea>
#include <QVBoxLayout>

#include "study/gui/participant/column.h"
#include "study/gui/widgets/labels.h"
#include "study/gui/widgets/theme.h"

namespace study::gui {

ThanksPage::ThanksPage(const Content& content, QWidget* parent) : QWidget(parent) {
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
  auto* heading = titleLabel(content.title, inside);
  heading->setAlignment(Qt::AlignCenter);
  column->addWidget(heading);

  auto* card = new QFrame(inside);
  card->setProperty("role", QStringLiteral("card"));
  auto* lines = new QVBoxLayout(card);
  const int side = scaled(*this, 20);
  lines->setContentsMargins(side, side, side, side);
  lines->setSpacing(scaled(*this, 10));
  const auto add = [&](QLabel* words, const char* role) {
    words->setProperty("role", QString::fromUtf8(role));
    lines->addWidget(words);
  };
  add(bodyLabel(content.now, card), "statement");
  if (!content.debrief.isEmpty()) add(textLabel(content.debrief, card), "text");
  add(textLabel(content.saved, card), "statement");
  if (!content.contact.isEmpty()) add(bodyLabel(content.contact, card), "statement");
  column->addWidget(card);
  column->addStretch(3);
  scroll->setWidget(inside);
  scroll->setFocusPolicy(Qt::StrongFocus);  // the keyboard scrolls a long debrief
  scroll->setAccessibleName(content.title);
  setFocusProxy(scroll);
  outer->addWidget(scroll);
}

}  // namespace study::gui
