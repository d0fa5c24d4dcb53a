#pragma once

#include <string>
#include <vector>

namespace protocols {

/// What conditions are felt from, or seen as, that stands in no protocol: a cut, a material, a bone
/// of spheres, a knee.
struct FeltSource {
  std::string kind;          ///< "cut", "material", "packing" or "anatomy"
  std::string file;          ///< as the protocol calls it; empty where it is built into the program
  std::string title;         ///< for people
  std::string origin;        ///< in words; empty where the file says nothing
  bool isSynthetic = false;  ///< nobody recorded or measured it
  std::vector<std::string> conditions;  ///< by id
};

/// "Bone of specimen 7 (material 'bone.json'), test set dynamic-1", and its mark.
std::string inWords(const FeltSource& source);

}  // namespace protocols
