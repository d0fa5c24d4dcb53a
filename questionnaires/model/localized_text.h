#pragma once

#include <map>
#include <string>
#include <string_view>
#include <utility>

namespace questionnaires {

/// A text in the languages its author wrote it in, by language tag ("en", "de", "nb").
class LocalizedText {
 public:
  LocalizedText() = default;
  explicit LocalizedText(std::map<std::string, std::string> byLanguage)
      : byLanguage_(std::move(byLanguage)) {}

  /// The text in @p language, or in English where there is none; empty where there is neither.
  const std::string& in(std::string_view language) const;

  bool has(std::string_view language) const { return byLanguage_.count(std::string(language)) > 0; }
  bool operator==(const LocalizedText& other) const = default;
  bool isEmpty() const noexcept { return byLanguage_.empty(); }
  const std::map<std::string, std::string>& all() const noexcept { return byLanguage_; }

 private:
  std::map<std::string, std::string> byLanguage_;
};

}  // namespace questionnaires
