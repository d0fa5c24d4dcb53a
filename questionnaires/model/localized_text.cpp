#include "questionnaires/model/localized_text.h"

namespace questionnaires {

const std::string& LocalizedText::in(std::string_view language) const {
  static const std::string kNothing;
  auto found = byLanguage_.find(std::string(language));
  if (found == byLanguage_.end()) found = byLanguage_.find("en");
  return found == byLanguage_.end() ? kNothing : found->second;
}

}  // namespace questionnaires
