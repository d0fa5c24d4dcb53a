#include <algorithm>
#include <map>

#include "base/search.h"
#include "questionnaires/reading/instrument_reader.h"

namespace questionnaires {
namespace {

constexpr std::string_view kPlaceholderText = "-";

bool isLowerCase(char c) noexcept {
  return c >= 'a' && c <= 'z';
}

bool isLetterOrDigit(char c) noexcept {
  return isLowerCase(c) || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
}

std::string textOf(const Node& node) {
  const std::string text = node.asText();
  if (node.isText() && text.empty()) node.problem("", "this text is empty", "write something");
  return text.empty() ? std::string(kPlaceholderText) : text;
}

LocalizedText textsByLanguage(const Node& node) {
  std::map<std::string, std::string> byLanguage;
  for (const auto& [language, text] : node.members()) {
    requireLanguageTag(text, "", language);
    byLanguage[language] = textOf(text);
  }
  return LocalizedText(std::move(byLanguage));
}

}  // namespace

LocalizedText TextReader::required(const Node& node, std::string_view key) const {
  return node.require(key) ? optional(node, key) : fallbackText();
}

LocalizedText TextReader::optional(const Node& node, std::string_view key) const {
  const auto value = node.member(key);
  return value ? read(*value) : LocalizedText();
}

LocalizedText TextReader::read(const Node& node) const {
  if (!node.isObject()) {
    const bool isText = node.isText();
    const std::string text = textOf(node);
    return isText ? LocalizedText({{"en", text}}) : fallbackText();
  }
  if (node.members().empty()) {
    node.problem("", "this text is in no language", "write {\"en\": \"…\"}");
    return fallbackText();
  }
  return textsByLanguage(node);
}

LocalizedText TextReader::fallbackText() const {
  std::map<std::string, std::string> byLanguage{{"en", std::string(kPlaceholderText)}};
  for (const auto& language : languages_) byLanguage[language] = kPlaceholderText;
  return LocalizedText(std::move(byLanguage));
}

bool isLanguageTag(std::string_view tag) noexcept {
  const std::string_view language = tag.substr(0, tag.find('-'));
  const bool isLanguage =
      language.size() >= 2 && language.size() <= 3 && std::ranges::all_of(language, isLowerCase);
  if (!isLanguage) return false;
  tag.remove_prefix(language.size());
  if (tag.empty()) return true;
  tag.remove_prefix(1);
  return tag.size() >= 2 && tag.size() <= 8 && std::ranges::all_of(tag, isLetterOrDigit);
}

bool requireLanguageTag(const Node& node, std::string_view key, std::string_view language) {
  if (isLanguageTag(language)) return true;
  node.problem(
      key, "'" + shown(language) + "' is no language tag", "write one such as en, de, nb, de-CH");
  return false;
}

std::vector<std::string> languagesIn(const std::vector<Node>& list) {
  std::vector<std::string> languages;
  for (const auto& node : list) {
    const std::string language = node.asText();
    if (!node.isText() || !requireLanguageTag(node, "", language)) continue;
    if (base::contains(languages, language)) {
      node.problem("", "'" + shown(language) + "' stands in this list twice", "keep one");
    } else {
      languages.push_back(language);
    }
  }
  return languages;
}

}  // namespace questionnaires
