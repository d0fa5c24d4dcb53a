#include <cmath>
#include <set>

#include "base/search.h"
#include "questionnaires/json/document.h"
#include "questionnaires/model/instrument.h"
#include "questionnaires/reading/instrument_problems.h"

namespace questionnaires {
namespace {

/// Checks one item and reports its problems.
class ItemInspection {
 public:
  ItemInspection(
      const Instrument& instrument, const Item& item, std::string path, Problems& problems)
      : instrument_(instrument),
        item_(item),
        path_(std::move(path)),
        problems_(problems),
        texts_(instrument.languages, problems) {}

  void inspectHead() const;
  void inspectKeysOfType() const;
  void inspectThreshold() const;

 private:
  void add(const std::string& key, std::string what, std::string fix) const {
    problems_.add(path_ + "." + key, std::move(what), std::move(fix));
  }
  void inspectText(const std::string& key, WordingField field, const LocalizedText& text) const;
  void inspectOwnScale() const;
  void inspectEndsOfLikert(const std::string& place) const;
  void inspectEnds() const;
  void inspectRange() const;
  void inspectOptions() const;
  void inspectOptionNames() const;
  void inspectConsent() const;
  void inspectLength() const;

  const Instrument& instrument_;
  const Item& item_;
  std::string path_;
  Problems& problems_;
  TextCheck texts_;
};

void ItemInspection::inspectHead() const {
  if (!isValidId(item_.id))
    add("id", "'" + shown(item_.id) + "' cannot be an id", "give it a name");
  const bool isPair = item_.type == ItemType::SemanticDifferential;
  if (!isPair || !item_.text.isEmpty()) inspectText("text", WordingField::Text, item_.text);
  if (item_.key != 1 && item_.key != -1) {
    add("key",
        "the key is " + std::to_string(item_.key),
        "write 1 where a high answer is good, -1 where a low one is");
  }
  if (item_.comparedWith == Reference::Previous) {
    problems_.warn(
        path_ + ".relative_to",
        warning("compares_with_previous"),
        warning("compares_with_previous.fix"));
  }
}

/// Checks a text of the item. A withheld text may be missing, because a wording file will supply
/// it.
void ItemInspection::inspectText(
    const std::string& key, WordingField field, const LocalizedText& text) const {
  if (item_.withholds(field) && text.isEmpty()) return;
  texts_.inspect(path_ + "." + key, text);
}

void ItemInspection::inspectThreshold() const {
  const auto range = rangeOf(item_);
  if (!item_.acceptableFrom || !range) return;
  if (*item_.acceptableFrom > range->low && *item_.acceptableFrom <= range->high) return;
  add("acceptable_from",
      "all answers lie on one side of " + shown(*item_.acceptableFrom),
      "write a number above " + shown(range->low) + ", up to " + shown(range->high));
}

void ItemInspection::inspectKeysOfType() const {
  switch (item_.type) {
    case ItemType::Likert:
      return inspectOwnScale();
    case ItemType::SemanticDifferential:
      inspectOwnScale();
      return inspectEnds();
    case ItemType::Slider:
      inspectEnds();
      return inspectRange();
    case ItemType::Number:
      return inspectRange();
    case ItemType::SingleChoice:
      inspectOptions();
      return inspectConsent();
    case ItemType::MultipleChoice:
    case ItemType::PairwiseChoice:
      return inspectOptions();
    case ItemType::ShortText:
    case ItemType::LongText:
      return inspectLength();
  }
}

void ItemInspection::inspectOwnScale() const {
  const Scale& scale = item_.scale;
  const bool isShared = instrument_.scale && *instrument_.scale == scale;
  const std::string place = isShared ? "$.scale" : path_ + ".scale";
  if (!isShared) inspectScale(scale, place, texts_, problems_);
  if (item_.type == ItemType::Likert) inspectEndsOfLikert(isShared ? path_ : place);
}

void ItemInspection::inspectEndsOfLikert(const std::string& place) const {
  const Scale& scale = item_.scale;
  const bool saysLow = !scale.lowLabel.isEmpty() || item_.withholds(WordingField::LowLabel);
  const bool saysHigh = !scale.highLabel.isEmpty() || item_.withholds(WordingField::HighLabel);
  if ((!saysLow || !saysHigh) && scale.pointLabels.empty()) {
    problems_.add(
        place,
        "the scale of a likert item has no words for both ends",
        "add low_label and high_label, or point_labels");
  }
}

void ItemInspection::inspectEnds() const {
  inspectText("left_label", WordingField::LeftLabel, item_.leftText);
  inspectText("right_label", WordingField::RightLabel, item_.rightText);
}

void ItemInspection::inspectRange() const {
  const double range = item_.most - item_.least;
  if (!std::isfinite(range) || !(range > 0.0)) {
    return add(
        "least",
        "least is " + shown(item_.least) + " and most is " + shown(item_.most),
        "least must be smaller than most");
  }
  if (!(item_.step >= 0.0)) {
    return add("step", "the step is negative or no number", "write 0 for any value");
  }
  if (item_.step == 0.0) return;
  // relative to a step, because decimal steps have no exact binary representation
  constexpr double kTolerance = 1e-6;
  const double steps = range / item_.step;
  if (std::round(steps) < 1.0 || std::abs(steps - std::round(steps)) > kTolerance) {
    add("step",
        "steps of " + shown(item_.step) + " do not lead from " + shown(item_.least) + " to " +
            shown(item_.most),
        "choose a step that divides the range, or 0 for any value");
  }
}

void ItemInspection::inspectOptions() const {
  const bool isListed = item_.optionSource == OptionSource::Listed;
  const std::size_t count = item_.options.size();
  if (!isListed && count > 0) {
    add("options", "options beside options_from", "keep one of the two");
  }
  if (!isListed) return;
  if (item_.type == ItemType::PairwiseChoice && count != 2) {
    add("options", "a pairwise choice has " + std::to_string(count) + " options", "list two");
  } else if (count < 2) {
    add("options", "there are fewer than two options", "list what may be chosen");
  }
  inspectOptionNames();
}

void ItemInspection::inspectOptionNames() const {
  std::set<std::string> ids;
  std::set<std::string> words;
  for (std::size_t i = 0; i < item_.options.size(); ++i) {
    const Option& option = item_.options[i];
    const std::string place = "options[" + std::to_string(i) + "]";
    if (!isValidId(option.id)) {
      add(place + ".id", "'" + shown(option.id) + "' cannot be an id", "give it a name");
    }
    if (!ids.insert(option.id).second) {
      add(place + ".id",
          "two options share the id '" + shown(option.id) + "'",
          "give each its own");
    }
    if (option.text.has("en") && !words.insert(option.text.in("en")).second) {
      add(place + ".text", "two options read the same", "tell them apart");
    }
    texts_.inspect(path_ + "." + place + ".text", option.text);
  }
}

void ItemInspection::inspectConsent() const {
  if (item_.consentOption.empty()) return;
  if (base::withId(item_.options, item_.consentOption) == nullptr) {
    add("consent_option",
        "'" + shown(item_.consentOption) + "' is not among the options",
        "name the id of the option that gives consent");
  }
  if (!item_.isRequired) {
    add("required", "consent that may be left open is none", "write true, or leave it out");
  }
}

void ItemInspection::inspectLength() const {
  if (item_.longestAnswer >= 0 && item_.longestAnswer <= kLongestLongText) return;
  add("longest_answer",
      std::to_string(item_.longestAnswer) + " characters cannot be kept",
      "write a number from 1 to " + std::to_string(kLongestLongText));
}

}  // namespace

void inspectScale(
    const Scale& scale, const std::string& path, const TextCheck& texts, Problems& problems) {
  if (scale.points < kFewestPoints || scale.points > kMostPoints) {
    problems.add(
        path + ".points",
        "a scale of " + std::to_string(scale.points) + " points",
        "choose from " + std::to_string(kFewestPoints) + " to " + std::to_string(kMostPoints));
  }
  if (!scale.lowLabel.isEmpty()) texts.inspect(path + ".low_label", scale.lowLabel);
  if (!scale.highLabel.isEmpty()) texts.inspect(path + ".high_label", scale.highLabel);
  const std::size_t labels = scale.pointLabels.size();
  if (labels > 0 && labels != static_cast<std::size_t>(scale.points)) {
    problems.add(
        path + ".point_labels",
        std::to_string(labels) + " labels for " + std::to_string(scale.points) + " points",
        "write one label for each point, or only low_label and high_label");
  }
  for (std::size_t i = 0; i < labels; ++i) {
    texts.inspect(path + ".point_labels[" + std::to_string(i) + "]", scale.pointLabels[i]);
  }
}

void inspectItem(
    const Instrument& instrument, const Item& item, const std::string& path, Problems& problems) {
  const ItemInspection inspection(instrument, item, path, problems);
  inspection.inspectHead();
  inspection.inspectKeysOfType();
  inspection.inspectThreshold();
}

}  // namespace questionnaires
