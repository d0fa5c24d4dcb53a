#include "study/gui/participant/choice_items.h"

#include <algorithm>

#include <QHBoxLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QVBoxLayout>

namespace study::gui {
namespace {

using questionnaires::Item;
using questionnaires::ItemType;
using questionnaires::Response;

QLabel* anchor(const QString& text, Qt::Alignment alignment, QWidget* parent) {
  auto* label = new QLabel(text, parent);
  label->setProperty("role", "anchor");
  label->setTextFormat(Qt::PlainText);
  label->setWordWrap(true);
  label->setAlignment(alignment | Qt::AlignTop);
  return label;
}

constexpr int kMostInARow = 11;  // points of a scale

}  // namespace

PointItem::PointItem(const Item& item, const QString& language, QWidget* parent)
    : ItemWidget(item, language, parent), buttons_(nullptr) {
  const bool isBetweenWords = item.type == ItemType::SemanticDifferential;
  const QString low = text(isBetweenWords ? item.leftText : item.scale.lowLabel);
  const QString high = text(isBetweenWords ? item.rightText : item.scale.highLabel);
  std::vector<OptionButtons::Option> options;
  for (int i = 0; i < item.scale.points; ++i) {
    const auto& labels = item.scale.pointLabels;
    const QString number = QString::number(item.scale.lowest + i);
    const QString label = labels.empty()
                              ? QString()
                              : text(labels[static_cast<std::size_t>(i)]) + QStringLiteral(", ");
    options.push_back(
        {isBetweenWords ? QString() : number,
         tr("%1: %2%3 of %4, from %5 to %6")
             .arg(
                 text(item.text),
                 label,
                 number,
                 QString::number(item.scale.highest()),
                 low,
                 high)});
  }
  const int columns = std::min(item.scale.points, kMostInARow);
  buttons_ = new OptionButtons(options, columns, QStringLiteral("point"), this);
  auto* rows = static_cast<QVBoxLayout*>(layout());
  rows->addWidget(buttons_);
  auto* words = new QHBoxLayout;
  words->addWidget(anchor(low, Qt::AlignLeft, this), 1);
  words->addWidget(anchor(high, Qt::AlignRight, this), 1);
  rows->addLayout(words);
  setFocusProxy(buttons_);
  connect(buttons_, &OptionButtons::chosenChanged, this, &ItemWidget::changed);
}

std::optional<Response> PointItem::response() const {
  if (buttons_->chosen() < 0) return std::nullopt;
  return std::int64_t{item().scale.lowest} + buttons_->chosen();
}

void PointItem::show(const Response& response) {
  const auto* point = std::get_if<std::int64_t>(&response);
  const QSignalBlocker quiet(this);
  if (point != nullptr) buttons_->choose(static_cast<int>(*point) - item().scale.lowest);
}

ChoiceItem::ChoiceItem(
    const Item& item, const Choices& choices, const QString& language, QWidget* parent)
    : ItemWidget(item, language, parent), buttons_(nullptr) {
  std::vector<OptionButtons::Option> options;
  if (item.optionSource == questionnaires::OptionSource::Alternatives) {
    for (const auto& [id, name] : choices.alternatives) {
      ids_.push_back(id);
      options.push_back({name, name});
    }
  } else {
    for (const auto& option : item.options) {
      ids_.push_back(option.id);
      options.push_back({text(option.text), text(option.text)});
    }
  }
  buttons_ = new OptionButtons(options, columnsFor(options), QStringLiteral("option"), this);
  layout()->addWidget(buttons_);
  setFocusProxy(buttons_);
  connect(buttons_, &OptionButtons::chosenChanged, this, &ItemWidget::changed);
}

std::optional<Response> ChoiceItem::response() const {
  if (buttons_->chosen() < 0) return std::nullopt;
  return ids_[static_cast<std::size_t>(buttons_->chosen())];
}

void ChoiceItem::show(const Response& response) {
  const auto* id = std::get_if<std::string>(&response);
  if (id == nullptr) return;
  const QSignalBlocker quiet(this);
  const auto found = std::find(ids_.begin(), ids_.end(), *id);
  if (found != ids_.end()) buttons_->choose(static_cast<int>(found - ids_.begin()));
}

MultipleChoiceItem::MultipleChoiceItem(const Item& item, const QString& language, QWidget* parent)
    : ItemWidget(item, language, parent) {
  for (const auto& option : item.options) {
    auto* box = new QCheckBox(text(option.text), this);
    box->setProperty("role", QStringLiteral("option"));
    boxes_.push_back(box);
    layout()->addWidget(box);
    connect(box, &QCheckBox::toggled, this, &ItemWidget::changed);
  }
  if (!boxes_.empty()) setFocusProxy(boxes_.front());
}

std::optional<Response> MultipleChoiceItem::response() const {
  std::vector<std::string> ids;
  for (std::size_t i = 0; i < boxes_.size(); ++i) {
    if (boxes_[i]->isChecked()) ids.push_back(item().options[i].id);
  }
  if (ids.empty()) return std::nullopt;
  return ids;
}

void MultipleChoiceItem::show(const Response& response) {
  const auto* ids = std::get_if<std::vector<std::string>>(&response);
  if (ids == nullptr) return;
  const QSignalBlocker quiet(this);
  for (std::size_t i = 0; i < boxes_.size(); ++i) {
    boxes_[i]->setChecked(std::find(ids->begin(), ids->end(), item().options[i].id) != ids->end());
  }
}

}  // namespace study::gui
