#include "study/gui/session/catalogue_translator.h"

#include <algorithm>
#include <string>

namespace study::gui {

void CatalogueTranslator::setLanguage(std::string_view language) {
  const auto all = words::languages();
  const bool isKnown = std::find(all.begin(), all.end(), language) != all.end();
  windows_ = isKnown ? words::wordsIn(language).catalogue().windows : words::Catalogue::Windows();
}

QString CatalogueTranslator::translate(
    const char* window, const char* english, const char* /*comment*/, int /*count*/) const {
  const auto texts = windows_.find(std::string_view(window));
  if (texts == windows_.end()) return {};
  const auto text = texts->second.find(std::string_view(english));
  return text == texts->second.end() ? QString() : QString::fromStdString(text->second);
}

}  // namespace study::gui
