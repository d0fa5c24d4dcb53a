#include "protocols/loaded_protocol.h"

#include <algorithm>
#include <filesystem>
#include <set>

#include "haptics/recordings/parametric_cut.h"
#include "protocols/cut_file.h"
#include "protocols/library.h"
#include "protocols/protocol_file.h"
#include "protocols/rules.h"
#include "questionnaires/document.h"
#include "questionnaires/instrument_file.h"
#include "questionnaires/library.h"

namespace protocols {
namespace {

using questionnaires::Instrument;
using questionnaires::Problems;

/// Passes on what was found in another file, with that file's name before the path.
void passOn(const Problems& found, const std::string& file, Problems& problems) {
  for (const auto& problem : found.all()) {
    const std::string path = file + " " + problem.path;
    if (problem.severity == questionnaires::Severity::Error) {
      problems.add(path, problem.what, problem.fix);
    } else {
      problems.warn(path, problem.what, problem.fix);
    }
  }
}

std::set<std::string> instrumentsUsed(const Protocol& protocol) {
  std::set<std::string> used;
  for (const auto& phase : protocol.phases) {
    if (!phase.instrument.empty()) used.insert(phase.instrument);
    for (const auto& asked : phase.trials.questionnaires) used.insert(asked.instrument);
  }
  return used;
}

void addLibraryInstruments(const std::set<std::string>& used, std::vector<Instrument>& all) {
  for (const auto& id : used) {
    const bool isThere =
        std::any_of(all.begin(), all.end(), [&](const auto& i) { return i.id == id; });
    if (isThere) continue;
    for (const auto& file : questionnaires::libraryFiles()) {
      if (file.name == id + ".json") {
        all.push_back(questionnaires::readSoundInstrument(file.content, id));
      }
    }
  }
}

/// Reads the files that stand beside a protocol.
class Companions {
 public:
  Companions(LoadedProtocol& loaded, const FileFinder& find, Problems& problems)
      : loaded_(loaded), find_(find), problems_(problems) {}

  void readInstruments() {
    for (std::size_t i = 0; i < loaded_.protocol.instrumentFiles.size(); ++i) {
      const auto& name = loaded_.protocol.instrumentFiles[i];
      const auto text = textOf(name, "$.instrument_files[" + std::to_string(i) + "]");
      if (!text) continue;
      Problems found;
      auto instrument = questionnaires::readInstrument(*text, found);
      passOn(found, name, problems_);
      if (instrument) loaded_.instruments.push_back(std::move(*instrument));
    }
  }

  void readCut(Condition& condition) {
    if (!condition.cut) return;
    std::optional<haptics::recordings::Cut> cut;
    if (condition.cut->name == "parametric") {
      cut = haptics::recordings::parametricCut();
    } else if (const auto text = textOf(condition.cut->name, condition.cut->path)) {
      Problems found;
      cut = protocols::readCut(*text, found);
      passOn(found, condition.cut->name, problems_);
    }
    if (!cut) return;
    auto& model = condition.scene.model;
    if (auto* kalman = std::get_if<haptics::engine::KalmanSpec>(&model)) {
      kalman->interpolation.curve = nodesOf(*cut);
    } else if (auto* spec = std::get_if<haptics::engine::InterpolationSpec>(&model)) {
      spec->curve = nodesOf(*cut);
    }
  }

 private:
  std::optional<std::string> textOf(const std::string& name, const std::string& path) {
    const auto known = std::find_if(
        loaded_.files.begin(), loaded_.files.end(), [&](const auto& f) { return f.name == name; });
    if (known != loaded_.files.end()) return known->text;
    const std::filesystem::path asked(name);
    const bool leaves =
        asked.is_absolute() || std::find(asked.begin(), asked.end(), "..") != asked.end();
    if (leaves) {
      problems_.add(
          path,
          "'" + name + "' lies outside the protocol's folder",
          "copy the file beside the protocol and name it without a folder above");
      return std::nullopt;
    }
    auto text = find_(name);
    if (!text) {
      problems_.add(
          path,
          "there is no file '" + name + "'",
          "put it beside the protocol, or correct the name");
      return std::nullopt;
    }
    loaded_.files.push_back({name, *text});
    return text;
  }

  LoadedProtocol& loaded_;
  const FileFinder& find_;
  Problems& problems_;
};

}  // namespace

const Instrument* LoadedProtocol::instrument(std::string_view id) const noexcept {
  const auto found = std::find_if(
      instruments.begin(), instruments.end(), [&](const auto& i) { return i.id == id; });
  return found == instruments.end() ? nullptr : &*found;
}

std::optional<LoadedProtocol> loadProtocol(
    std::string_view json, const FileFinder& find, Problems& problems) {
  auto protocol = readProtocol(json, problems);
  if (!protocol) return std::nullopt;
  LoadedProtocol loaded{
      .protocol = std::move(*protocol), .instruments = {}, .text = std::string(json), .files = {}};
  Companions companions(loaded, find, problems);
  companions.readInstruments();
  for (auto& condition : loaded.protocol.conditions) companions.readCut(condition);
  addLibraryInstruments(instrumentsUsed(loaded.protocol), loaded.instruments);
  checkRules(loaded, problems);
  return problems.hasErrors() ? std::nullopt : std::optional(std::move(loaded));
}

std::optional<LoadedProtocol> loadProtocolFile(const std::string& path, Problems& problems) {
  for (const auto& file : libraryFiles()) {
    const std::string name(file.name);
    if (!std::filesystem::exists(path) && (path == name || path + ".json" == name)) {
      return loadProtocol(
          file.content, [](const std::string&) { return std::nullopt; }, problems);
    }
  }
  const auto folder = std::filesystem::path(path).parent_path();
  const auto beside = [&](const std::string& name) -> std::optional<std::string> {
    const auto file = folder / name;
    std::error_code ignored;
    if (!std::filesystem::exists(file, ignored)) return std::nullopt;
    return questionnaires::readTextFile(file.string());
  };
  return loadProtocol(questionnaires::readTextFile(path), beside, problems);
}

}  // namespace protocols
