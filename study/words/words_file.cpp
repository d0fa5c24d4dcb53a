#include <stdexcept>

#include <nlohmann/json.hpp>

#include "base/joined.h"
#include "base/search.h"
#include "study/words/words.h"

namespace study::words {

std::vector<std::string> languages() {
  std::vector<std::string> all{"en"};
  for (const auto& file : catalogueFiles())
    all.emplace_back(file.name.substr(0, file.name.find('.')));
  return all;
}

Words wordsOrEnglish(std::string_view language) {
  const auto known = languages();
  return !base::contains(known, language) ? Words() : wordsIn(language);
}

Words wordsIn(std::string_view language) {
  if (language == "en") return {};
  for (const auto& file : catalogueFiles()) {
    if (file.name.substr(0, file.name.find('.')) != language) continue;
    const auto json = nlohmann::json::parse(file.content);
    Catalogue catalogue;
    json.at("messages").get_to(catalogue.messages);
    json.at("texts").get_to(catalogue.texts);
    json.at("windows").get_to(catalogue.windows);
    json.at("desk").get_to(catalogue.desk);
    return {std::string(language), std::move(catalogue)};
  }
  throw std::invalid_argument(
      "There is no report in the language '" + std::string(language) +
      "'. There are: " + base::joined(languages(), ", ") + ".");
}

}  // namespace study::words
