#include "study/gui/participant/thanks_page.h"

#include <QFrame>
#include <QVBoxLayout>

#include "study/gui/participant/column.h"
#include "study/gui/participant/page_scroll.h"
#include "study/gui/participant/side_by_side.h"
#include "study/gui/widgets/labels.h"
#include "study/gui/widgets/theme.h"

namespace study::gui {
namespace {

QFrame* cardWith(const QList<QLabel*>& labels, QWidget* parent) {
  auto* card = new QFrame(parent);
  card->setProperty("role", QStringLiteral("card"));
  auto* lines = new QVBoxLayout(card);
  const int side = scaled(*parent, 24);
  lines->setContentsMargins(side, side, side, side);
  lines->setSpacing(scaled(*parent, 10));
  for (auto* label : labels) lines->addWidget(label);
  return card;
}

QLabel* withRole(QLabel* label, const char* role) {
  label->setProperty("role", QString::fromLatin1(role));
  return label;
}

}  // namespace

ThanksPage::ThanksPage(const Content& content, QWidget* parent) : QWidget(parent) {
  auto* outer = withoutMargins<QVBoxLayout>(this);
  auto* scroll = new PageScroll(this);
  auto* inside = new QWidget(scroll);
  auto* column = addColumn(*inside, ColumnWidth::Page, ColumnIn::Scroll);
  column->addWidget(titleLabel(content.title, inside));
  auto* next = new QHBoxLayout;
  next->setSpacing(scaled(*this, 16));
  if (content.isCompleted) {
    auto* sign = withRole(hugeLabel(QStringLiteral("✓"), inside), "done");
    sign->setWordWrap(false);
    next->addWidget(sign);
  }
  next->addWidget(withRole(bodyLabel(content.now, inside), "key"), 1);
  column->addLayout(next);
  column->addWidget(new SideBySide(makeCode(content), makeDebrief(content), this));
  column->addStretch(1);
  scroll->setWidget(inside);
  scroll->setAccessibleName(content.title);
  setFocusProxy(scroll);
  outer->addWidget(scroll);
}

/// The code: the only thing to take away.
QWidget* ThanksPage::makeCode(const Content& content) {
  auto* saved = textLabel(
      tr("Your answers and what was measured are saved under this code, not under your name. "
         "Note it if you may want them deleted."),
      this);
  return cardWith(
      {withRole(bodyLabel(tr("Your code"), this), "text"),
       withRole(bodyLabel(content.code, this), "code"),
       saved},
      this);
}

QWidget* ThanksPage::makeDebrief(const Content& content) {
  QList<QLabel*> labels;
  if (!content.debrief.isEmpty()) labels << textLabel(content.debrief, this);
  if (!content.contact.isEmpty()) labels << withRole(bodyLabel(content.contact, this), "text");
  return cardWith(labels, this);
}

}  // namespace study::gui
