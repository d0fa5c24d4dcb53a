#pragma once

#include <string>

#include "haptics/reaming/packing/packed_bone.h"
#include "protocols/reading/packing_file.h"

namespace CLI {
class App;
}

namespace study::app {

/// Which curves a bone is to feel like.
struct MaterialChoice {
  std::string file;  ///< or "parametric"
  std::string set = "dynamic-1";
};
void addMaterialOptions(CLI::App& verb, MaterialChoice& choice);

/// @throws UserError  in words, where the file is missing or no packing.
haptics::reaming::PackedBone readBone(const std::string& path, protocols::PackingOrigin& origin);

struct ChosenCurves {
  haptics::reaming::HardnessCurves curves;
  bool isSynthetic = false;  ///< nobody measured them
};

/// The curves, and into @p origin what they are called.
/// @throws UserError  in words, where the file is missing, no material, or has no such test set.
ChosenCurves curvesOf(const MaterialChoice& choice, protocols::PackingOrigin& origin);

}  // namespace study::app
