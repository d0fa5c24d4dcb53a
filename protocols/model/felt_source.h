#pragma once

#include <string>
#include <vector>

#include "base/message.h"

namespace protocols {

/// What conditions are felt from, or seen as, that stands in no protocol: a cut, a material, a bone
/// of spheres, a knee.
struct FeltSource {
  std::string kind;     ///< "cut", "material", "packing" or "anatomy"
  std::string file;     ///< as the protocol calls it; empty where it is built into the program
  base::Message title;  ///< for people
  std::vector<base::Message> origin;    ///< empty where the file says nothing
  bool isSynthetic = false;             ///< nobody recorded or measured it
  std::vector<std::string> conditions;  ///< by id
};

/// Its origin in English: "spheres in 'cup.msh', fitted to 'bone.json'".
std::string originInWords(const FeltSource& source);

/// "Bone of specimen 7 (material 'bone.json'), test set dynamic-1", and its mark.
std::string inWords(const FeltSource& source);

}  // namespace protocols
