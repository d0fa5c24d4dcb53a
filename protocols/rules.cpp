#include "protocols/rules.h"

#include <algorithm>
#include <set>
#include <string>

#include "protocols/block_rules.h"

namespace protocols {
namespace {

using questionnaires::Instrument;
using questionnaires::ItemType;
using questionnaires::Problems;

std::string at(const char* list, std::size_t index) {
  return "$." + std::string(list) + "[" + std::to_string(index) + "]";
}

template <typename T>
void checkUnique(
    const std::vector<T>& things, const char* list, const char* what, Problems& problems) {
  std::set<std::string> seen;
  for (std::size_t i = 0; i < things.size(); ++i) {
    if (!things[i].id.empty() && !seen.insert(things[i].id).second) {
      problems.add(
          at(list, i) + ".id",
          std::string("two ") + what + " share the id '" + things[i].id + "'",
          "give each its own");
    }
  }
}

void checkLanguages(const Protocol& protocol, Problems& problems) {
  const auto& languages = protocol.languages;
  if (std::find(languages.begin(), languages.end(), "en") == languages.end()) {
    problems.add("$.languages", "English is missing", "add \"en\": every text falls back to it");
  }
  std::set<std::string> seen;
  for (std::size_t i = 0; i < languages.size(); ++i) {
    if (!seen.insert(languages[i]).second) {
      problems.add(at("languages", i), "'" + languages[i] + "' stands here twice", "keep one");
    }
  }
}

void checkConditions(const Protocol& protocol, Problems& problems) {
  for (std::size_t i = 0; i < protocol.conditions.size(); ++i) {
    const auto& condition = protocol.conditions[i];
    const std::string scene = at("conditions", i) + ".scene";
    const auto* device = protocol.device(condition.device);
    if (device == nullptr) {
      problems.add(
          scene + ".device",
          "there is no device '" + condition.device + "' in this protocol",
          "add it to 'devices', or correct the name");
      continue;
    }
    auto spec = condition.scene;
    spec.device = device->kind;
    for (const auto& wrong : haptics::engine::problemsOf(spec)) {
      problems.add(scene + ".parameters", wrong, "");
    }
  }
}

void checkDevicesAreUsed(const Protocol& protocol, Problems& problems) {
  for (std::size_t i = 0; i < protocol.devices.size(); ++i) {
    const bool isUsed =
        std::any_of(protocol.conditions.begin(), protocol.conditions.end(), [&](const auto& c) {
          return c.device == protocol.devices[i].id;
        });
    if (!isUsed) {
      problems.warn(
          at("devices", i),
          "no condition uses '" + protocol.devices[i].id + "'",
          "it will not be opened; remove it");
    }
  }
}

bool hasConsentItem(const Instrument& instrument) {
  return std::any_of(instrument.items.begin(), instrument.items.end(), [](const auto& item) {
    return !item.consentOption.empty();
  });
}

bool asksForAnAlternative(const Instrument& instrument) {
  return std::any_of(instrument.items.begin(), instrument.items.end(), [](const auto& item) {
    return item.type == ItemType::SingleChoice &&
           item.optionSource == questionnaires::OptionSource::Alternatives;
  });
}

void checkInstrument(
    const LoadedProtocol& loaded,
    const std::string& id,
    const std::string& path,
    Problems& problems) {
  const auto* instrument = loaded.instrument(id);
  if (instrument == nullptr) {
    problems.add(
        path,
        "there is no instrument '" + id + "'",
        "name one of the library, or list its file in 'instrument_files'");
    return;
  }
  for (const auto& language : loaded.protocol.languages) {
    const auto& known = instrument->languages;
    if (std::find(known.begin(), known.end(), language) == known.end()) {
      problems.warn(
          path, "'" + id + "' has no texts in '" + language + "'", "English will be shown instead");
    }
  }
}

void checkPhase(const LoadedProtocol& loaded, std::size_t index, Problems& problems) {
  const auto& phase = loaded.protocol.phases[index];
  const std::string path = at("phases", index);
  if (!phase.instrument.empty()) {
    checkInstrument(loaded, phase.instrument, path + ".instrument", problems);
  }
  const auto* instrument = loaded.instrument(phase.instrument);
  if (instrument == nullptr) return;
  if (phase.type == PhaseType::Consent && !hasConsentItem(*instrument)) {
    problems.add(
        path + ".instrument",
        "'" + phase.instrument + "' asks for no consent",
        "it needs an item with 'consent_option'");
  }
  if (phase.type == PhaseType::Preference && !asksForAnAlternative(*instrument)) {
    problems.add(
        path + ".instrument",
        "'" + phase.instrument + "' does not ask for an alternative",
        "it needs a single_choice item with \"options_from\": \"alternatives\"");
  }
}

void checkConsentComesFirst(const Protocol& protocol, Problems& problems) {
  bool hasConsent = false;
  for (std::size_t i = 0; i < protocol.phases.size(); ++i) {
    const auto type = protocol.phases[i].type;
    if (type == PhaseType::Consent) hasConsent = true;
    const bool isFelt = type == PhaseType::Block || type == PhaseType::Benchmark;
    if (isFelt && !hasConsent) {
      problems.add(
          at("phases", i),
          "something is felt here before anybody has agreed to take part",
          "put a phase of type 'consent' before it");
      return;
    }
  }
}

}  // namespace

void checkRules(const LoadedProtocol& loaded, Problems& problems) {
  const auto& protocol = loaded.protocol;
  checkUnique(protocol.cohorts, "cohorts", "cohorts", problems);
  checkUnique(protocol.devices, "devices", "devices", problems);
  checkUnique(protocol.conditions, "conditions", "conditions", problems);
  checkUnique(protocol.phases, "phases", "phases", problems);
  checkUnique(protocol.analysis.families, "analysis.families", "families", problems);
  checkLanguages(protocol, problems);
  checkConditions(protocol, problems);
  checkDevicesAreUsed(protocol, problems);
  checkConsentComesFirst(protocol, problems);
  for (std::size_t i = 0; i < protocol.phases.size(); ++i) checkPhase(loaded, i, problems);
  checkBlocks(loaded, problems);
  if (!problems.hasErrors()) checkAnalysis(loaded, problems);
}

}  // namespace protocols
