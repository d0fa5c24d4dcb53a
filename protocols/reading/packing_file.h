#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "haptics/reaming/packing/packed_bone.h"
#include "questionnaires/json/problem.h"

namespace protocols {

/// A packing may be larger than what a researcher writes.
inline constexpr std::size_t kLargestPacking = 500'000'000;  ///< [bytes]

/// How files with packings end.
inline constexpr std::string_view kPackingEnding = ".packing";

/// Where a packing came from, for people; kept with it.
struct PackingOrigin {
  std::string mesh;      ///< its file's name without the folder, or "parametric acetabulum"
  std::string sha256;    ///< of that file; empty where there is none
  std::string material;  ///< that it was fitted to, with its test set; empty before
  std::uint64_t seed = 1;
};

/// A packing as `palpate packing` writes it (docs/protocol-format.md, "Packing files"), and
/// everything that is wrong with it; nothing where there are errors.
///
/// Without densities the spheres have none: it has been built and not been fitted.
std::optional<haptics::reaming::PackedBone> readPacking(
    std::string_view text, questionnaires::Problems& problems, PackingOrigin* origin = nullptr);

/// A line of JSON about it, then a line for each sphere: so many hexadecimal digits for each of its
/// numbers in single precision, so that it reads back exactly.
std::string packingAsText(const haptics::reaming::PackedBone& bone, const PackingOrigin& origin);

}  // namespace protocols
