#pragma once

#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

#include "protocols/reading/mesh_file.h"
#include "questionnaires/json/problem.h"

namespace protocols {

/// The extension of anatomy files.
inline constexpr std::string_view kAnatomyExtension = ".obj";

/// Anatomies may be larger than other files.
inline constexpr std::size_t kMaxAnatomyBytes = 20'000'000;  ///< [bytes]

/// The largest number of triangles in all surfaces. During a trial, a computer without a graphics
/// card can still draw this number 25 times per second. The built-in knee has 10,000.
inline constexpr std::size_t kMostTriangles = 30'000;

/// The names of objects that a file may replace. The meniscus cannot be replaced, because finite
/// elements deform it.
inline constexpr std::string_view kTibia = "tibia";
inline constexpr std::string_view kFemur = "femur";
inline constexpr std::string_view kCapsule = "capsule";

/// Surfaces of a knee from a file, which replace the built-in ones.
///
/// Coordinates are in the frame of the punch's mouth [mm]: the origin is on the lower jaw where it
/// bites, x points right in the arthroscope's view, y from the shin up to the thigh, z towards the
/// surgeon.
struct Anatomy {
  std::vector<NamedSurface> surfaces;  ///< valid; each name once

  /// The surface called @p name; nullptr if the file has none, so that the built-in one is used.
  const NamedSurface* find(std::string_view name) const noexcept;
};

/// Reads an anatomy from an OBJ file's text and reports all problems; std::nullopt if there are
/// errors.
std::optional<Anatomy> readAnatomy(std::string_view text, questionnaires::Problems& problems);

}  // namespace protocols
