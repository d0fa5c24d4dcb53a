#pragma once

#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/embedded_file.h"
#include "questionnaires/model/instrument.h"

namespace questionnaires {

/// The files of questionnaires/library, as they were when the program was built.
std::span<const base::EmbeddedFile> libraryFiles();

/// What a laboratory has written for the blanks "[[key]]" in texts that participants read, by key.
using BlankTexts = std::map<std::string, LocalizedText>;

/// Fills in blanks: puts the laboratory's text in place of "[[key]]". A blank for which there is no
/// text stays as it is.
class BlankFiller {
 public:
  BlankFiller() = default;
  explicit BlankFiller(BlankTexts texts) : texts_(std::move(texts)) {}

  /// In every language of @p text, with the words of that language, or else in English.
  void fill(LocalizedText& text);
  /// In all texts that participants see.
  void fill(Instrument& instrument);

  /// The keys of all blanks that were seen so far, filled or not: each once, in that order.
  const std::vector<std::string>& keys() const noexcept { return keys_; }

 private:
  std::string filled(const std::string& text, const std::string& language);
  void note(const std::string& key);

  BlankTexts texts_;
  std::vector<std::string> keys_;
};

/// Reads an instrument from JSON (docs/questionnaire-format.md) and reports all problems, those of
/// problemsOf() included; std::nullopt if there are errors. Warnings are only reported if there are
/// no errors.
/// @param blanks  fills in blanks before the texts are checked; nullptr: they stay.
std::optional<Instrument> readInstrument(
    std::string_view json, Problems& problems, BlankFiller* blanks = nullptr);

/// The same, from JSON that must be valid.
/// @throws UserError  listing all problems of the instrument called @p name.
Instrument readSoundInstrument(std::string_view json, const std::string& name);

}  // namespace questionnaires
