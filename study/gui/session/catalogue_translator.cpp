#include "study/gui/session/catalogue_translator.h"

#include <string>

#include <QCoreApplication>

namespace study::gui {

void CatalogueTranslator::setLanguage(std::string_view language) {
  windows_ = words::wordsOrEnglish(language).catalogue().windows;
}

void CatalogueTranslator::speak(std::string_view language) {
  // A translator that is installed already does not tell the windows that its texts have changed.
  QCoreApplication::removeTranslator(this);
  setLanguage(language);
  QCoreApplication::installTranslator(this);
}

QString CatalogueTranslator::translate(
    const char* window, const char* english, const char* /*comment*/, int /*count*/) const {
  const auto texts = windows_.find(std::string_view(window));
  if (texts == windows_.end()) return {};
  const auto text = texts->second.find(std::string_view(english));
  return text == texts->second.end() ? QString() : QString::fromStdString(text->second);
}

}  // namespace study::gui
