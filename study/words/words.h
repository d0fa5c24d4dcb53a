#pragma once

#include <map>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "base/embedded_file.h"
#include "base/message.h"

namespace study::words {

/// The catalogues of study/words/library, a file for each language.
std::span<const base::EmbeddedFile> catalogueFiles();

/// The texts of reports and of all windows in one language.
struct Catalogue {
  using Entries = std::map<std::string, std::string, std::less<>>;
  using Windows = std::map<std::string, Entries, std::less<>>;

  Entries messages;  ///< messages of all components (base::Message), by key
  Entries texts;     ///< texts of reports, by their English text
  Windows windows;   ///< texts of the participant's windows, by class and English text
  Entries desk;      ///< texts of the operator's windows, by their English text
};

/// Looks up the texts of reports in one language. A text that the catalogue lacks stays English.
/// Numbers are the same in all languages: with a decimal point, as the rules of APA and DGPs for
/// reporting statistics ask.
class Words {
 public:
  /// English.
  Words() = default;
  Words(std::string language, Catalogue catalogue)
      : language_(std::move(language)), catalogue_(std::move(catalogue)) {}

  const std::string& language() const noexcept { return language_; }
  const Catalogue& catalogue() const noexcept { return catalogue_; }

  /// A text of the report.
  std::string operator()(std::string_view english) const;

  /// A message with its arguments filled in; empty for no message.
  std::string operator()(const base::Message& message) const;

  /// Several messages, separated by semicolons.
  std::string operator()(const std::vector<base::Message>& messages) const;

  /// A text with arguments for its {}. Their order is the same in every language unless they are
  /// numbered.
  template <typename... Args>
  std::string say(std::string_view english, Args&&... args) const {
    return fmt::format(fmt::runtime((*this)(english)), std::forward<Args>(args)...);
  }

  /// Like say(), with the plural forms @p one (for 1) and @p many (for all other numbers). @p
  /// number is the first argument of either.
  template <typename Number, typename... Args>
  std::string count(
      Number number, std::string_view one, std::string_view many, Args&&... args) const {
    const auto ofOne = (*this)(one);
    // look up both, so that a missing entry of either is reported
    const auto manyPattern = (*this)(many);
    return fmt::format(
        fmt::runtime(number == 1 ? ofOne : manyPattern), number, std::forward<Args>(args)...);
  }

  /// The texts and keys of messages that were looked up and not found.
  const std::set<std::string, std::less<>>& missing() const noexcept { return missing_; }

 private:
  std::string_view patternOf(
      const Catalogue::Entries& entries, std::string_view key, std::string_view english) const;

  std::string language_ = "en";
  Catalogue catalogue_;
  mutable std::set<std::string, std::less<>> missing_;
};

/// The languages that have a catalogue: "en", "de", "nb".
std::vector<std::string> languages();

/// @throws std::invalid_argument  for an unknown language; names the known ones.
Words wordsIn(std::string_view language);
/// The same; English for a language without words.
Words wordsOrEnglish(std::string_view language);

}  // namespace study::words
