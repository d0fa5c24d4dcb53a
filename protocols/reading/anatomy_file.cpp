#include "protocols/reading/anatomy_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "base/search.h"
#include "protocols/model/messages.h"
#include "questionnaires/json/document.h"

namespace protocols {
namespace {

using questionnaires::Problems;
using questionnaires::shown;

constexpr std::array kReplaceableSurfaces{kTibia, kFemur, kCapsule};
constexpr std::array<std::string_view, 2> kFixedSurfaces{"meniscus", "punch"};
constexpr float kSmallestKnee = 20.0F;     // length along the longest axis [mm]
constexpr float kLargestKnee = 400.0F;     // length along the longest axis [mm]
constexpr float kFarthestSurface = 60.0F;  // distance of any surface from the punch's mouth [mm]
constexpr float kSmallestInMillimetres =
    1.0F;                                // a knee smaller than 1 mm is probably given in metres
constexpr float kShortestNormal = 0.5F;  // shortest normal that has a direction

bool isFinite(const NamedSurface::Triple& v) {
  return std::isfinite(v[0]) && std::isfinite(v[1]) && std::isfinite(v[2]);
}

float lengthOf(const NamedSurface::Triple& v) {
  return std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
}

std::string rounded(float value) {
  return std::to_string(std::lround(value));
}

/// For each vertex the mean normal of its triangles; +y for a vertex without triangles.
std::vector<NamedSurface::Triple> normalsOfTriangles(const NamedSurface& surface) {
  std::vector<NamedSurface::Triple> normals(surface.places.size());
  for (const auto& [a, b, c] : surface.triangles) {
    const auto& p = surface.places[a];
    const auto& q = surface.places[b];
    const auto& r = surface.places[c];
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t j = (i + 1) % 3;
      const std::size_t k = (i + 2) % 3;
      const float across = (q[j] - p[j]) * (r[k] - p[k]) - (q[k] - p[k]) * (r[j] - p[j]);
      for (const auto corner : {a, b, c}) normals[corner][i] += across;
    }
  }
  for (auto& normal : normals) {
    const float length = lengthOf(normal);
    if (length <= 0.0F) normal = {0.0F, 1.0F, 0.0F};
    for (auto& part : normal) part /= length > 0.0F ? length : 1.0F;
  }
  return normals;
}

/// Adds @p more, a part of an object of several materials, which the importer splits. If one part
/// has no colours, the whole object has none.
void append(NamedSurface& surface, const NamedSurface& more) {
  const auto first = static_cast<std::uint32_t>(surface.places.size());
  const auto add = [](auto& to, const auto& from) {
    to.insert(to.end(), from.begin(), from.end());
  };
  const bool areBothColoured = !surface.colours.empty() && !more.colours.empty();
  add(surface.places, more.places);
  add(surface.normals, more.normals);
  if (areBothColoured) add(surface.colours, more.colours);
  if (!areBothColoured) surface.colours.clear();
  for (const auto& [a, b, c] : more.triangles) {
    surface.triangles.push_back({first + a, first + b, first + c});
  }
}

/// Reads the objects of a file, and reports problems with their names.
class AnatomyReader {
 public:
  explicit AnatomyReader(Problems& problems) : problems_(problems) {}

  void addSurface(NamedSurface surface) {
    if (base::contains(kFixedSurfaces, surface.name)) return;
    const std::string place = placeOf(surface.name);
    if (!base::contains(kReplaceableSurfaces, surface.name)) return refuseName(surface.name, place);
    if (!isSound(surface, place)) return;
    const auto same = std::ranges::find_if(
        anatomy_.surfaces, [&](const auto& other) { return other.name == surface.name; });
    if (same == anatomy_.surfaces.end()) {
      anatomy_.surfaces.push_back(std::move(surface));
    } else {
      append(*same, surface);
    }
  }

  std::optional<Anatomy> finish() {
    if (problems_.hasErrors()) return std::nullopt;
    if (anatomy_.surfaces.empty()) {
      problems_.add(
          "", "no object in it replaces anything", "name the objects tibia, femur or capsule");
      return std::nullopt;
    }
    checkCount();
    checkSize();
    for (const auto& surface : anatomy_.surfaces) checkPlace(surface);
    if (problems_.hasErrors()) return std::nullopt;
    return std::move(anatomy_);
  }

 private:
  static std::string placeOf(const std::string& name) {
    return name.empty() ? "object without a name" : "object '" + shown(name) + "'";
  }

  void refuseName(const std::string& name, const std::string& place) {
    // no name, or the name that the importer generates
    const bool isGeneratedName = name.empty() || name == "defaultobject";
    problems_.add(
        isGeneratedName ? "object without a name" : place,
        "nothing of the knee has this name",
        "name the objects tibia, femur or capsule (meniscus and punch are left out)");
  }

