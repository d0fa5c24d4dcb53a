#include "study/gui/participant/choice_items.h"

#include <algorithm>
#include <utility>

#include <QGridLayout>
#include <QLabel>
#include <QSignalBlocker>

#include "study/gui/widgets/theme.h"

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

/// The words of two ends, of two words each, with a line for each word: both wrap alike.
std::pair<QString, QString> brokenAlike(QString low, QString high) {
  if (low.count(u' ') != 1 || high.count(u' ') != 1) return {low, high};
  return {low.replace(u' ', u'\n'), high.replace(u' ', u'\n')};
}

constexpr int kMostInARow = 11;  // points of a scale

}  // namespace

PointItem::PointItem(const Item& item, const QString& language, QWidget* parent)
    : ItemWidget(item, language, parent, StatementPlace::Beside), buttons_(nullptr) {
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
  rows().addWidget(buttons_);
  addWordsBelow(columns, low, high);
  setFocusProxy(buttons_);
  connect(buttons_, &OptionButtons::chosenChanged, this, &ItemWidget::changed);
}

/// The words of each point, or else those of both ends.
void PointItem::addWordsBelow(int columns, const QString& low, const QString& high) {
  const auto& labels = item().scale.pointLabels;
  auto* words = new QGridLayout;
  words->setContentsMargins(0, 0, 0, 0);
  words->setHorizontalSpacing(scaled(*this, 8));
  for (int i = 0; i < columns; ++i) words->setColumnStretch(i, 1);
  const bool isEachLabelled = labels.size() == static_cast<std::size_t>(columns);
  for (int i = 0; isEachLabelled && i < columns; ++i) {
    auto* word = anchor(text(labels[static_cast<std::size_t>(i)]), Qt::AlignHCenter, this);
    word->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    words->addWidget(word, 0, i);
  }
  if (!isEachLabelled) {
    constexpr int kFewPoints = 5;  // each is wide enough for the words of an end
    const bool isWide = columns <= kFewPoints;
    const int across = isWide ? 1 : columns / 2;
    const auto ends = isWide ? brokenAlike(low, high) : std::pair(low, high);
    auto* left = anchor(ends.first, isWide ? Qt::AlignHCenter : Qt::AlignLeft, this);
    auto* right = anchor(ends.second, isWide ? Qt::AlignHCenter : Qt::AlignRight, this);
    for (auto* word : {left, right})
      word->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    words->addWidget(left, 0, 0, 1, across);
    words->addWidget(right, 0, columns - across, 1, across);
  }
  rows().addLayout(words);
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
    for (const auto& alternative : choices.alternatives) {
      ids_.push_back(alternative.id);
      const auto with = [&](const char* between) {
        return alternative.note.isEmpty()
                   ? alternative.name
                   : alternative.name + QString::fromLatin1(between) + alternative.note;
      };
      options.push_back({with("\n"), with(", ")});
    }
  } else {
    for (const auto& option : item.options) {
      ids_.push_back(option.id);
      options.push_back({text(option.text), text(option.text)});
    }
  }
  buttons_ =
      new OptionButtons(options, OptionButtons::kAsManyAsFit, QStringLiteral("option"), this);
  if (item.optionSource == questionnaires::OptionSource::Alternatives) buttons_->makeLarge();
  rows().addWidget(buttons_);
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
    rows().addWidget(box);
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
