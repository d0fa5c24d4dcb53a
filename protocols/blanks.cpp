#include "protocols/blanks.h"

#include <set>

#include "protocols/instrument_use.h"
#include "questionnaires/text_problems.h"

namespace protocols {
namespace {

using questionnaires::LocalizedText;

void addBlanks(std::string& words, const LocalizedText& text, const std::string& language) {
  const std::string more = questionnaires::placeholdersOf(text.in(language));
  if (!more.empty()) words += (words.empty() ? "" : ", ") + more;
}

std::string blanksIn(const questionnaires::Instrument& instrument, const std::string& language) {
  std::string words;
  addBlanks(words, instrument.title, language);
  addBlanks(words, instrument.introduction, language);
  for (const auto& item : instrument.items) {
    for (const auto* text : {&item.text, &item.leftText, &item.rightText}) {
      addBlanks(words, *text, language);
    }
  }
  return words;
}

}  // namespace

std::vector<Blank> blanksOf(const LoadedProtocol& loaded, const std::string& language) {
  std::vector<Blank> blanks;
  const auto add = [&](const std::string& where, const std::string& words) {
    if (!words.empty()) blanks.push_back({where, words});
  };
  for (std::size_t i = 0; i < loaded.protocol.phases.size(); ++i) {
    std::string words;
    addBlanks(words, loaded.protocol.phases[i].text, language);
    add("$.phases[" + std::to_string(i) + "].text", words);
  }
  std::set<std::string> seen;
  for (const auto& use : instrumentUses(loaded.protocol)) {
    if (!seen.insert(use.instrument).second) continue;
    add(use.instrument, blanksIn(*loaded.instrument(use.instrument), language));
  }
  return blanks;
}

}  // namespace protocols
