#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "questionnaires/json/document.h"
#include "questionnaires/model/localized_text.h"

namespace questionnaires {

/// Reads texts that may stand in several languages: "…" for English, or {"en": "…", "de": "…"}.
///
/// What cannot be read is a problem once, and a dash in every language stands in for it: so that
/// problemsOf(), which looks at the instrument afterwards, speaks about nothing that was said.
class TextReader {
 public:
  explicit TextReader(std::vector<std::string> languages) : languages_(std::move(languages)) {}

  LocalizedText required(const Node& node, std::string_view key) const;
  /// Empty where the key is missing.
  LocalizedText optional(const Node& node, std::string_view key) const;
  /// The text that @p node itself is.
  LocalizedText read(const Node& node) const;
  LocalizedText standIn() const;

 private:
  std::vector<std::string> languages_;
};

/// Whether @p tag is a language tag as this format knows them: "en", "nb", "de-CH".
bool isLanguageTag(std::string_view tag) noexcept;

}  // namespace questionnaires
