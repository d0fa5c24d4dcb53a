#include "protocols/reading/scene_sources.h"

#include <algorithm>
#include <utility>

#include "haptics/engine/built_in_models.h"
#include "protocols/model/messages.h"
#include "protocols/reading/material_file.h"

namespace protocols {
namespace {

using base::Message;
using haptics::recordings::Cut;

/// Over which the force of our own cut falls to nothing [travel units]: as far as 'ramp-out' takes.
constexpr double kRelease = 1.5;

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

Message titleOf(const std::string& surface) {
  if (surface == kTibia) return message("source.tibia");
  if (surface == kFemur) return message("source.femur");
  if (surface == kCapsule) return message("source.capsule");
  return Message::verbatim(surface);
}

std::vector<Message> surfacesIn(const Anatomy& knee) {
  std::vector<Message> titles;
  for (const auto& surface : knee.surfaces) titles.push_back(titleOf(surface.name));
  return titles;
}

}  // namespace

const Cut* SceneSources::cut(const std::string& name, const std::string& path) {
  if (name == kParametricCut) {
    static const Cut whole = haptics::recordings::parametricCut({.release = kRelease});
    static const Cut ofRelease01 = haptics::recordings::parametricCut();
    const Cut& own = defaults() == Defaults::Release01 ? ofRelease01 : whole;
    add(
        {.kind = "cut",
         .file = {},
         .title = message("source.parametric_cut"),
         .origin = {message("source.parametric")},
         .isSynthetic = own.isSynthetic,
         .conditions = {}});
    return &own;
  }
  const auto* cut = files_.cut(name, path);
  if (cut != nullptr) {
    add(
        {.kind = "cut",
         .file = name,
         .title = Message::verbatim(cut->title),
         .origin = originOf(cut->provenance),
         .isSynthetic = cut->isSynthetic,
         .conditions = {}});
  }
  return cut;
}

SceneSources::MaterialChoice SceneSources::material(
    const std::string& name, haptics::reaming::TestSet set, const std::string& path) {
  const auto* material = files_.material(name, path);
  if (material == nullptr) return {};
  const auto* curves = material->find(set);
  if (curves != nullptr) {
    add(
        {.kind = "material",
         .file = name,
         .title = Message::verbatim(material->title),
         .origin = {message("source.test_set", nameOf(set))},
         .isSynthetic = material->isSynthetic,
         .conditions = {}});
  }
  return {material, curves};
}

std::shared_ptr<const haptics::reaming::PackedBone> SceneSources::packing(
    const std::string& name, const std::string& path) {
  if (name == kParametricBone) {
    auto own = haptics::engine::parametricBone();
    add(
        {.kind = "packing",
         .file = {},
         .title = message("source.parametric_bone"),
         .origin = {},
         .isSynthetic = own->isSynthetic,
         .conditions = {}});
    return own;
  }
  const auto* packing = files_.packing(name, path);
  if (packing == nullptr) return nullptr;
  add(
      {.kind = "packing",
       .file = name,
       .title = Message::verbatim(packing->bone->title),
       .origin = originOf(packing->origin),
       .isSynthetic = packing->bone->isSynthetic,
       .conditions = {}});
  return packing->bone;
}

void SceneSources::useParametricMaterial() {
  add(
      {.kind = "material",
       .file = {},
       .title = message("source.parametric_material"),
       .origin = {},
       .isSynthetic = true,
       .conditions = {}});
}

std::shared_ptr<const Anatomy> SceneSources::anatomy(
    const std::string& name, const std::string& path) {
  auto knee = files_.anatomy(name, path);
  if (knee) {
    add(
        {.kind = "anatomy",
         .file = name,
         .title = message("source.knee"),
         .origin = surfacesIn(*knee),
         .isSynthetic = false,
         .conditions = {}});
  }
  return knee;
}

/// Lists a source that several conditions share once.
void SceneSources::add(FeltSource source) {
  auto known = std::find_if(all_.begin(), all_.end(), [&](const auto& other) {
    return other.kind == source.kind && other.file == source.file && other.origin == source.origin;
  });
  if (known == all_.end()) known = all_.insert(all_.end(), std::move(source));
  known->conditions.push_back(condition_);
}

}  // namespace protocols
