#pragma once

#include <map>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "base/message.h"

namespace study::words {

/// A language's words for what reports and the participant's windows say.
struct Catalogue {
  using Entries = std::map<std::string, std::string, std::less<>>;
  using Windows = std::map<std::string, Entries, std::less<>>;

  Entries messages;  ///< facts from the rooms below (base::Message), by key
  Entries texts;     ///< a report's own texts, by their English
  Windows windows;   ///< texts of the participant's windows, by the class and their English
};

/// What reports say, in one language. Where the catalogue lacks something, the English stands.
/// Numbers are the same in all languages: with a point, as the DGPs' and APA's rules for reporting
/// statistics have it.
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

  /// A fact, with its arguments put in; empty for nothing.
  std::string operator()(const base::Message& message) const;

  /// Several facts, between semicolons.
  std::string operator()(const std::vector<base::Message>& messages) const;

  /// With {} where something is put in, in the same order in every language unless numbered.
  template <typename... Args>
  std::string say(std::string_view english, Args&&... args) const {
    return fmt::format(fmt::runtime((*this)(english)), std::forward<Args>(args)...);
  }

  /// The same of a number of things, which is put in first: @p one of one, @p many of all others.
  template <typename Number, typename... Args>
  std::string count(
      Number number, std::string_view one, std::string_view many, Args&&... args) const {
    const auto ofOne = (*this)(one);
    const auto ofMany = (*this)(many);  // both, so that a catalogue that lacks one is found out
    return fmt::format(
        fmt::runtime(number == 1 ? ofOne : ofMany), number, std::forward<Args>(args)...);
  }

  /// What was asked for and was not in the catalogue: texts, and keys of messages.
  const std::set<std::string, std::less<>>& missing() const noexcept { return missing_; }

 private:
  std::string_view patternOf(
      const Catalogue::Entries& entries, std::string_view key, std::string_view english) const;

  std::string language_ = "en";
  Catalogue catalogue_;
  mutable std::set<std::string, std::less<>> missing_;
};

/// Which languages there are: "en", "de", "nb".
std::vector<std::string> languages();

/// @throws std::invalid_argument  for a language that is not there, with those that are.
Words wordsIn(std::string_view language);

}  // namespace study::words
