#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "protocols/reading/mesh_file.h"
#include "questionnaires/json/problem.h"

namespace protocols {

/// How files with anatomies end.
inline constexpr std::string_view kAnatomyEnding = ".obj";

/// An anatomy may be larger than what a researcher writes.
inline constexpr std::size_t kLargestAnatomy = 20'000'000;  ///< [bytes]

/// In all its surfaces together: what a processor without a graphics card still draws 25 times a
/// second beside a trial. Ours have 10,000.
inline constexpr std::size_t kMostTriangles = 30'000;

/// What of the knee a file may replace. The meniscus is none of them: finite elements move it.
inline constexpr std::string_view kTibia = "tibia";
inline constexpr std::string_view kFemur = "femur";
inline constexpr std::string_view kCapsule = "capsule";

/// Surfaces of a knee from a file, in place of the built-in ones.
///
/// Their frame is the punch's mouth: the origin on the lower jaw where it bites, x to the right as
/// the arthroscope shows it, y up from the shin to the thigh, z towards the surgeon [mm].
struct Anatomy {
  std::vector<NamedSurface> surfaces;  ///< sound; each name once

  /// Nothing where ours stays.
  const NamedSurface* find(std::string_view name) const noexcept;
};

/// An anatomy from an OBJ file's text, and everything that is wrong with it; nothing where there
/// are errors.
std::optional<Anatomy> readAnatomy(std::string_view text, questionnaires::Problems& problems);

}  // namespace protocols
