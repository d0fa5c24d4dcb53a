#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "base/search.h"
#include "questionnaires/model/instrument.h"
#include "questionnaires/reading/instrument_reader.h"

namespace questionnaires {

namespace {

constexpr int kFarthestPoint = 1000;  // largest magnitude of a point

void readLabels(const Node& node, const TextReader& texts, Scale& scale) {
  scale.lowLabel = texts.optional(node, "low_label");
  scale.highLabel = texts.optional(node, "high_label");
  if (!node.has("point_labels")) return;
  for (const auto& label : node.requiredList("point_labels")) {
    scale.pointLabels.push_back(texts.read(label));
  }
  const bool isUnread = scale.pointLabels.empty();
  if (scale.lowLabel.isEmpty()) {
    scale.lowLabel = isUnread ? texts.fallbackText() : scale.pointLabels.front();
  }
  if (scale.highLabel.isEmpty()) {
    scale.highLabel = isUnread ? texts.fallbackText() : scale.pointLabels.back();
  }
}

}  // namespace

Scale readScale(const Node& node, const TextReader& texts) {
  Scale scale = defaultScale(texts);
  if (!node.isObjectWithOnlyKeys({"lowest", "points", "low_label", "high_label", "point_labels"})) {
    return scale;
  }
  scale.lowest = static_cast<int>(node.wholeNumber("lowest", -kFarthestPoint, kFarthestPoint, 1));
  readLabels(node, texts, scale);
  const bool hasPoints = node.require("points");
  const auto points = hasPoints ? node.wholeNumber("points", kFewestPoints, kMostPoints, 0) : 0;
  if (points > 0) {
    scale.points = static_cast<int>(points);
  } else if (scale.pointLabels.size() >= static_cast<std::size_t>(kFewestPoints)) {
    scale.points = static_cast<int>(scale.pointLabels.size());
  }
  return scale;
}

Scale defaultScale(const TextReader& texts) {
  Scale scale;
  scale.lowLabel = texts.fallbackText();
  scale.highLabel = texts.fallbackText();
  return scale;
}

namespace {

constexpr std::array kReferences{Choice<Reference>{"previous", Reference::Previous}};
constexpr std::array kSources{Choice<OptionSource>{"alternatives", OptionSource::Alternatives}};
constexpr std::array kPointWords{
    Choice<WordingField>{"text", WordingField::Text},
    Choice<WordingField>{"low_label", WordingField::LowLabel},
    Choice<WordingField>{"high_label", WordingField::HighLabel},
};
constexpr std::array kEndWords{
    Choice<WordingField>{"text", WordingField::Text},
    Choice<WordingField>{"left_label", WordingField::LeftLabel},
    Choice<WordingField>{"right_label", WordingField::RightLabel},
};

/// The keys of this type of item, except those that all items may have.
std::vector<std::string_view> keysOf(ItemType type) {
  switch (type) {
    case ItemType::Likert:
      return {"key", "relative_to", "scale", "acceptable_from", "wording"};
    case ItemType::SemanticDifferential:
      return {
          "key", "relative_to", "scale", "left_label", "right_label", "acceptable_from", "wording"};
    case ItemType::Slider:
      return {
          "key",
          "relative_to",
          "left_label",
          "right_label",
          "least",
          "most",
          "step",
          "acceptable_from",
          "wording"};
    case ItemType::SingleChoice:
      return {"relative_to", "options", "options_from", "consent_option"};
    case ItemType::MultipleChoice:
      return {"options", "options_from"};
    case ItemType::Number:
      return {"least", "most", "step", "unit", "acceptable_from"};
    case ItemType::ShortText:
    case ItemType::LongText:
      return {"longest_answer"};
    case ItemType::PairwiseChoice:
      return {"relative_to", "options", "options_from"};
  }
  return {};
}

void refuseKeysOfOtherTypes(const Node& node, const ItemTypeFacts& type) {
  const auto own = keysOf(type.value);
  for (const auto& member : node.members()) {
    const std::string& key = member.first;
    const bool isOfAType = std::ranges::any_of(
        kItemTypes, [&](const auto& t) { return base::contains(keysOf(t.value), key); });
    if (!isOfAType || base::contains(own, key)) continue;
    node.problem(
        key,
        "'" + key + "' means nothing to an item of type '" + std::string(type.name) + "'",
        "remove it, or choose another type");
  }
}

bool hasOnlyKnownKeys(const Node& node) {
  return node.isObjectWithOnlyKeys(
      {"id",
       "type",
       "text",
       "set",
       "required",
       "identifying",
       "page",
       "show_if",
       "key",
       "relative_to",
       "refers_to",
       "scale",
       "left_label",
       "right_label",
       "least",
       "most",
       "step",
       "unit",
       "options",
       "options_from",
       "consent_option",
       "longest_answer",
       "acceptable_from",
       "wording"});
}

constexpr double kLargestBound = 1e9;

double readBound(const Node& node, std::string_view key, std::optional<double> fallback) {
  if (node.has(key)) return node.number(key, -kLargestBound, kLargestBound, kUnreadNumber);
  if (!fallback) node.require(key);
  return fallback.value_or(kUnreadNumber);
}

void readRange(const Node& node, Item& item) {
  const bool isSlider = item.type == ItemType::Slider;
  item.least = readBound(node, "least", isSlider ? std::optional(0.0) : std::nullopt);
  item.most = readBound(node, "most", isSlider ? std::optional(100.0) : std::nullopt);
  item.step = node.has("step") ? node.number("step", 0.0, kLargestBound, kUnreadNumber) : 1.0;
  if (std::isnan(item.least + item.most + item.step)) {
    item.least = 0.0;
    item.most = 1.0;
    item.step = 0.0;
  }
  if (node.has("unit")) item.unit = node.text("unit");
}

ShowIf readShowIf(const Node& node) {
  ShowIf showIf;
  if (!node.isObjectWithOnlyKeys({"item", "is"})) return showIf;
  showIf.item = node.id("item");
  for (const auto& option : node.requiredList("is"))
    showIf.wantedOptions.push_back(option.asText());
  return showIf;
}

/// Reads the list of withheld texts, which have different keys in each type of item.
void readWithheld(const Node& node, Item& item) {
  const bool isLikert = item.type == ItemType::Likert;
  for (const auto& name : node.requiredList("wording")) {
    const auto field = isLikert ? name.chosen(kPointWords) : name.chosen(kEndWords);
    if (!field) continue;
    if (item.withholds(field->value)) name.problem("", "this text stands here twice", "keep one");
    item.withheld.push_back(field->value);
  }
}

void readLength(const Node& node, Item& item) {
  const auto fallback = item.type == ItemType::ShortText ? kLongestShortText : kLongestLongText;
  item.longestAnswer = node.wholeNumber("longest_answer", 1, kLongestLongText, fallback);
}

}  // namespace

Item ItemReader::read(const Node& node, std::size_t index) const {
  Item item;
  item.id = "unread." + std::to_string(index);
  item.text = texts_.fallbackText();
  item.scale = defaultScale(texts_);
  if (!hasOnlyKnownKeys(node)) return item;

  item.id = idOrGenerated(node, "id", index);
  const auto type = node.chosen("type", kItemTypes);
  if (type) {
    item.type = type->value;
    refuseKeysOfOtherTypes(node, *type);
    if (node.has("wording") && base::contains(keysOf(item.type), "wording"))
      readWithheld(node, item);
  }
  readCommonKeys(node, item);
  if (type) readKeysOfType(node, item);
  return item;
}

void ItemReader::readCommonKeys(const Node& node, Item& item) const {
  const bool mayBeWordless = item.type == ItemType::SemanticDifferential;
  item.text = mayBeWordless && !item.withholds(WordingField::Text)
                  ? texts_.optional(node, "text")
                  : readText(node, "text", item.withholds(WordingField::Text));
  if (node.has("set")) item.set = node.id("set");
  item.key = static_cast<int>(node.wholeNumber("key", -1, 1, 1));
  item.isRequired = node.flag("required", true);
  item.isIdentifying = node.flag("identifying", false);
  item.startsPage = node.flag("page", false);
  if (const auto showIf = node.member("show_if")) item.showIf = readShowIf(*showIf);
  item.comparedWith = node.choice("relative_to", kReferences, Reference::None);
  item.neededFeature = node.choice("refers_to", kStudyFeatures, StudyFeature::None);
  if (node.has("acceptable_from")) {
    const double from =
        node.number("acceptable_from", -kLargestBound, kLargestBound, kUnreadNumber);
    if (!std::isnan(from)) item.acceptableFrom = from;
  }
}

LocalizedText ItemReader::readText(const Node& node, std::string_view key, bool isWithheld) const {
  if (!isWithheld) return texts_.required(node, key);
  if (node.has(key)) {
    node.problem(
        key,
        "'" + std::string(key) + "' stands here, and 'wording' says that it is in a wording file",
        "keep one of the two");
  }
  return {};
}

void ItemReader::readKeysOfType(const Node& node, Item& item) const {
  switch (item.type) {
    case ItemType::Likert:
      return readScaleOf(node, item);
    case ItemType::SemanticDifferential:
      readScaleOf(node, item);
      return readEndLabels(node, item);
    case ItemType::Slider:
      readEndLabels(node, item);
      return readRange(node, item);
    case ItemType::Number:
      return readRange(node, item);
    case ItemType::ShortText:
    case ItemType::LongText:
      return readLength(node, item);
    case ItemType::SingleChoice:
    case ItemType::MultipleChoice:
    case ItemType::PairwiseChoice:
      return readOptions(node, item);
  }
}

void ItemReader::readScaleOf(const Node& node, Item& item) const {
  if (const auto own = node.member("scale")) {
    item.scale = readScale(*own, texts_);
  } else if (scale_) {
    item.scale = *scale_;
  } else {
    node.problem(
        "", "'scale' is missing, here and at the top of the file", "add it at one of the two");
  }
  const bool hasBoth = (item.withholds(WordingField::LowLabel) && !item.scale.lowLabel.isEmpty()) ||
                       (item.withholds(WordingField::HighLabel) && !item.scale.highLabel.isEmpty());
  const bool isRead = node.has("scale") || scale_;
  if (hasBoth && isRead) {
    node.problem(
        "wording",
        "the scale has a word for this end, and 'wording' says that it is in a wording file",
        "keep one of the two");
  }
}

void ItemReader::readEndLabels(const Node& node, Item& item) const {
  item.leftText = readText(node, "left_label", item.withholds(WordingField::LeftLabel));
  item.rightText = readText(node, "right_label", item.withholds(WordingField::RightLabel));
}

void ItemReader::readOptions(const Node& node, Item& item) const {
  if (!node.has("options") && !node.has("options_from")) {
    node.problem(
        "options",
        "there is nothing to choose from",
        "list options, or write \"options_from\": \"alternatives\"");
  }
  if (node.has("options") && node.has("options_from")) {
    node.problem("options", "options beside options_from", "keep one of the two");
  }
  item.optionSource = node.choice("options_from", kSources, OptionSource::Listed);
  for (const auto& option : node.list("options", kMostOptions)) {
    item.options.push_back(readOption(option, item.options.size()));
  }
  if (node.has("consent_option")) item.consentOption = node.id("consent_option");
}

Option ItemReader::readOption(const Node& node, std::size_t index) const {
  if (!node.isObjectWithOnlyKeys({"id", "text"})) {
    return {.id = "unread." + std::to_string(index), .text = texts_.fallbackText()};
  }
  return {.id = idOrGenerated(node, "id", index), .text = texts_.required(node, "text")};
}

std::string idOrGenerated(const Node& node, std::string_view key, std::size_t index) {
  std::string id = node.id(key);
  return id.empty() ? "unread." + std::to_string(index) : id;
}

}  // namespace questionnaires
