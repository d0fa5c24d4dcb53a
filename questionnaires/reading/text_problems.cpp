#include <utility>

#include "base/search.h"
#include "base/text_table.h"
#include "questionnaires/reading/instrument_problems.h"

namespace questionnaires {

namespace {

/// Collects the texts of one instrument.
class TextPlaceCollector {
 public:
  explicit TextPlaceCollector(Instrument& instrument) : instrument_(instrument) {}

  std::vector<TextPlace> all() {
    add("title", {&instrument_.title}, false);
    add("introduction", {&instrument_.introduction}, false);
    if (instrument_.scale) addCommonScale();
    for (auto& item : instrument_.items) addItem(item);
    return std::move(places_);
  }

 private:
  void add(std::string name, std::vector<LocalizedText*> texts, bool isWithheld) {
    if (texts.front()->isEmpty() && !isWithheld) return;
    places_.push_back({std::move(name), std::move(texts)});
  }

  bool usesCommonScale(const Item& item) const {
    const bool hasScale = answerKindOf(item.type) == AnswerKind::Point;
    const bool bringsLabels =
        item.withholds(WordingField::LowLabel) || item.withholds(WordingField::HighLabel);
    return hasScale && !bringsLabels && instrument_.scale && item.scale == *instrument_.scale;
  }

  void addCommonScale() {
    std::vector<Scale*> scales{&*instrument_.scale};
    for (auto& item : instrument_.items) {
      if (usesCommonScale(item)) scales.push_back(&item.scale);
    }
    addScale("scale", scales, false, false);
  }

  /// Adds the texts of a scale. @p scales has pointers to the scale and its copies.
  void addScale(
      const std::string& name, const std::vector<Scale*>& scales, bool needsLow, bool needsHigh) {
    const std::size_t labels = scales.front()->pointLabels.size();
    const auto collect = [&](auto textOf) {
      std::vector<LocalizedText*> texts;
      for (Scale* scale : scales) texts.push_back(textOf(*scale));
      return texts;
    };
    for (std::size_t i = 0; i < labels; ++i) {
      auto texts = collect([i](Scale& scale) { return &scale.pointLabels[i]; });
      if (i == 0) addEnds(texts, scales, &Scale::lowLabel);
      if (i + 1 == labels) addEnds(texts, scales, &Scale::highLabel);
      add(name + "/point_labels/" + std::to_string(i + 1), std::move(texts), false);
    }
    if (labels > 0) return;
    add(name + "/low_label", collect([](Scale& s) { return &s.lowLabel; }), needsLow);
    add(name + "/high_label", collect([](Scale& s) { return &s.highLabel; }), needsHigh);
  }

  static void addEnds(
      std::vector<LocalizedText*>& texts,
      const std::vector<Scale*>& scales,
      LocalizedText Scale::*end) {
    for (Scale* scale : scales) texts.push_back(&(scale->*end));
  }

  void addItem(Item& item) {
    const std::string name = "items/" + item.id;
    add(name + "/text", {&item.text}, item.withholds(WordingField::Text));
    add(name + "/left_label", {&item.leftText}, item.withholds(WordingField::LeftLabel));
    add(name + "/right_label", {&item.rightText}, item.withholds(WordingField::RightLabel));
    if (item.type == ItemType::Likert && !usesCommonScale(item)) {
      addScale(
          name,
          {&item.scale},
          item.withholds(WordingField::LowLabel),
          item.withholds(WordingField::HighLabel));
    }
    for (auto& option : item.options) {
      add(name + "/options/" + option.id, {&option.text}, false);
    }
  }

  Instrument& instrument_;
  std::vector<TextPlace> places_;
};

}  // namespace

std::vector<TextPlace> textPlacesOf(Instrument& instrument) {
  return TextPlaceCollector(instrument).all();
}

std::string placeholdersOf(const std::string& text) {
  std::string result;
  std::size_t start = text.find("[[");
  while (start != std::string::npos) {
    const std::size_t end = text.find("]]", start);
    if (end == std::string::npos) break;
    result += (result.empty() ? "" : ", ") + text.substr(start, end + 2 - start);
    start = text.find("[[", end);
  }
  return result;
}

void TextCheck::inspect(const std::string& path, const LocalizedText& text) const {
  requireLanguage(path, text, "en");
  for (const auto& language : languages_) {
    if (language != "en") requireLanguage(path, text, language);
  }
  inspectLanguages(path, text);
}

void TextCheck::inspectResearcherText(const std::string& path, const LocalizedText& text) const {
  requireLanguage(path, text, "en");
  inspectLanguages(path, text);
}

void TextCheck::requireLanguage(
    const std::string& path, const LocalizedText& text, const std::string& language) const {
  if (text.has(language)) return;
  std::string fix = "write something: English is shown where another language has no text";
  if (language != "en") {
    fix = "write {\"en\": \"…\", \"";
    fix.append(language).append("\": \"…\"}, or take '").append(language);
    fix.append("' out of $.languages");
  }
  problems_.add(path + "." + language, "the text in '" + language + "' is missing", std::move(fix));
}

void TextCheck::inspectLanguages(const std::string& path, const LocalizedText& text) const {
  for (const auto& [language, words] : text.all()) {
    std::string place = path;
    place.append(".").append(language);
    if (base::isBlank(words)) problems_.add(place, "this text is blank", "write something");
    if (!base::contains(languages_, language)) {
      problems_.warn(
          place,
          warning("language_not_listed", language),
          warning("language_not_listed.fix", language));
    }
    const std::string placeholders = placeholdersOf(words);
    if (!placeholders.empty()) {
      problems_.warn(place, warning("blank_left", placeholders), warning("blank_left.fix"));
    }
  }
}

}  // namespace questionnaires