  bool isSound(NamedSurface& surface, const std::string& place) {
    if (!std::ranges::all_of(surface.places, isFinite)) {
      problems_.add(
          place,
          "a corner of it lies at no number (nan or inf)",
          "repair the mesh and save it anew");
      return false;
    }
    if (surface.triangles.empty()) {
      problems_.add(place, "there is no triangle in it", "save it with its faces");
      return false;
    }
    replaceInvalidNormals(surface, place);
    if (!surface.hasNormals) {
      problems_.warn(place, message("no_normals"), message("no_normals.fix"));
    }
    return true;
  }

  /// Replaces normals without a direction by the normals of the adjacent triangles.
  void replaceInvalidNormals(NamedSurface& surface, const std::string& place) {
    const auto hasDirection = [](const auto& n) {
      return isFinite(n) && lengthOf(n) > kShortestNormal;
    };
    const auto whole = std::ranges::count_if(surface.normals, hasDirection);
    const auto lost = static_cast<std::ptrdiff_t>(surface.normals.size()) - whole;
    if (lost == 0) return;
    const auto around = normalsOfTriangles(surface);
    for (std::size_t i = 0; i < surface.normals.size(); ++i) {
      if (!hasDirection(surface.normals[i])) surface.normals[i] = around[i];
    }
    if (!surface.hasNormals) return;  // the caller reports missing normals
    problems_.warn(
        place,
        message("normals_without_direction", lost),
        message("normals_without_direction.fix"));
  }

  void checkCount() {
    std::size_t count = 0;
    for (const auto& surface : anatomy_.surfaces) count += surface.triangles.size();
    if (count <= kMostTriangles) return;
    problems_.add(
        "",
        "its " + std::to_string(count) +
            " triangles are more than can be drawn in time without a "
            "graphics card",
        "simplify it to " + std::to_string(kMostTriangles) + " or fewer");
  }

  void checkSize() {
    const float longest = longestAxis();
    if (longest >= kSmallestKnee && longest <= kLargestKnee) return;
    const std::string size = "it is " + rounded(longest) + " mm long, which is no knee's size";
    const std::string wanted = " (a knee has 20 to 400 mm)";
    if (longest < kSmallestInMillimetres) {
      problems_.add(
          "",
          "it is less than 1 mm long" + wanted,
          "its numbers are likely metres: save it in millimetres, 1000 times as large");
    } else if (longest < kSmallestKnee) {
      problems_.add(
          "",
          size + wanted,
          "its numbers are likely centimetres: save it in millimetres, 10 times as large");
    } else {
      problems_.add("", size + wanted, "save it in millimetres, and only what is near the punch");
    }
  }

  float longestAxis() const {
    constexpr float kFar = std::numeric_limits<float>::max();
    NamedSurface::Triple low{kFar, kFar, kFar};
    NamedSurface::Triple high{-kFar, -kFar, -kFar};
    for (const auto& surface : anatomy_.surfaces) {
      for (const auto& place : surface.places) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
          low[axis] = std::min(low[axis], place[axis]);
          high[axis] = std::max(high[axis], place[axis]);
        }
      }
    }
    return std::max({high[0] - low[0], high[1] - low[1], high[2] - low[2]});
  }

  void checkPlace(const NamedSurface& surface) {
    float nearest = std::numeric_limits<float>::max();
    for (const auto& place : surface.places) nearest = std::min(nearest, lengthOf(place));
    if (nearest <= kFarthestSurface) return;
    problems_.add(
        placeOf(surface.name),
        "it comes no nearer than " + rounded(nearest) + " mm to the punch, and would not be seen",
        "put the origin where the punch bites; see \"Your own anatomy\" in docs/simulation.md");
  }

  Problems& problems_;
  Anatomy anatomy_;
};

}  // namespace

const NamedSurface* Anatomy::find(std::string_view name) const noexcept {
  const auto found =
      std::ranges::find_if(surfaces, [&](const auto& surface) { return surface.name == name; });
  return found == surfaces.end() ? nullptr : &*found;
}

std::optional<Anatomy> readAnatomy(std::string_view text, Problems& problems) {
  Problems found;
  AnatomyReader reader(found);
  try {
    for (auto& surface : readObj(text)) reader.addSurface(std::move(surface));
  } catch (const base::UserError& error) {
    found.add("", error.what(), "save it as OBJ, with its faces");
  }
  auto anatomy = reader.finish();
  problems.append(found);
  return anatomy;
}

}  // namespace protocols
