#include "study/gui/participant/item_widget.h"

#include <memory>

#include <QHBoxLayout>
#include <QVBoxLayout>

#include "study/gui/participant/blank_text.h"
#include "study/gui/participant/choice_items.h"
#include "study/gui/participant/entry_items.h"
#include "study/gui/widgets/labels.h"
#include "study/gui/widgets/theme.h"

namespace study::gui {

using questionnaires::ItemType;

ItemWidget::ItemWidget(const questionnaires::Item& item, const QString& language, QWidget* parent)
    : QWidget(parent), item_(item), language_(language) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(scaled(*this, 10));
  if (!item_.text.isEmpty()) showStatement(text(item_.text));
}

void ItemWidget::showStatement(const QString& words) {
  delete statement_;
  statement_ = textLabel(words, this);
  statement_->setProperty("role", "statement");
  static_cast<QVBoxLayout*>(layout())->insertWidget(0, statement_);
}

void ItemWidget::remarkOn(const QString& remark) {
  const auto words = item_.text.isEmpty() ? QString() : text(item_.text) + QLatin1Char(' ');
  showStatement(words + remark);
}

void ItemWidget::putBesideField(QWidget& widget) {
  auto* rows = static_cast<QVBoxLayout*>(layout());
  const std::unique_ptr<QLayoutItem> field(rows->takeAt(rows->count() - 1));
  auto* row = new QHBoxLayout;
  row->addWidget(field->widget(), 1);
  row->addWidget(&widget);
  rows->addLayout(row);
}

QString ItemWidget::text(const questionnaires::LocalizedText& text) const {
  return withBlanksNamed(QString::fromStdString(text.in(language_.toStdString())));
}

ItemWidget* makeItemWidget(
    const questionnaires::Item& item,
    const ItemWidget::Choices& choices,
    const QString& language,
    QWidget* parent) {
  switch (item.type) {
    case ItemType::Likert:
    case ItemType::SemanticDifferential:
      return new PointItem(item, language, parent);
    case ItemType::SingleChoice:
    case ItemType::PairwiseChoice:
      return new ChoiceItem(item, choices, language, parent);
    case ItemType::MultipleChoice:
      return new MultipleChoiceItem(item, language, parent);
    case ItemType::Slider:
      return new SliderItem(item, language, parent);
    case ItemType::Number:
      return new NumberItem(item, language, parent);
    case ItemType::ShortText:
    case ItemType::LongText:
      return new TextItem(item, language, parent);
  }
  return nullptr;
}

}  // namespace study::gui
