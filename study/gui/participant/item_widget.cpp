#include "study/gui/participant/item_widget.h"

#include <algorithm>
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

ItemWidget::ItemWidget(
    const questionnaires::Item& item,
    const QString& language,
    QWidget* parent,
    StatementPlace place)
    : QWidget(parent),
      item_(item),
      language_(language),
      statementPlace_(place),
      parts_(new QBoxLayout(QBoxLayout::TopToBottom, this)),
      field_(new QWidget(this)),
      rows_(new QVBoxLayout(field_)) {
  for (QWidget* each : {static_cast<QWidget*>(this), field_}) {
    each->setProperty("role", QStringLiteral("plain"));
  }
  parts_->setContentsMargins(0, 0, 0, 0);
  parts_->setSpacing(scaled(*this, 10));
  rows_->setContentsMargins(0, 0, 0, 0);
  rows_->setSpacing(scaled(*this, 4));
  parts_->addWidget(field_);
  if (!item_.text.isEmpty()) showStatement(text(item_.text));
}

void ItemWidget::showStatement(const QString& words) {
  delete statement_;
  statement_ = textLabel(words, this);
  statement_->setProperty("role", "statement");
  parts_->insertWidget(0, statement_);
}

/// The minimum size with the statement above the field. A statement beside the field would prevent
/// the window from being made narrower.
QSize ItemWidget::minimumSizeHint() const {
  const int statement = statement_ == nullptr ? 0 : statement_->minimumSizeHint().width();
  return {
      std::max(statement, field_->minimumSizeHint().width()), QWidget::minimumSizeHint().height()};
}

void ItemWidget::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  if (statementPlace_ == StatementPlace::Above || statement_ == nullptr) return;
  constexpr int kRoomForBoth = 900;  // [px] at scale 1
  const bool isBeside = width() >= scaled(*this, kRoomForBoth);
  parts_->setDirection(isBeside ? QBoxLayout::LeftToRight : QBoxLayout::TopToBottom);
  parts_->setSpacing(scaled(*this, isBeside ? 28 : 10));
  // The first line of the statement is at the height of the buttons, which have words below them.
  const int buttons = rows_->count() == 0 ? 0 : rows_->itemAt(0)->sizeHint().height();
  const int above = std::max(0, (buttons - statement_->fontMetrics().height()) / 2);
  statement_->setAlignment(isBeside ? Qt::AlignTop : Qt::AlignVCenter);
  statement_->setContentsMargins(0, isBeside ? above : 0, 0, 0);
  constexpr int kStatementShare = 9;  // shares of the width
  constexpr int kFieldShare = 10;
  parts_->setStretchFactor(statement_, isBeside ? kStatementShare : 0);
  parts_->setStretchFactor(field_, isBeside ? kFieldShare : 0);
}

void ItemWidget::addRemark(const QString& remark) {
  const auto words = item_.text.isEmpty() ? QString() : text(item_.text) + QLatin1Char(' ');
  showStatement(words + remark);
}

void ItemWidget::putBesideField(QWidget& widget) {
  const std::unique_ptr<QLayoutItem> field(rows_->takeAt(rows_->count() - 1));
  auto* row = new QHBoxLayout;
  row->setSpacing(scaled(*this, 16));
  row->addWidget(field->widget(), 1);
  row->addWidget(&widget);
  rows_->addLayout(row);
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
