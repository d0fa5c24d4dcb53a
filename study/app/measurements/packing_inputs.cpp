#include "study/app/measurements/packing_inputs.h"

#include <CLI/CLI.hpp>

#include "haptics/engine/built_in_models.h"
#include "protocols/reading/material_file.h"
#include "questionnaires/json/document.h"
#include "study/model/user_error.h"

namespace study::app {

namespace reaming = haptics::reaming;

void addMaterialOptions(CLI::App& verb, MaterialChoice& choice) {
  verb.add_option("--material", choice.file, "Material file, or parametric (the built-in material)")
      ->required();
  verb.add_option("--test-set", choice.set, "Test set of the material")
      ->check(CLI::IsMember({"static", "dynamic-1", "dynamic-2"}))
      ->capture_default_str();
}

reaming::PackedBone readBone(const std::string& path, protocols::PackingOrigin& origin) {
  if (!path.ends_with(protocols::kPackingEnding)) {
    throw UserError(
        "'" + path +
        "' does not end in '.packing': spheres are wanted here, as 'palpate packing build' writes "
        "them. A material goes after --material.");
  }
  questionnaires::Problems problems;
  auto bone = protocols::readPacking(
      questionnaires::readTextFile(path, protocols::kLargestPacking), problems, &origin);
  if (!bone) throw UserError(path + ":\n" + questionnaires::describe(problems.all()));
  return std::move(*bone);
}

ChosenCurves curvesOf(const MaterialChoice& choice, protocols::PackingOrigin& origin) {
  if (choice.file == "parametric") {
    origin.material = "parametric";
    return {haptics::engine::parametricCurves(), haptics::engine::parametricTorque(), true};
  }
  if (choice.file.ends_with(protocols::kPackingEnding)) {
    throw UserError(
        "'" + choice.file +
        "' holds spheres; --material wants a material, as 'palpate material fit' writes it "
        "(MATERIAL.json).");
  }
  questionnaires::Problems problems;
  const auto material =
      protocols::readMaterial(questionnaires::readTextFile(choice.file), problems);
  if (!material) {
    throw UserError(choice.file + ":\n" + questionnaires::describe(problems.all()));
  }
  for (const auto& set : material->sets) {
    if (nameOf(set.set) != choice.set) continue;
    origin.material = material->name + ", " + choice.set;
    return {set.force, set.torque, material->isSynthetic};
  }
  throw UserError("'" + choice.file + "' has no test set '" + choice.set + "'.");
}

}  // namespace study::app
