#include "protocols/reading/referenced_files.h"

#include <algorithm>
#include <filesystem>
#include <utility>

#include "base/joined.h"
#include "haptics/engine/built_in_models.h"
#include "protocols/model/messages.h"
#include "protocols/reading/cut_file.h"
#include "protocols/reading/material_file.h"
#include "questionnaires/json/document.h"
#include "questionnaires/reading/instrument_file.h"
#include "questionnaires/reading/wording.h"

namespace protocols {
namespace {

using questionnaires::Instrument;
using questionnaires::Problems;
using questionnaires::shown;

bool isOutsideFolder(const std::string& name) {
  const std::filesystem::path path(name);
  return path.is_absolute() || std::ranges::find(path, "..") != path.end();
}

std::optional<std::string> textInLibrary(const std::string& id) {
  if (id.ends_with(".schema")) return std::nullopt;  // a schema is no instrument
  for (const auto& file : questionnaires::libraryFiles()) {
    if (file.name == id + ".json") return std::string(file.content);
  }
  return std::nullopt;
}

}  // namespace

/// Reads a file when it is first needed, so that its problems are reported once for all conditions
/// that refer to it. A missing file is reported at every place that refers to it.
template <typename T, typename Read>
const T* ReferencedFiles::readOnce(
    ByName<T>& known,
    const std::string& name,
    const std::string& path,
    const Read& read,
    const FileExtension& extension) {
  if (name.empty()) return nullptr;
  auto file = known.find(name);
  if (file == known.end()) {
    const auto text = textOf(name, path);
    if (!text) return nullptr;
    if (!name.ends_with(extension.extension)) {
      problems_.add(
          path,
          "'" + shown(name) + "' does not end in '" + std::string(extension.extension) + "'",
          std::string(extension.fix));
      return nullptr;
    }
    Problems inFile;
    file = known.emplace(name, read(*text, inFile)).first;
    addProblemsOf(inFile, name);
  }
  return file->second ? &*file->second : nullptr;
}

const haptics::recordings::Cut* ReferencedFiles::cut(
    const std::string& name, const std::string& path) {
  return readOnce(cuts_, name, path, readCut);
}

const haptics::reaming::Material* ReferencedFiles::material(
    const std::string& name, const std::string& path) {
  return readOnce(materials_, name, path, readMaterial);
}

const ReferencedFiles::PackingFile* ReferencedFiles::packing(
    const std::string& name, const std::string& path) {
  const auto read = [](const std::string& text, Problems& problems) {
    std::optional<PackingFile> file;
    PackingOrigin origin;
    if (auto bone = readPacking(text, problems, &origin)) {
      using haptics::reaming::PackedBone;
      file = {std::make_shared<const PackedBone>(std::move(*bone)), std::move(origin)};
    }
    return file;
  };
  return readOnce(
      packings_,
      name,
      path,
      read,
      {kPackingExtension, "name a file that 'palpate packing' has written"});
}

std::shared_ptr<const Anatomy> ReferencedFiles::anatomy(
    const std::string& name, const std::string& path) {
  const auto read = [](const std::string& text, Problems& problems) {
    std::optional<std::shared_ptr<const Anatomy>> file;
    if (auto anatomy = readAnatomy(text, problems)) {
      file = std::make_shared<const Anatomy>(std::move(*anatomy));
    }
    return file;
  };
  const auto* file = readOnce(
      anatomies_,
      name,
      path,
      read,
      {kAnatomyExtension, "save the anatomy as OBJ, and name that file"});
  return file == nullptr ? nullptr : *file;
}

std::optional<Instrument> ReferencedFiles::instrument(
    const std::string& name,
    const std::string& path,
    const std::vector<std::string>& languages,
    questionnaires::BlankFiller& blanks) {
  const auto text = textOf(name, path);
  if (!text) return std::nullopt;
  Problems inFile;
  auto instrument = questionnaires::readInstrument(*text, inFile, &blanks);
  addProblemsOf(inFile, name);
  if (!instrument) return std::nullopt;
  completeWording(*instrument, path, languages);
  blanks.fill(*instrument);  // including blanks in the wording files
  return instrument;
}

std::optional<Instrument> ReferencedFiles::libraryInstrument(
    const std::string& id,
    const std::string& path,
    const std::vector<std::string>& languages,
    questionnaires::BlankFiller& blanks) {
  const std::string name = std::string(kLibraryCopyPrefix) + id + ".json";
  auto text = copies_ ? copies_(name) : std::nullopt;
  if (!text) text = textInLibrary(id);
  if (!text) return std::nullopt;
  Problems inFile;
  auto instrument = questionnaires::readInstrument(*text, inFile);
  files_.push_back({name, std::move(*text)});
  if (!instrument) {
    addProblemsOf(inFile, name);
    return std::nullopt;
  }
  completeWording(*instrument, path, languages);
  blanks.fill(*instrument);
  return instrument;
}

void ReferencedFiles::addProblemsOf(const Problems& found, const std::string& file) {
  for (auto problem : found.all()) {
    problem.path = shown(file) + " " + problem.path;
    problems_.add(std::move(problem));
  }
}

/// Adds the text of a wording file if the file exists; the file then becomes part of the protocol.
void ReferencedFiles::completeWording(
    Instrument& instrument, const std::string& path, const std::vector<std::string>& languages) {
  const auto findWording = [&](const std::string& name) {
    auto text = find(name, path, false);
    if (text) files_.push_back({name, *text});
    return text;
  };
  questionnaires::completeWording(instrument, languages, findWording, path, problems_);
}

std::optional<std::string> ReferencedFiles::textOf(
    const std::string& name, const std::string& path) {
  const auto known =
      std::ranges::find_if(files_, [&](const auto& file) { return file.name == name; });
  if (known != files_.end()) return known->text;
  if (isOutsideFolder(name)) {
    problems_.add(
        path,
        "'" + shown(name) + "' lies outside the protocol's folder",
        "copy the file beside the protocol and name it without a folder above");
    return std::nullopt;
  }
  auto text = find(name, path, true);
  if (text) files_.push_back({name, *text});
  return text;
}

/// The text of a file. A missing file is reported only if @p isNeeded; an unreadable file is always
/// reported.
std::optional<std::string> ReferencedFiles::find(
    const std::string& name, const std::string& path, bool isNeeded) {
  try {
    auto text = find_(name);
    if (text || !isNeeded) return text;
    problems_.add(
        path,
        "there is no file '" + shown(name) + "'",
        "put it beside the protocol, or correct the name");
  } catch (const base::UserError& error) {
    problems_.add(path, "the file '" + shown(name) + "' cannot be read", error.what());
  }
  return std::nullopt;
}

namespace {

using base::Message;
using haptics::recordings::Cut;

/// The travel over which the force of the parametric cut falls to zero [travel units]; the same
/// travel as for 'ramp-out'.
constexpr double kParametricRelease = 1.5;

std::vector<Message> originOf(const haptics::recordings::Provenance& provenance) {
  std::vector<Message> origin;
  if (!provenance.statement.empty()) origin.push_back(Message::verbatim(provenance.statement));
  if (!provenance.sourceFile.empty()) {
    origin.push_back(message("source.recorded_in", provenance.sourceFile));
  }
  const auto changes = base::joined(provenance.changes, "; ");
  if (!changes.empty()) origin.push_back(message("source.changed", changes));
  return origin;
}

std::vector<Message> originOf(const PackingOrigin& packing) {
  std::vector<Message> origin;
  if (!packing.mesh.empty()) origin.push_back(message("source.spheres_in", packing.mesh));
  if (!packing.material.empty()) origin.push_back(message("source.fitted_to", packing.material));
  return origin;
}

Message titleOf(const std::string& surface) {
  if (surface == kTibia) return message("source.tibia");
  if (surface == kFemur) return message("source.femur");
  if (surface == kCapsule) return message("source.capsule");
  return Message::verbatim(surface);
}

std::vector<Message> surfaceTitlesOf(const Anatomy& anatomy) {
  std::vector<Message> titles;
  for (const auto& surface : anatomy.surfaces) titles.push_back(titleOf(surface.name));
  return titles;
}

}  // namespace

const Cut* SceneSources::cut(const std::string& name, const std::string& path) {
  if (name == kParametricCut) {
    static const Cut whole = haptics::recordings::parametricCut({.release = kParametricRelease});
    static const Cut ofRelease01 = haptics::recordings::parametricCut();
    const Cut& own = defaults() == Defaults::Release01 ? ofRelease01 : whole;
    add("cut",
        {},
        message("source.parametric_cut"),
        {message("source.parametric")},
        own.isSynthetic);
    return &own;
  }
  const auto* cut = files_.cut(name, path);
  if (cut != nullptr) {
    add("cut", name, Message::verbatim(cut->title), originOf(cut->provenance), cut->isSynthetic);
  }
  return cut;
}

SceneSources::MaterialChoice SceneSources::material(
    const std::string& name, haptics::reaming::TestSet set, const std::string& path) {
  const auto* material = files_.material(name, path);
  if (material == nullptr) return {};
  const auto* curves = material->find(set);
  if (curves != nullptr) {
    add("material",
        name,
        Message::verbatim(material->title),
        {message("source.test_set", nameOf(set))},
        material->isSynthetic);
  }
  return {material, curves};
}

std::shared_ptr<const haptics::reaming::PackedBone> SceneSources::packing(
    const std::string& name, const std::string& path) {
  if (name == kParametricBone) {
    auto own = haptics::engine::parametricBone();
    add("packing", {}, message("source.parametric_bone"), {}, own->isSynthetic);
    return own;
  }
  const auto* packing = files_.packing(name, path);
  if (packing == nullptr) return nullptr;
  add("packing",
      name,
      Message::verbatim(packing->bone->title),
      originOf(packing->origin),
      packing->bone->isSynthetic);
  return packing->bone;
}

void SceneSources::addParametricMaterial() {
  add("material", {}, message("source.parametric_material"), {}, true);
}

std::shared_ptr<const Anatomy> SceneSources::anatomy(
    const std::string& name, const std::string& path) {
  auto knee = files_.anatomy(name, path);
  if (knee) {
    add("anatomy", name, message("source.knee"), surfaceTitlesOf(*knee), false);
  }
  return knee;
}

/// Adds the condition to the conditions of a source in the list. If the source is not in the list
/// yet, adds it first.
void SceneSources::add(
    const char* kind,
    const std::string& file,
    Message title,
    std::vector<Message> origin,
    bool isSynthetic) {
  auto known = std::ranges::find_if(all_, [&](const auto& other) {
    return other.kind == kind && other.file == file && other.origin == origin;
  });
  if (known == all_.end()) {
    known = all_.insert(
        known, {kind, file, std::move(title), std::move(origin), isSynthetic, /*conditions=*/{}});
  }
  known->conditions.push_back(condition_);
}

}  // namespace protocols
