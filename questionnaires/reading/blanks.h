#pragma once

#include <map>
#include <string>
#include <vector>

#include "questionnaires/model/instrument.h"

namespace questionnaires {

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

}  // namespace questionnaires
