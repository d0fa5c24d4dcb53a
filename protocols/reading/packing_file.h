#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "haptics/reaming/packing/packed_bone.h"
#include "questionnaires/json/problem.h"

namespace protocols {

/// Packings may be larger than other files.
inline constexpr std::size_t kLargestPacking = 500'000'000;  ///< [bytes]

/// The extension of files with packings.
inline constexpr std::string_view kPackingEnding = ".packing";

/// The origin of a packing, for readers; stored with it.
struct PackingOrigin {
  std::string mesh;      ///< file name without the folder, or "parametric acetabulum"
  std::string sha256;    ///< hash of that file in hexadecimal; empty if there is none
  std::string material;  ///< the material that the packing was fitted to, with its test set; empty
                         ///< if not fitted
  std::uint64_t seed = 1;
};

/// Reads a packing as `palpate packing` writes it (docs/protocol-format.md, "Packing files"), and
/// reports all problems; std::nullopt if there are errors.
///
/// A packing that has been built but not fitted has no densities.
std::optional<haptics::reaming::PackedBone> readPacking(
    std::string_view text, questionnaires::Problems& problems, PackingOrigin* origin = nullptr);

/// The text of a packing file: a line of JSON, then a line for each sphere with its numbers in
/// single precision as hexadecimal digits, which read back exactly.
std::string packingAsText(const haptics::reaming::PackedBone& bone, const PackingOrigin& origin);

}  // namespace protocols
