#include <algorithm>
#include <set>
#include <string>

#include "base/search.h"
#include "protocols/model/messages.h"
#include "protocols/model/protocol.h"
#include "protocols/validation/validation.h"
#include "questionnaires/reading/instrument_file.h"
#include "questionnaires/reading/instrument_problems.h"
#include "questionnaires/reading/wording.h"

namespace protocols {
namespace {

using questionnaires::Instrument;
using questionnaires::Problems;

std::string at(const char* list, std::size_t index) {
  return "$." + std::string(list) + "[" + std::to_string(index) + "]";
}

bool isInLibrary(const std::string& instrument) {
  const auto files = questionnaires::libraryFiles();
  return std::ranges::any_of(
      files, [&](const auto& file) { return file.name == instrument + ".json"; });
}

/// Adds the warnings about the texts, the instruments and the unused parts of a protocol.
class ProtocolWarningCheck {
 public:
  ProtocolWarningCheck(const LoadedProtocol& loaded, Problems& problems)
      : loaded_(loaded), protocol_(loaded.protocol), problems_(problems) {}

  void addTextWarnings() {
    text("$.labels.prefix", protocol_.labels.prefix);
    for (std::size_t i = 0; i < protocol_.phases.size(); ++i) {
      const auto& words = protocol_.phases[i].text;
      if (!words.isEmpty()) text(at("phases", i) + ".text", words);
    }
  }

  void addInstrumentWarnings() {
    std::set<std::string> usedInstruments;
    for (const auto& use : instrumentUses(protocol_)) {
      if (!usedInstruments.insert(use.instrument).second) continue;
      const auto* instrument = loaded_.instrument(use.instrument);
      warnOfLanguages(*instrument, use.path);
      warnOfOccasions(*instrument, use.path);
      if (!isFromFile(*instrument)) addLibraryWarnings(*instrument);
    }
    for (std::size_t i = 0; i < protocol_.instrumentFiles.size(); ++i) {
      file(loaded_.instruments[i].id, at("instrument_files", i), usedInstruments);
    }
  }

  void addUnusedTextWarnings() {
    for (const auto& [key, text] : protocol_.texts) {
      if (base::contains(loaded_.blanks, key)) continue;
      problems_.warn(
          "$.texts." + questionnaires::shown(key),
          message("text_not_used", key),
          message("text_not_used.fix"));
    }
  }

  void addUnusedPartWarnings() {
    std::set<std::string> devices;
    for (const auto& condition : protocol_.conditions) devices.insert(condition.device);
    std::set<std::string> felt;
    for (const auto& phase : protocol_.phases) {
      felt.insert(phase.trials.conditions.begin(), phase.trials.conditions.end());
    }
    for (std::size_t i = 0; i < protocol_.devices.size(); ++i) {
      const auto& id = protocol_.devices[i].id;
      if (devices.count(id) > 0) continue;
      problems_.warn(
          at("devices", i), message("device_not_used", id), message("device_not_used.fix"));
    }
    for (std::size_t i = 0; i < protocol_.conditions.size(); ++i) {
      const auto& id = protocol_.conditions[i].id;
      if (felt.count(id) > 0) continue;
      problems_.warn(
          at("conditions", i),
          message("condition_not_used", id),
          message("condition_not_used.fix"));
    }
  }

 private:
  void text(const std::string& path, const LocalizedText& words) {
    for (const auto& language : protocol_.languages) {
      if (!words.has(language)) {
        problems_.warn(path, message("no_text", language), message("no_text.fix", language));
        continue;
      }
      const std::string placeholders = questionnaires::placeholdersOf(words.in(language));
      if (placeholders.empty()) continue;
      problems_.warn(
          path, message("blank_left_in", language, placeholders), message("blank_left_in.fix"));
    }
  }

  void warnOfLanguages(const Instrument& instrument, const std::string& path) {
    for (const auto& language : protocol_.languages) {
      // texts in a language that the instrument does not list were reported already
      const bool hasTexts =
          base::contains(instrument.languages, language) || instrument.title.has(language);
      if (hasTexts) continue;
      problems_.warn(
          path,
          message("no_texts_in", instrument.id, language),
          message(
              "no_texts_in.fix",
              fileOf(instrument),
              language,
              questionnaires::wordingFileName(instrument.id, language)));
    }
  }

  /// Warns if an instrument whose result is a change is not asked both before and after.
  void warnOfOccasions(const Instrument& instrument, const std::string& path) {
    if (instrument.occasions != questionnaires::Occasions::BeforeAndAfter) return;
    const auto uses = instrumentUses(protocol_);
    const auto times = std::ranges::count_if(
        uses, [&](const InstrumentUse& use) { return use.instrument == instrument.id; });
    if (times > 1) return;
    problems_.warn(path, message("asked_once", instrument.id), message("asked_once.fix"));
  }

  /// The instrument as commands name it: by its file, or by its id in the library.
  std::string fileOf(const Instrument& instrument) const {
    if (!isFromFile(instrument)) return instrument.id;
    return protocol_
        .instrumentFiles[static_cast<std::size_t>(&instrument - loaded_.instruments.data())];
  }

  /// Whether the instrument was read from a file. Its warnings were then reported already.
  bool isFromFile(const Instrument& instrument) const {
    const auto files = static_cast<std::ptrdiff_t>(protocol_.instrumentFiles.size());
    return &instrument - loaded_.instruments.data() < files;
  }

  /// Adds the warnings about an instrument of the library. Leaves out warnings about statements
  /// that compare with the previous alternative: addBlockWarnings() gives those where a block may
  /// have no previous alternative.
  void addLibraryWarnings(const Instrument& instrument) {
    const auto found = questionnaires::problemsOf(instrument);
    for (const auto& problem : found.all()) {
      if (problem.path.ends_with(".relative_to") || isAboutTranslation(problem, instrument))
        continue;
      problems_.warn(instrument.id + " " + problem.path, problem.what, message("template.fix"));
    }
  }

  /// Whether the placeholder was reported already for another language.
  static bool isAboutTranslation(
      const questionnaires::Problem& problem, const Instrument& instrument) {
    return std::ranges::any_of(instrument.languages, [&](const auto& language) {
      return language != "en" && problem.path.ends_with("." + language);
    });
  }

  void file(const std::string& id, const std::string& path, const std::set<std::string>& used) {
    if (used.count(id) == 0) {
      problems_.warn(
          path, message("instrument_not_asked", id), message("instrument_not_asked.fix"));
    }
    if (isInLibrary(id)) {
      problems_.warn(
          path, message("hides_library_instrument", id), message("hides_library_instrument.fix"));
    }
  }

  const LoadedProtocol& loaded_;
  const Protocol& protocol_;
  Problems& problems_;
};

}  // namespace

void addWarnings(const LoadedProtocol& loaded, Problems& problems, Defaults defaults) {
  ProtocolWarningCheck advice(loaded, problems);
  advice.addTextWarnings();
  advice.addUnusedTextWarnings();
  advice.addInstrumentWarnings();
  addSceneWarnings(loaded.protocol, problems);
  addBlockWarnings(loaded, problems);
  addAnalysisWarnings(loaded.protocol, problems);
  addBlindingWarnings(loaded.protocol, problems);
  if (defaults == Defaults::Current) {
    addReferentWarnings(loaded, problems);
    addItemWarnings(loaded, problems);
    addPoolingWarnings(loaded.protocol, problems);
    addForceWarnings(loaded.protocol, problems);
    addPlanWarnings(loaded, problems);
    addWordWarnings(loaded, problems);
  }
  advice.addUnusedPartWarnings();
}

}  // namespace protocols
