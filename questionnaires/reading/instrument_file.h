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

/// The instruments of questionnaires/library, embedded in the program.
std::span<const base::EmbeddedFile> libraryFiles();

/// The laboratory's texts for the blanks "[[key]]" in texts that participants read, by key.
using BlankTexts = std::map<std::string, LocalizedText>;

/// Replaces blanks "[[key]]" by the laboratory's texts. A blank without a text is kept.
class BlankFiller {
 public:
  BlankFiller() = default;
  explicit BlankFiller(BlankTexts texts) : texts_(std::move(texts)) {}

  /// Fills in the blanks in every language of @p text with the laboratory's text in that language
  /// or, if it is missing, in English.
  void fill(LocalizedText& text);
  /// Fills in the blanks of all texts that participants see.
  void fill(Instrument& instrument);

  /// The keys of all blanks that fill() has found, filled in or not, without duplicates, in the
  /// order in which they were found.
  const std::vector<std::string>& keys() const noexcept { return keys_; }

 private:
  /// @p text with its blanks filled in.
  std::string filled(const std::string& text, const std::string& language);
  /// Adds a key to keys(), unless it is there.
  void note(const std::string& key);

  BlankTexts texts_;
  std::vector<std::string> keys_;
};

/// Reads an instrument from JSON (docs/questionnaire-format.md) and reports all problems, including
/// those of problemsOf(); std::nullopt if there are errors. Warnings are reported only if there are
/// no errors.
/// @param blanks  fills in blanks before the texts are checked; nullptr: blanks are kept.
std::optional<Instrument> readInstrument(
    std::string_view json, Problems& problems, BlankFiller* blanks = nullptr);

/// Reads an instrument that must be valid.
/// @throws UserError  with all problems of the instrument called @p name.
Instrument readValidInstrument(std::string_view json, const std::string& name);

}  // namespace questionnaires
