#include "protocols/reading/protocol_file.h"

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "base/search.h"
#include "haptics/registry/device_kinds.h"
#include "protocols/reading/protocol_parts.h"
#include "protocols/reading/referenced_files.h"
#include "questionnaires/json/document.h"
#include "questionnaires/reading/instrument_reader.h"

namespace protocols {

questionnaires::LocalizedText readLocalized(
    const questionnaires::Node& node, std::string_view key) {
  const questionnaires::TextReader reader({"en"});
  auto text = reader.required(node, key);
  if (!text.has("en")) {
    node.problem(key, "the English text is missing", "add \"en\": every text falls back to it");
  }
  return text;
}

namespace {

using haptics::devices::DeviceKind;
using questionnaires::Choice;
using questionnaires::isValidId;
using questionnaires::Node;
using questionnaires::Problems;

constexpr std::string_view kSchema = "protocol-1.schema.json";
constexpr std::int64_t kMostExactWhole = std::int64_t{1} << 53;

constexpr std::array kPolicies{
    Choice<LabelPolicy>{"condition", LabelPolicy::Condition},
    Choice<LabelPolicy>{"position", LabelPolicy::Position},
    Choice<LabelPolicy>{"random", LabelPolicy::Random},
};

constexpr std::array kBlindings{Choice<bool>{"closed", false}, Choice<bool>{"open", true}};

void requireSchema(const Node& root) {
  const bool isThere = root.has("$schema");
  const std::string schema = isThere ? root.text("$schema") : std::string();
  const bool isPath = schema.ends_with("/" + std::string(kSchema));  // editors may need a path
  if (isThere && (isPath || schema.empty())) return;
  root.requireFormat("$schema", kSchema);
}

/// Reads a list of non-empty texts; reports empty ones.
std::vector<std::string> readTexts(const Node& node, std::string_view key) {
  std::vector<std::string> texts;
  for (const auto& entry : node.list(key)) {
    texts.push_back(entry.asText());
    if (entry.isText() && texts.back().empty()) {
      entry.problem("", "this text is empty", "write something");
    }
  }
  return texts;
}

/// Reads `instrument_files`; reports duplicate names.
std::vector<std::string> readFileNames(const Node& root) {
  auto names = readTexts(root, "instrument_files");
  std::set<std::string> seen;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (names[i].empty() || seen.insert(names[i]).second) continue;
    root.problem(
        "instrument_files[" + std::to_string(i) + "]",
        "'" + questionnaires::shown(names[i]) + "' stands in this list twice",
        "keep one");
  }
  return names;
}

std::vector<std::string> readLanguages(const Node& root) {
  const auto list = root.requiredList("languages");
  auto languages = questionnaires::languagesIn(list);
  if (!list.empty() && !base::contains(languages, "en")) {
    root.problem(
        "languages",
        "'en' is not among the languages",
        "add it: English is what is shown where another language has no text");
  }
  return languages;
}

StudyMetadata readMetadata(const Node& node) {
  StudyMetadata study;
  if (!node.isObjectWithOnlyKeys(
          {"id", "title", "version", "authors", "organizations", "date", "description"})) {
    return study;
  }
  study.id = node.id("id");
  study.title = node.text("title");
  study.version = node.text("version");
  study.authors = readTexts(node, "authors");
  study.organizations = readTexts(node, "organizations");
  study.date = node.text("date", "");
  study.description = node.text("description", "");
  return study;
}

Cohort readCohort(const Node& node) {
  constexpr int kMostPlanned = 10'000;
  Cohort cohort;
  if (!node.isObjectWithOnlyKeys({"id", "title", "planned"})) return cohort;
  cohort.id = node.id("id");
  cohort.title = readLocalized(node, "title");
  cohort.planned = static_cast<int>(node.wholeNumber("planned", 0, kMostPlanned, 0));
  return cohort;
}

/// The kind of @p device; nullptr, with a problem, if there is no kind of that name.
const DeviceKind* readKind(const Node& device) {
  const std::string name = device.text("kind");
  const auto* kind = haptics::deviceKindNamed(name);
  if (kind != nullptr || name.empty()) return kind;  // a missing name was reported already
  std::string names;
  for (const auto* known : haptics::deviceKinds()) {
    names.append(names.empty() ? "" : ", ").append(known->name);
  }
  device.problem(
      "kind",
      "there is no kind of device '" + questionnaires::shown(name) + "'",
      "write one of: " + names);
  return nullptr;
}

DeviceRequirement readDevice(const Node& node) {
  DeviceRequirement device{.kind = haptics::deviceKinds().front()};
  if (!node.isObjectWithOnlyKeys(
          {"id",
           "kind",
           "max_force_n",
           "max_force_rate_n_per_s",
           "max_torque_nm",
           "max_torque_rate_nm_per_s",
           "max_velocity",
           "passivity_control"})) {
    return device;
  }
  const std::string id = node.id("id");
  const auto* kind = readKind(node);
  if (kind != nullptr) {
    device.id = id;  // a device without a kind keeps an empty id, which marks it as unreadable
    device.kind = kind;
  }
  device.maxForce = node.number("max_force_n", 0.01, 1000.0);
  device.maxForceRate = node.number("max_force_rate_n_per_s", 0.1, 1e6);
  device.maxTorque = node.number("max_torque_nm", 0.001, 100.0, device.maxTorque);
  device.maxTorqueRate = node.number("max_torque_rate_nm_per_s", 0.01, 1e5, device.maxTorqueRate);
  device.maxVelocity = node.number("max_velocity", 1e-3, 1e6, device.kind->travel.fastest);
  device.isPassivityControlled = node.flag("passivity_control", false);
  return device;
}

Condition readCondition(
    const Node& node, ReferencedFiles& files, std::vector<SceneDataSource>& sources) {
  Condition condition;
  if (!node.isObjectWithOnlyKeys({"id", "title", "scene"})) return condition;
  condition.id = node.id("id");
  condition.title = node.text("title");
  if (const auto scene = node.requiredObject("scene")) {
    SceneSources own(files, sources, condition.id);
    readScene(*scene, own, condition);
  }
  return condition;
}

Labels readLabels(const Node& root) {
  Labels labels{.prefix = LocalizedText(std::map<std::string, std::string>{{"en", "Alternative"}})};
  const auto node = root.requiredObject("labels");
  if (!node || !node->isObjectWithOnlyKeys({"policy", "prefix"})) return labels;
  labels.policy = node->choice("policy", kPolicies);
  if (node->has("prefix")) labels.prefix = readLocalized(*node, "prefix");
  return labels;
}

/// Reads the laboratory's texts for blanks. Refuses a text that itself contains a blank, because
/// participants would read its brackets.
std::map<std::string, LocalizedText> readBlankTexts(const Node& node) {
  std::map<std::string, LocalizedText> texts;
  const questionnaires::TextReader reader({"en"});
  for (const auto& [key, value] : node.members()) {
    auto text = reader.read(value);
    if (!text.has("en")) {
      value.problem("", "the English text is missing", "add \"en\": every text falls back to it");
    }
    for (const auto& [language, words] : text.all()) {
      if (words.find("[[") == std::string::npos) continue;
      value.problem("", "this text has a blank itself", "write what is to be read in its place");
      break;
    }
    texts[key] = std::move(text);
  }
  return texts;
}

/// Fills in blanks in the protocol's own texts. Instruments are filled in when they are read.
void fillOwnTexts(Protocol& protocol, questionnaires::BlankFiller& blanks) {
  blanks.fill(protocol.labels.prefix);
  for (auto& phase : protocol.phases) blanks.fill(phase.text);
}

template <typename T, typename Read>
std::vector<T> readAll(const std::vector<Node>& nodes, Read read) {
  std::vector<T> all;
  for (const auto& node : nodes) all.push_back(read(node));
  return all;
}

Protocol readRoot(const Node& root, ReferencedFiles& files, std::vector<SceneDataSource>& sources) {
  Protocol protocol;
  requireSchema(root);
  if (const auto study = root.requiredObject("study")) protocol.study = readMetadata(*study);
  protocol.languages = readLanguages(root);
  if (root.has("seed")) {
    protocol.seed = static_cast<std::uint64_t>(root.wholeNumber("seed", 0, kMostExactWhole));
  }
  if (root.has("blinding")) protocol.isOpenLabel = root.choice("blinding", kBlindings);
  protocol.cohorts = readAll<Cohort>(root.requiredList("cohorts"), readCohort);
  protocol.devices = readAll<DeviceRequirement>(root.requiredList("devices"), readDevice);
  protocol.instrumentFiles = readFileNames(root);
  if (const auto texts = root.object("texts")) protocol.texts = readBlankTexts(*texts);
  protocol.conditions = readAll<Condition>(root.requiredList("conditions"), [&](const Node& node) {
    return readCondition(node, files, sources);
  });
  for (auto& device : protocol.devices) {
    device.needsTorque = std::ranges::any_of(protocol.conditions, [&](const auto& candidate) {
      return candidate.device == device.id && candidate.model &&
             haptics::engine::hasTorque(candidate.scene());
    });
  }
  protocol.labels = readLabels(root);
  protocol.phases = readAll<Phase>(root.requiredList("phases"), readPhase);
  if (const auto analysis = root.object("analysis")) protocol.analysis = readAnalysis(*analysis);
  if (const auto truth = root.object("simulation")) protocol.simulation = readSimulation(*truth);
  return protocol;
}

/// Reads the instrument file with index @p index in 'instrument_files'.
void addInstrument(
    UnvalidatedProtocol& draft,
    ReferencedFiles& files,
    std::size_t index,
    questionnaires::BlankFiller& blanks,
    Problems& problems) {
  auto& loaded = draft.loaded;
  const auto& name = loaded.protocol.instrumentFiles[index];
  const std::string path = "$.instrument_files[" + std::to_string(index) + "]";
  auto instrument = files.instrument(name, path, loaded.protocol.languages, blanks);
  if (!instrument) return;
  if (loaded.instrument(instrument->id) != nullptr) {
    problems.add(
        path,
        "'" + questionnaires::shown(name) + "' holds the instrument '" + instrument->id +
            "', and so does a file before it",
        "give each an id of its own");
  }
  loaded.instruments.push_back(std::move(*instrument));
}

/// Reads the instruments of 'instrument_files', and then the instruments of the library that the
/// protocol uses.
void addInstruments(
    UnvalidatedProtocol& draft,
    ReferencedFiles& files,
    questionnaires::BlankFiller& blanks,
    Problems& problems) {
  auto& loaded = draft.loaded;
  const auto& names = loaded.protocol.instrumentFiles;
  for (std::size_t i = 0; i < names.size(); ++i) {
    const auto end = names.begin() + static_cast<std::ptrdiff_t>(i);
    const bool isThere = std::find(names.begin(), end, names[i]) != end;
    if (!names[i].empty() && !isThere) addInstrument(draft, files, i, blanks, problems);
  }
  draft.hasAllInstruments = loaded.instruments.size() == names.size();
  for (const auto& use : instrumentUses(loaded.protocol)) {
    if (loaded.instrument(use.instrument) != nullptr) continue;
    auto found =
        files.libraryInstrument(use.instrument, use.path, loaded.protocol.languages, blanks);
    if (found) loaded.instruments.push_back(std::move(*found));
  }
}

/// Whether a list and all of its elements could be read. A list that was read is never empty; an
/// element that could not be read has no valid id.
template <typename T>
bool isComplete(const std::vector<T>& all) noexcept {
  return !all.empty() && std::ranges::all_of(all, [](const T& t) { return isValidId(t.id); });
}

/// Whether the file has another format, judged by its "format". Its unknown keys are then not
/// reported one by one.
bool isOfOtherFormat(const Node& root) {
  constexpr std::string_view kCut = "palpate-cut-";
  const auto format = root.isObject() ? root.member("format") : std::nullopt;
  if (!format || !format->isText()) return false;
  const auto name = format->asText();
  root.problem(
      "format",
      "this is a file of the format '" + questionnaires::shown(name) + "', not a protocol",
      name.starts_with(kCut) ? "open the protocol that has it as a condition's 'cut'"
                             : "open the protocol that names it");
  return true;
}

}  // namespace

