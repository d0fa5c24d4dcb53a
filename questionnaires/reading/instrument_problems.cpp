#include "questionnaires/reading/instrument_problems.h"

#include <algorithm>
#include <set>
#include <vector>

#include "base/search.h"
#include "questionnaires/json/document.h"
#include "questionnaires/model/instrument.h"

namespace questionnaires {
namespace {

void inspectHead(const Instrument& instrument, const TextCheck& texts, Problems& problems) {
  if (!isValidId(instrument.id)) {
    problems.add("$.id", "'" + shown(instrument.id) + "' cannot be an id", "give it a name");
  }
  if (!base::contains(instrument.languages, "en")) {
    problems.add(
        "$.languages",
        "'en' is not among the languages",
        "add it: English is what is shown where another language has no text");
  }
  texts.inspect("$.title", instrument.title);
  const bool hasIntroduction = !instrument.introduction.isEmpty();
  if (hasIntroduction) texts.inspect("$.introduction", instrument.introduction);
  if (instrument.items.empty() && !hasIntroduction) {
    problems.add(
        "$.items", "nothing is asked and nothing is said", "add items, or an introduction");
  }
  if (instrument.hasWithheldTexts() && instrument.source.wordingFrom.empty()) {
    problems.add(
        "$.source.wording_from",
        "nobody learns where the words are that do not ship",
        "write where they are to be had: citation, DOI, address");
  }
  if (instrument.scale) inspectScale(*instrument.scale, "$.scale", texts, problems);
}

/// Checks the condition of an item: it must name an earlier choice item of the item's set, and
/// options that this choice has.
void inspectCondition(
    const Instrument& instrument, std::size_t index, const std::string& path, Problems& problems) {
  const Item& item = instrument.items[index];
  if (!item.showIf.isSet()) return;
  const auto end = instrument.items.begin() + static_cast<std::ptrdiff_t>(index);
  const auto other = std::find_if(
      instrument.items.begin(), end, [&](const Item& i) { return i.id == item.showIf.item; });
  const std::string place = path + ".show_if";
  if (other == end || other->set != item.set) {
    return problems.add(
        place + ".item",
        "'" + shown(item.showIf.item) + "' is no earlier item of the same set",
        "name an item above this one");
  }
  if (item.isIdentifying || !item.consentOption.empty()) {
    problems.add(place, "consent and names are always asked for", "remove 'show_if'");
  }
  for (std::size_t i = 0; i < item.showIf.wantedOptions.size(); ++i) {
    if (base::withId(other->options, item.showIf.wantedOptions[i]) != nullptr) continue;
    problems.add(
        place + ".is[" + std::to_string(i) + "]",
        "'" + shown(item.showIf.wantedOptions[i]) + "' is no option of '" + other->id + "'",
        "write the id of one of its options");
  }
}

/// Warns if an item before it, of the same set, reads the same.
void warnOfSameText(
    const Instrument& instrument, std::size_t index, const std::string& path, Problems& problems) {
  const Item& item = instrument.items[index];
  const auto end = instrument.items.begin() + static_cast<std::ptrdiff_t>(index);
  const auto twin = std::find_if(instrument.items.begin(), end, [&](const Item& other) {
    return other.set == item.set && other.text.has("en") && other.text == item.text;
  });
  // items between two words, and choices of one of two, are told apart by these
  const bool isOfWords =
      item.type == ItemType::SemanticDifferential || item.type == ItemType::PairwiseChoice;
  if (twin == end || isOfWords) return;
  problems.warn(path + ".text", warning("same_text", twin->id), warning("same_text.fix"));
}

void warnOfSameEnds(const Item& item, const std::string& path, Problems& problems) {
  const bool isOfWords =
      item.type == ItemType::SemanticDifferential || item.type == ItemType::Slider;
  const bool isOfLabels = item.type == ItemType::Likert && item.scale.pointLabels.empty();
  const auto& low = isOfWords ? item.leftText : item.scale.lowLabel;
  const auto& high = isOfWords ? item.rightText : item.scale.highLabel;
  if ((!isOfWords && !isOfLabels) || !low.has("en") || low != high) return;
  problems.warn(path, warning("same_ends"), warning("same_ends.fix"));
}

void inspectItems(const Instrument& instrument, Problems& problems) {
  std::set<std::string> ids;
  for (std::size_t i = 0; i < instrument.items.size(); ++i) {
    const Item& item = instrument.items[i];
    const std::string path = "$.items[" + std::to_string(i) + "]";
    if (!ids.insert(item.id).second) {
      problems.add(
          path + ".id", "two items share the id '" + shown(item.id) + "'", "give each its own");
    }
    inspectItem(instrument, item, path, problems);
    warnOfSameText(instrument, i, path, problems);
    warnOfSameEnds(item, path, problems);
    inspectCondition(instrument, i, path, problems);
  }
}

void inspectScores(const Instrument& instrument, Problems& problems) {
  std::set<std::string> ids;
  for (std::size_t i = 0; i < instrument.scores.size(); ++i) {
    const Score& score = instrument.scores[i];
    const std::string path = "$.scores[" + std::to_string(i) + "]";
    if (!ids.insert(score.id).second) {
      problems.add(
          path + ".id", "two scores share the id '" + shown(score.id) + "'", "give each its own");
    }
    inspectScore(instrument, score, path, problems);
  }
}

/// Replaces the warnings on texts in a language that is not listed by one for each language.
Problems withOneForEachLanguage(const Problems& problems) {
  const auto isUnlisted = [](const Problem& problem) {
    return problem.what.key() == "language_not_listed";
  };
  Problems fewer;
  std::vector<base::Message> told;
  for (const auto& problem : problems.all()) {
    const auto isSame = [&](const Problem& other) { return other.what == problem.what; };
    const auto count = isUnlisted(problem) ? std::ranges::count_if(problems.all(), isSame) : 1;
    if (count == 1) {
      fewer.add(problem);
    } else if (!base::contains(told, problem.what)) {
      told.push_back(problem.what);
      fewer.warn(
          "$.languages",
          warning("texts_not_listed", count, problem.what.arguments().front()),
          problem.fix);
    }
  }
  return fewer;
}

}  // namespace

Problems problemsOf(const Instrument& instrument) {
  Problems problems;
  const TextCheck texts(instrument.languages, problems);
  inspectHead(instrument, texts, problems);
  inspectItems(instrument, problems);
  inspectScores(instrument, problems);
  inspectConsistency(instrument, problems);
  return withOneForEachLanguage(problems);
}

}  // namespace questionnaires
