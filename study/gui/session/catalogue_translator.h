#pragma once

#include <string_view>

#include <QTranslator>

#include "study/words/words.h"

namespace study::gui {

/// The windows' texts in a language of study/words. English stays where the catalogue has no text
/// for the window (the operator's windows), and in a language without a catalogue.
class CatalogueTranslator final : public QTranslator {
 public:
  /// Sets the language of the texts ("de").
  void setLanguage(std::string_view language);
  /// The same, and gives the windows these texts.
  void speak(std::string_view language);

  bool isEmpty() const override { return windows_.empty(); }
  QString translate(
      const char* window, const char* english, const char* comment, int count) const override;

 private:
  words::Catalogue::Windows windows_;
};

}  // namespace study::gui
