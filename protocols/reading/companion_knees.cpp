#include "protocols/model/messages.h"
#include "protocols/reading/anatomy_file.h"
#include "protocols/reading/companions.h"
#include "questionnaires/json/document.h"

namespace protocols {
namespace {

using questionnaires::Problems;
using questionnaires::shown;

base::Message nameOf(const std::string& surface) {
  if (surface == "tibia") return message("source.tibia");
  if (surface == "femur") return message("source.femur");
  if (surface == "capsule") return message("source.capsule");
  return base::Message::verbatim(surface);
}

std::vector<base::Message> surfacesIn(const Anatomy& knee) {
  std::vector<base::Message> names;
  for (const auto& surface : knee.surfaces) names.push_back(nameOf(surface.name));
  return names;
}

}  // namespace

void Companions::readAnatomy(Condition& condition) {
  if (!condition.anatomy || condition.anatomy->name.empty()) return;
  condition.knee = kneeOf(*condition.anatomy);
  if (!condition.knee) return;
  tellSource(
      {.kind = "anatomy",
       .file = condition.anatomy->name,
       .title = message("source.knee"),
       .origin = surfacesIn(*condition.knee),
       .isSynthetic = false,
       .conditions = {}},
      condition);
}

Companions::Knee Companions::kneeOf(const AnatomyReference& reference) {
  const auto known = knees_.find(reference.name);
  if (known != knees_.end()) return known->second;
  const auto text = textOf(reference.name, reference.path);
  if (!text) return nullptr;
  if (!reference.name.ends_with(kAnatomyEnding)) {
    problems_.add(
        reference.path,
        "'" + shown(reference.name) + "' does not end in '.obj'",
        "save the anatomy as OBJ, and name that file");
    return nullptr;
  }
  Problems inFile;
  auto anatomy = protocols::readAnatomy(*text, inFile);
  passOn(inFile, reference.name, problems_);
  Knee knee;
  if (anatomy) knee = std::make_shared<const Anatomy>(std::move(*anatomy));
  return knees_.emplace(reference.name, std::move(knee)).first->second;
}

}  // namespace protocols
