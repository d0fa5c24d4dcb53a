#pragma once

#include <map>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

namespace study::words {

/// What reports say, in one language. Sentences are known by their English words; where the
/// catalogue of a language lacks one, the English stands. Numbers are the same in all languages:
/// with a point, as the DGPs' and APA's rules for reporting statistics have it.
class Words {
 public:
  /// English.
  Words() = default;
  Words(std::string language, std::map<std::string, std::string, std::less<>> catalogue)
      : language_(std::move(language)), catalogue_(std::move(catalogue)) {}

  const std::string& language() const noexcept { return language_; }

  const std::map<std::string, std::string, std::less<>>& catalogue() const noexcept {
    return catalogue_;
  }

  const std::string& operator()(std::string_view english) const;

  /// The same for what somebody else says, a kernel's reason or a file's word: as it is where the
  /// catalogue lacks it. Numbers and names in 'quotes' stand as {} in the catalogue; what comes
  /// after a colon may be left out of it.
  std::string known(std::string_view words) const;

  /// Several of these, between semicolons.
  std::string knownList(std::string_view words) const;

  /// With {} where something is put in, in the same order in every language unless numbered.
  template <typename... Args>
  std::string say(std::string_view english, Args&&... args) const {
    return fmt::format(fmt::runtime((*this)(english)), std::forward<Args>(args)...);
  }

  /// The same of a number of things, which is put in first: @p one of one, @p many of all others.
  template <typename Number, typename... Args>
  std::string count(
      Number number, std::string_view one, std::string_view many, Args&&... args) const {
    const auto& ofOne = (*this)(one);
    const auto& ofMany = (*this)(many);  // both, so that a catalogue that lacks one is found out
    return fmt::format(
        fmt::runtime(number == 1 ? ofOne : ofMany), number, std::forward<Args>(args)...);
  }

  /// What was asked for and was not in the catalogue.
  const std::set<std::string, std::less<>>& missing() const noexcept { return missing_; }

 private:
  std::string language_ = "en";
  std::map<std::string, std::string, std::less<>> catalogue_;
  mutable std::set<std::string, std::less<>> missing_;
};

/// Which languages there are: "en", "de", "nb".
std::vector<std::string> languages();

/// @throws std::invalid_argument  for a language that is not there, with those that are.
Words wordsIn(std::string_view language);

}  // namespace study::words
