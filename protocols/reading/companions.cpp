#include "protocols/reading/companions.h"

#include <algorithm>
#include <filesystem>
#include <utility>

#include "haptics/engine/built_in_models.h"
#include "haptics/recordings/cut.h"
#include "haptics/recordings/force_curve.h"
#include "protocols/model/messages.h"
#include "protocols/model/protocol.h"
#include "protocols/reading/cut_file.h"
#include "protocols/reading/material_file.h"
#include "protocols/reading/packing_file.h"
#include "questionnaires/json/document.h"
#include "questionnaires/model/library.h"
#include "questionnaires/reading/instrument_file.h"
#include "questionnaires/reading/wording.h"

namespace protocols {
namespace {

using base::Message;
using questionnaires::Problems;
using questionnaires::shown;

std::vector<Message> originOf(const haptics::recordings::Provenance& provenance) {
  std::vector<Message> origin;
  if (!provenance.statement.empty()) origin.push_back(Message::verbatim(provenance.statement));
  if (!provenance.sourceFile.empty()) {
    origin.push_back(message("source.recorded_in", provenance.sourceFile));
  }
  return origin;
}

std::vector<Message> originOf(const PackingOrigin& packing) {
  std::vector<Message> origin;
  if (!packing.mesh.empty()) origin.push_back(message("source.spheres_in", packing.mesh));
  if (!packing.material.empty()) origin.push_back(message("source.fitted_to", packing.material));
  return origin;
}

bool leavesItsFolder(const std::string& name) {
  const std::filesystem::path path(name);
  return path.is_absolute() || std::find(path.begin(), path.end(), "..") != path.end();
}

}  // namespace

void Companions::passOn(const Problems& found, const std::string& file, Problems& problems) {
  for (auto problem : found.all()) {
    problem.path = shown(file) + " " + problem.path;
    problems.add(std::move(problem));
  }
}

void Companions::readInstruments() {
  const auto& names = draft_.loaded.protocol.instrumentFiles;
  for (std::size_t i = 0; i < names.size(); ++i) {
    const auto end = names.begin() + static_cast<std::ptrdiff_t>(i);
    const bool isThere = std::find(names.begin(), end, names[i]) != end;
    if (!names[i].empty() && !isThere) readInstrument(i);
  }
  draft_.hasAllInstruments = draft_.loaded.instruments.size() == names.size();
  addLibraryInstruments();
}

void Companions::readInstrument(std::size_t index) {
  const auto& name = draft_.loaded.protocol.instrumentFiles[index];
  const std::string path = "$.instrument_files[" + std::to_string(index) + "]";
  const auto text = textOf(name, path);
  if (!text) return;
  Problems inFile;
  auto instrument = questionnaires::readInstrument(*text, inFile);
  passOn(inFile, name, problems_);
  if (!instrument) return;
  if (draft_.loaded.instrument(instrument->id) != nullptr) {
    problems_.add(
        path,
        "'" + shown(name) + "' holds the instrument '" + instrument->id +
            "', and so does a file before it",
        "give each an id of its own");
  }
  addWording(*instrument, path);
  draft_.loaded.instruments.push_back(std::move(*instrument));
}

void Companions::addWording(questionnaires::Instrument& instrument, const std::string& path) {
  const auto find = [&](const std::string& name) { return textIfThere(name, path); };
  questionnaires::completeWording(
      instrument, draft_.loaded.protocol.languages, find, path, problems_);
}

void Companions::addLibraryInstruments() {
  for (const auto& use : instrumentUses(draft_.loaded.protocol)) {
    const auto& id = use.instrument;
    const bool isSchema = id.ends_with(".schema");  // lies in the library, and is no instrument
    if (isSchema || draft_.loaded.instrument(id) != nullptr) continue;
    for (const auto& file : questionnaires::libraryFiles()) {
      if (file.name != id + ".json") continue;
      auto instrument = questionnaires::readSoundInstrument(file.content, id);
      addWording(instrument, use.path);
      draft_.loaded.instruments.push_back(std::move(instrument));
    }
  }
}

void Companions::tellSource(FeltSource source, const Condition& condition) {
  auto& all = draft_.loaded.sources;
  auto known = std::find_if(all.begin(), all.end(), [&](const auto& other) {
    return other.kind == source.kind && other.file == source.file && other.origin == source.origin;
  });
  if (known == all.end()) known = all.insert(all.end(), std::move(source));
  known->conditions.push_back(condition.id);
}

void Companions::readMaterial(Condition& condition) {
  if (condition.hasOwnMaterial) {
    tellSource(
        {.kind = "material",
         .file = {},
         .title = message("source.parametric_material"),
         .origin = {},
         .isSynthetic = true,
         .conditions = {}},
        condition);
  }
  if (!condition.material || condition.material->name.empty()) return;
  const auto& reference = *condition.material;
  const auto text = textOf(reference.name, reference.path);
  if (!text) return;
  Problems inFile;
  const auto material = protocols::readMaterial(*text, inFile);
  passOn(inFile, reference.name, problems_);
  if (!material) return;
  const auto* set = material->find(reference.set);
  if (set == nullptr) {
    problems_.add(
        reference.path,
        "'" + shown(reference.name) + "' has no test set '" + std::string(nameOf(reference.set)) +
            "'",
        "choose another 'test_set'");
    return;
  }
  auto spec = *haptics::engine::partsOf(condition.scene.model).material;
  spec.curves = set->force;
  spec.isMeasured = !material->isSynthetic;
  if (reference.hasJitter) spec.jitter = set->jitter;
  condition.scene.model = std::move(spec);
  tellSource(
      {.kind = "material",
       .file = reference.name,
       .title = Message::verbatim(material->title),
       .origin = {message("source.test_set", nameOf(reference.set))},
       .isSynthetic = material->isSynthetic,
       .conditions = {}},
      condition);
}

void Companions::readPacking(Condition& condition) {
  if (!condition.packing || condition.packing->name.empty()) return;
  const auto packing = packingOf(*condition.packing);
  if (!packing.bone) return;
  auto spec = *haptics::engine::partsOf(condition.scene.model).packing;
  spec.bone = packing.bone;
  const auto* device = draft_.loaded.protocol.device(condition.device);
  if (device != nullptr) spec.mostTravel = device->kind->travel.most;
  condition.scene.model = std::move(spec);
  const bool isOwn = condition.packing->name == kParametricBone;
  tellSource(
      {.kind = "packing",
       .file = isOwn ? std::string() : condition.packing->name,
       .title = isOwn ? message("source.parametric_bone") : Message::verbatim(packing.bone->title),
       .origin = packing.origin,
       .isSynthetic = packing.bone->isSynthetic,
       .conditions = {}},
      condition);
}

Companions::PackingFile Companions::packingOf(const PackingReference& reference) {
  if (reference.name == kParametricBone) return {haptics::engine::parametricBone(), {}};
  const auto known = packings_.find(reference.name);
  if (known != packings_.end()) return known->second;
  const auto text = textOf(reference.name, reference.path);
  if (!text) return {};
  if (!reference.name.ends_with(kPackingEnding)) {
    problems_.add(
        reference.path,
        "'" + shown(reference.name) + "' does not end in '.packing'",
        "name a file that 'palpate packing' has written");
    return {};
  }
  Problems inFile;
  PackingOrigin origin;
  auto bone = protocols::readPacking(*text, inFile, &origin);
  passOn(inFile, reference.name, problems_);
  PackingFile file;
  if (bone) {
    file.bone = std::make_shared<const haptics::reaming::PackedBone>(std::move(*bone));
    file.origin = originOf(origin);
  }
  return packings_.emplace(reference.name, std::move(file)).first->second;
}

void Companions::readCut(Condition& condition) {
  if (!condition.cut || condition.cut->name.empty()) return;
  const auto cut = cutOf(*condition.cut);
  if (!cut) return;
  const auto parts = haptics::engine::partsOf(condition.scene.model);
  if (parts.cut == nullptr) return;
  auto recorded = *parts.cut;
  fill(recorded, *cut);
  if (parts.filter != nullptr) {
    auto filter = *parts.filter;
    filter.interpolation = std::move(recorded);
    condition.scene.model = std::move(filter);
  } else {
    condition.scene.model = std::move(recorded);
  }
  const bool isOwn = condition.cut->name == kParametricCut;
  tellSource(
      {.kind = "cut",
       .file = isOwn ? std::string() : condition.cut->name,
       .title = isOwn ? message("source.parametric_cut") : Message::verbatim(cut->title),
       .origin = isOwn ? std::vector{message("source.parametric")} : originOf(cut->provenance),
       .isSynthetic = cut->isSynthetic,
       .conditions = {}},
      condition);
}

/// The branches that are felt, no steeper than the protocol asks for.
void Companions::fill(
    haptics::engine::InterpolationSpec& spec, const haptics::recordings::Cut& cut) {
  const auto curveOf = [&](const haptics::recordings::ForceCurve& recorded) {
    return nodesOf(
        spec.slopeLimit ? haptics::recordings::limitSlope(recorded, *spec.slopeLimit).curve
                        : recorded);
  };
  spec.curve = curveOf(cut.curve);
  const bool isBothWays = spec.branches == haptics::engine::Branches::Hysteresis;
  if (isBothWays && cut.opening) spec.opening = curveOf(*cut.opening);
}

Companions::CutFile Companions::cutOf(const CutReference& reference) {
  if (reference.name == kParametricCut) return haptics::recordings::parametricCut();
  const auto known = cuts_.find(reference.name);
  if (known != cuts_.end()) return known->second;
  const auto text = textOf(reference.name, reference.path);
  if (!text) return std::nullopt;
  Problems inFile;
  auto cut = protocols::readCut(*text, inFile);
  passOn(inFile, reference.name, problems_);
  return cuts_.emplace(reference.name, std::move(cut)).first->second;
}

std::optional<std::string> Companions::textOf(const std::string& name, const std::string& path) {
  auto& files = draft_.loaded.files;
  const auto known =
      std::find_if(files.begin(), files.end(), [&](const auto& file) { return file.name == name; });
  if (known != files.end()) return known->text;
  if (leavesItsFolder(name)) {
    problems_.add(
        path,
        "'" + shown(name) + "' lies outside the protocol's folder",
        "copy the file beside the protocol and name it without a folder above");
    return std::nullopt;
  }
  auto text = found(name, path);
  if (text) files.push_back({name, *text});
  return text;
}

std::optional<std::string> Companions::found(const std::string& name, const std::string& path) {
  try {
    auto text = find_(name);
    if (text) return text;
    problems_.add(
        path,
        "there is no file '" + shown(name) + "'",
        "put it beside the protocol, or correct the name");
  } catch (const questionnaires::Error& error) {
    problems_.add(path, "the file '" + shown(name) + "' cannot be read", error.what());
  }
  return std::nullopt;
}

/// A file that may be away: it becomes part of the protocol where it is there.
std::optional<std::string> Companions::textIfThere(
    const std::string& name, const std::string& path) {
  try {
    auto text = find_(name);
    if (text) draft_.loaded.files.push_back({name, *text});
    return text;
  } catch (const questionnaires::Error& error) {
    problems_.add(path, "the file '" + shown(name) + "' cannot be read", error.what());
    return std::nullopt;
  }
}

}  // namespace protocols