bool UnvalidatedProtocol::lacksDevice(std::string_view id) const noexcept {
  const auto& protocol = loaded.protocol;
  return isValidId(id) && protocol.device(id) == nullptr && isComplete(protocol.devices);
}

bool UnvalidatedProtocol::lacksCondition(std::string_view id) const noexcept {
  const auto& protocol = loaded.protocol;
  return isValidId(id) && protocol.condition(id) == nullptr && isComplete(protocol.conditions);
}

bool UnvalidatedProtocol::lacksInstrument(std::string_view id) const noexcept {
  return isValidId(id) && loaded.instrument(id) == nullptr && hasAllInstruments;
}

bool UnvalidatedProtocol::hasAllPhases() const noexcept {
  return isComplete(loaded.protocol.phases);
}

std::optional<UnvalidatedProtocol> readUnvalidatedProtocol(
    std::string_view json,
    const FileFinder& find,
    Problems& problems,
    Defaults defaults,
    const FileFinder& copies) {
  const auto value = questionnaires::parseJson(json, problems);
  if (!value) return std::nullopt;
  const Node root(*value, "$", problems);
  if (isOfOtherFormat(root)) return std::nullopt;
  if (!root.isObjectWithOnlyKeys(
          {"$schema",
           "study",
           "languages",
           "seed",
           "blinding",
           "cohorts",
           "devices",
           "instrument_files",
           "texts",
           "conditions",
           "labels",
           "phases",
           "analysis",
           "simulation"})) {
    return std::nullopt;
  }
  ReferencedFiles files(find, copies, problems, defaults);
  UnvalidatedProtocol draft;
  draft.loaded.text = json;
  draft.loaded.defaults = defaults;
  draft.loaded.protocol = readRoot(root, files, draft.loaded.sources);
  questionnaires::BlankFiller blanks(draft.loaded.protocol.texts);
  fillOwnTexts(draft.loaded.protocol, blanks);
  addInstruments(draft, files, blanks, problems);
  draft.loaded.blanks = blanks.keys();
  draft.loaded.files = files.takeFiles();
  return draft;
}

}  // namespace protocols
