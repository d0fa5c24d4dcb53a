#include "tests/questionnaires/shipped_instruments.h"

#include <utility>

#include "questionnaires/reading/instrument_file.h"

namespace tests {

using questionnaires::Instrument;
using questionnaires::LocalizedText;

bool isInstrument(std::string_view name) {
  return name.find(".schema.") == std::string_view::npos;
}

const std::map<std::string, Instrument>& shipped() {
  static const auto kInstruments = [] {
    std::map<std::string, Instrument> instruments;
    for (const auto& file : questionnaires::libraryFiles()) {
      if (!isInstrument(file.name)) continue;
      auto instrument = questionnaires::readValidInstrument(file.content, std::string(file.name));
      instruments.emplace(instrument.id, std::move(instrument));
    }
    return instruments;
  }();
  return kInstruments;
}

std::vector<LocalizedText> visibleTexts(const Instrument& instrument) {
  std::vector<LocalizedText> texts{instrument.title, instrument.introduction};
  for (const auto& item : instrument.items) {
    texts.insert(
        texts.end(),
        {item.text, item.leftText, item.rightText, item.scale.lowLabel, item.scale.highLabel});
    texts.insert(texts.end(), item.scale.pointLabels.begin(), item.scale.pointLabels.end());
    for (const auto& option : item.options) texts.push_back(option.text);
  }
  return texts;
}

}  // namespace tests
