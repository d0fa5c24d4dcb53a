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
  auto* outer = new QVBoxLayout(this);
  outer->setContentsMargins(0, 0, 0, 0);
  auto* scroll = new PageScroll(this);
  auto* inside = new QWidget(scroll);
  const bool hasMore = !content.debrief.isEmpty() || !content.contact.isEmpty();
  auto* column =
      addColumn(*inside, hasMore ? ColumnWidth::Page : ColumnWidth::Text, ColumnIn::Scroll);
  column->addStretch(1);
  auto* thanks = makeThanks(content);
  column->addWidget(hasMore ? new SideBySide(thanks, makeDebrief(content), this) : thanks);
  column->addStretch(2);
  scroll->setWidget(inside);
  scroll->setAccessibleName(content.title);
  setFocusProxy(scroll);
  outer->addWidget(scroll);
}

/// Thanks, what to do now, and the code: the only thing to take away.
QWidget* ThanksPage::makeThanks(const Content& content) {
  auto* part = new QWidget(this);
  auto* lines = new QVBoxLayout(part);
  lines->setContentsMargins(0, 0, 0, 0);
  lines->setSpacing(scaled(*this, 16));
  auto* sign = withRole(hugeLabel(QStringLiteral("✓"), part), "done");
  sign->setWordWrap(false);
  lines->addWidget(sign, 0, Qt::AlignLeft);
  lines->addWidget(titleLabel(content.title, part));
  lines->addWidget(withRole(bodyLabel(content.now, part), "key"));
  auto* saved = textLabel(
      tr("Your answers and what was measured are saved under this code, not under your name. "
         "Note it if you may want them deleted."),
      part);
  lines->addWidget(cardWith(
      {withRole(bodyLabel(tr("Your code"), part), "text"),
       withRole(bodyLabel(content.code, part), "code"),
       saved},
      part));
  return part;
}

QWidget* ThanksPage::makeDebrief(const Content& content) {
  QList<QLabel*> labels;
  if (!content.debrief.isEmpty()) labels << textLabel(content.debrief, this);
  if (!content.contact.isEmpty()) labels << withRole(bodyLabel(content.contact, this), "text");
  return cardWith(labels, this);
}

}  // namespace study::gui
