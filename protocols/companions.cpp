#include "protocols/companions.h"

#include <algorithm>
#include <filesystem>
#include <utility>

#include "haptics/engine/parametric_bone.h"
#include "haptics/recordings/parametric_cut.h"
#include "haptics/recordings/slope_limit.h"
#include "protocols/cut_file.h"
#include "protocols/instrument_use.h"
#include "protocols/material_file.h"
#include "protocols/packing_file.h"
#include "questionnaires/document.h"
#include "questionnaires/instrument_file.h"
#include "questionnaires/library.h"

namespace protocols {
namespace {

using questionnaires::Problems;
using questionnaires::shown;

/// Passes on what was found in another file, with that file's name before the path.
void passOn(const Problems& found, const std::string& file, Problems& problems) {
  for (const auto& problem : found.all()) {
    const std::string path = shown(file) + " " + problem.path;
    if (problem.severity == questionnaires::Severity::Error) {
      problems.add(path, problem.what, problem.fix);
    } else {
      problems.warn(path, problem.what, problem.fix);
    }
  }
}

bool leavesItsFolder(const std::string& name) {
  const std::filesystem::path path(name);
  return path.is_absolute() || std::find(path.begin(), path.end(), "..") != path.end();
}

}  // namespace

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
  draft_.loaded.instruments.push_back(std::move(*instrument));
}

void Companions::addLibraryInstruments() {
  for (const auto& use : instrumentUses(draft_.loaded.protocol)) {
    const auto& id = use.instrument;
    const bool isSchema = id.ends_with(".schema");  // lies in the library, and is no instrument
    if (isSchema || draft_.loaded.instrument(id) != nullptr) continue;
    for (const auto& file : questionnaires::libraryFiles()) {
      if (file.name != id + ".json") continue;
      draft_.loaded.instruments.push_back(questionnaires::readSoundInstrument(file.content, id));
    }
  }
}

void Companions::readMaterial(Condition& condition) {
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
  auto& spec = std::get<haptics::engine::MaterialSpec>(condition.scene.model);
  spec.curves = set->force;
  if (reference.hasJitter) spec.jitter = set->jitter;
}

void Companions::readPacking(Condition& condition) {
  if (!condition.packing || condition.packing->name.empty()) return;
  auto& spec = std::get<haptics::engine::PackingSpec>(condition.scene.model);
  spec.bone = packingOf(*condition.packing);
}

Companions::PackingFile Companions::packingOf(const PackingReference& reference) {
  if (reference.name == kParametricBone) return haptics::engine::parametricBone();
  const auto known = packings_.find(reference.name);
  if (known != packings_.end()) return known->second;
  const auto text = textOf(reference.name, reference.path);
  if (!text) return nullptr;
  if (!reference.name.ends_with(kPackingEnding)) {
    problems_.add(
        reference.path,
        "'" + shown(reference.name) + "' does not end in '.packing'",
        "name a file that 'palpate packing' has written");
    return nullptr;
  }
  Problems inFile;
  auto bone = protocols::readPacking(*text, inFile);
  passOn(inFile, reference.name, problems_);
  auto shared =
      bone ? std::make_shared<const haptics::reaming::PackedBone>(std::move(*bone)) : PackingFile();
  return packings_.emplace(reference.name, std::move(shared)).first->second;
}

void Companions::readCut(Condition& condition) {
  if (!condition.cut || condition.cut->name.empty()) return;
  const auto cut = cutOf(*condition.cut);
  if (!cut) return;
  auto& model = condition.scene.model;
  auto* spec = std::get_if<haptics::engine::InterpolationSpec>(&model);
  auto* kalman = std::get_if<haptics::engine::KalmanSpec>(&model);
  if (kalman != nullptr) spec = &kalman->interpolation;
  if (spec == nullptr) return;
  fill(*spec, *cut);
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

}  // namespace protocols
