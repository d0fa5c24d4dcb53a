#include "study/gui/widgets/field_row.h"

#include <algorithm>

#include <QEvent>
#include <QLabel>

#include "study/gui/widgets/field_form.h"

namespace study::gui {

FieldRow::FieldRow(QWidget* parent)
    : QWidget(parent), fields_(new QBoxLayout(QBoxLayout::LeftToRight, this)) {
  fields_->setContentsMargins(0, 0, 0, 0);
  fields_->setSpacing(16);
}

void FieldRow::add(const QString& words, QWidget* field) {
  auto* name = new QLabel(words, this);
  name->setBuddy(field);
  nameAsLabelled(field, words);
  auto* pair = new QVBoxLayout;
  pair->setSpacing(4);
  pair->addWidget(name);
  pair->addWidget(field);
  fields_->addLayout(pair, 1);
}

/// The widest field, because the others may stand below it.
QSize FieldRow::minimumSizeHint() const {
  int width = 0;
  for (int i = 0; i < fields_->count(); ++i) {
    width = std::max(width, fields_->itemAt(i)->minimumSize().width());
  }
  return {width, fields_->totalMinimumSize().height()};
}

void FieldRow::fit() {
  int needed = fields_->spacing() * (fields_->count() - 1);
  for (int i = 0; i < fields_->count(); ++i) needed += fields_->itemAt(i)->minimumSize().width();
  fields_->setDirection(width() >= needed ? QBoxLayout::LeftToRight : QBoxLayout::TopToBottom);
}

bool FieldRow::event(QEvent* event) {
  const auto type = event->type();
  if (type == QEvent::Resize || type == QEvent::LayoutRequest) fit();
  return QWidget::event(event);
}

}  // namespace study::gui
