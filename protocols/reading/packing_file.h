#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "haptics/reaming/packing/packed_bone.h"
#include "questionnaires/json/problem.h"

namespace protocols {

/// Packings may be larger than other files.
inline constexpr std::size_t kMaxPackingBytes = 500'000'000;  ///< [bytes]

/// The extension of packing files.
inline constexpr std::string_view kPackingExtension = ".packing";

/// The origin of a packing, stored in its file for readers.
struct PackingOrigin {
  std::string mesh;      ///< file name without the folder, or "parametric acetabulum"
  std::string sha256;    ///< hash of the mesh file in hexadecimal; empty without a mesh file
  std::string material;  ///< material and test set to which the packing was fitted; empty if it was
                         ///< not fitted
  std::uint64_t seed = 1;  ///< of the random numbers of the packing
};

/// Reads a packing as `palpate packing` writes it (docs/protocol-format.md, "Packing files"), and
/// reports all problems; std::nullopt if there are errors.
///
/// A packing that is not fitted yet has no densities.
std::optional<haptics::reaming::PackedBone> readPacking(
    std::string_view text, questionnaires::Problems& problems, PackingOrigin* origin = nullptr);

/// The text of a packing file: a line of JSON, then a line for each sphere with its numbers as
/// hexadecimal digits of their single-precision bits, which can be read back exactly.
std::string packingAsText(const haptics::reaming::PackedBone& bone, const PackingOrigin& origin);

}  // namespace protocols
