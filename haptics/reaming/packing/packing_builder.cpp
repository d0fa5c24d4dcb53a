#include "haptics/reaming/packing/packing_builder.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <thread>
#include <tuple>

#include "base/random.h"
#include "haptics/reaming/packing/tangent_sphere.h"

namespace haptics::reaming {
namespace {

constexpr int kCellsPerBlockSide = 3;          // cells per side of a block
constexpr double kSpacing = 1.6;               // distance of the starting points, in wanted radii
constexpr double kNextRadius = 0.7;            // ratio of the radius to that of the last pass
constexpr double kSmallestRadiusShare = 0.05;  // of a pass, relative to the largest radius

std::string problemOf(const PackingOptions& options) {
  const int wants = static_cast<int>(options.count.has_value()) +
                    static_cast<int>(options.coverage.has_value()) +
                    static_cast<int>(options.smallestRadius.has_value());
  if (wants != 1) return "say one of: a count, a coverage, a smallest radius";
  if (options.count && (*options.count < 1 || *options.count > 8'000'000)) {
    return "the count must lie between 1 and 8,000,000";
  }
  if (options.coverage && !(*options.coverage > 0.0 && *options.coverage <= 0.8)) {
    return "the coverage must lie above 0 and not above 0.8";
  }
  if (options.smallestRadius && !(*options.smallestRadius > 0.0)) {
    return "the smallest radius must lie above 0";
  }
  if (options.largestRadius && !(*options.largestRadius > 0.0)) {
    return "the largest radius must lie above 0";
  }
  if (options.smallestRadius && options.largestRadius &&
      *options.largestRadius < *options.smallestRadius) {
    return "the largest radius lies below the smallest";
  }
  return options.threads < 1 ? "at least one thread is needed" : "";
}

double largestRadiusOf(const PackingOptions& options, double volume) {
  if (options.largestRadius) return *options.largestRadius;
  if (options.smallestRadius) return 4.0 * *options.smallestRadius;
  if (options.count) return 0.95 * std::cbrt(volume / static_cast<double>(*options.count));
  return std::cbrt(volume) / 50.0;
}

/// The four obstacles whose surfaces are nearest to a point, in order of distance.
class NearestFour {
 public:
  void add(const Obstacle& obstacle) noexcept {
    if (count_ == 4 && obstacle.distance >= all_[3].distance) return;
    std::size_t at = count_ < 4 ? count_++ : 3;
    for (; at > 0 && all_[at - 1].distance > obstacle.distance; --at) all_[at] = all_[at - 1];
    all_[at] = obstacle;
  }
  double clearance() const noexcept { return count_ > 0 ? all_[0].distance : kFar; }
  double farthestDistance() const noexcept { return count_ == 4 ? all_[3].distance : kFar; }
  bool hasFour() const noexcept { return count_ == 4; }
  const std::array<Obstacle, 4>& all() const noexcept { return all_; }

 private:
  static constexpr double kFar = std::numeric_limits<double>::infinity();
  std::array<Obstacle, 4> all_;
  std::size_t count_ = 0;
};

class Builder {
 public:
  // A cell is slightly wider than the largest sphere, so that touching spheres are in neighbouring
  // cells in spite of rounding.
  Builder(const Solid& body, double largest, const PackingOptions& options)
      : body_(body), largest_(largest), cell_(2.0 * largest * (1.0 + 1e-6)), options_(options) {
    const Vec3 size = body.upperCorner() - body.lowerCorner();
    const auto blocksAlong = [&](double extent) {
      return std::floor(extent / (cell_ * kCellsPerBlockSide)) + 1.0;
    };
    const double along[]{blocksAlong(size.x), blocksAlong(size.y), blocksAlong(size.z)};
    const double cells = std::pow(kCellsPerBlockSide, 3.0) * along[0] * along[1] * along[2];
    if (!(cells <= 2e8)) {
      throw std::invalid_argument(
          "the spheres are so small beside the body that there is no memory for it: ask for fewer, "
          "or larger ones");
    }
    for (std::size_t axis = 0; axis < 3; ++axis) blocks_[axis] = static_cast<int>(along[axis]);
    cells_.resize(static_cast<std::size_t>(cells));
    const Vec3 low = body.lowerCorner();
    const Vec3 high = body.upperCorner();
    const double farthest = std::max(
        {std::abs(low.x),
         std::abs(low.y),
         std::abs(low.z),
         std::abs(high.x),
         std::abs(high.y),
         std::abs(high.z)});
    quantum_ = std::ldexp(1.0, std::ilogb(farthest) + 1 - std::numeric_limits<float>::digits);
    classify();
  }

  /// Places spheres of at least @p radius wherever there is space. @return false if cancelled.
  template <typename KeepGoing>
  bool pass(double radius, KeepGoing keepGoing) {
    ++passes_;
    // A thread writes the cells of its block and reads one cell beyond. Blocks of one colour are
    // never neighbours, so no thread reads what another writes. So there are no locks, and the
    // packing does not depend on the number of threads.
    for (int colour = 0; colour < 8; ++colour) {
      std::vector<std::array<int, 3>> blocks;
      for (int k = colour >> 2; k < blocks_[2]; k += 2) {
        for (int j = (colour >> 1) & 1; j < blocks_[1]; j += 2) {
          for (int i = colour & 1; i < blocks_[0]; i += 2) {
            if (cellKind(i, j, k) != Kind::Outside) blocks.push_back({i, j, k});
          }
        }
      }
      std::atomic<std::size_t> next{0};
      const auto work = [&] {
        for (std::size_t at = next++; at < blocks.size(); at = next++) fill(blocks[at], radius);
      };
      std::vector<std::thread> helpers;
      for (int i = 1; i < options_.threads; ++i) helpers.emplace_back(work);
      work();
      for (auto& helper : helpers) helper.join();
      if (!keepGoing()) return false;
    }
    return true;
  }

  std::vector<Sphere> spheres() const {
    std::vector<Sphere> all;
    for (const auto& cell : cells_) all.insert(all.end(), cell.begin(), cell.end());
    std::ranges::sort(all, [](const Sphere& a, const Sphere& b) {
      return std::tie(b.radius, a.x, a.y, a.z) < std::tie(a.radius, b.x, b.y, b.z);
    });
    return all;
  }

 private:
  enum class Kind : char { Outside, Inside, Mixed };

  Vec3 cornerOf(const std::array<int, 3>& block) const {
    const double side = cell_ * kCellsPerBlockSide;
    return body_.lowerCorner() + side * Vec3{
                                            static_cast<double>(block[0]),
                                            static_cast<double>(block[1]),
                                            static_cast<double>(block[2])};
  }

  void classify() {
    const double half = 0.5 * cell_ * kCellsPerBlockSide;
    const double reach = std::sqrt(3.0) * half;
    for (int k = 0; k < blocks_[2]; ++k) {
      for (int j = 0; j < blocks_[1]; ++j) {
        for (int i = 0; i < blocks_[0]; ++i) {
          // Classify a block by its bounding sphere, with a margin inside. Only mixed blocks
          // compute the distance to the body's surface for every point, which is slow.
          const Vec3 centre = cornerOf({i, j, k}) + Vec3{half, half, half};
          const double inside = body_.nearest(centre).distance;
          kinds_.push_back(
              inside < -reach                   ? Kind::Outside
              : inside > reach + 3.0 * largest_ ? Kind::Inside
                                                : Kind::Mixed);
        }
      }
    }
  }

  Kind cellKind(int i, int j, int k) const {
    return kinds_
        [(static_cast<std::size_t>(k) * static_cast<std::size_t>(blocks_[1]) +
          static_cast<std::size_t>(j)) *
             static_cast<std::size_t>(blocks_[0]) +
         static_cast<std::size_t>(i)];
  }

  std::array<int, 3> cellOf(Vec3 place) const noexcept {
    const Vec3 from = (1.0 / cell_) * (place - body_.lowerCorner());
    return {
        static_cast<int>(std::floor(from.x)),
        static_cast<int>(std::floor(from.y)),
        static_cast<int>(std::floor(from.z))};
  }
  std::size_t indexOf(int i, int j, int k) const noexcept {
    const auto x = static_cast<std::size_t>(blocks_[0]) * kCellsPerBlockSide;
    const auto y = static_cast<std::size_t>(blocks_[1]) * kCellsPerBlockSide;
    return (static_cast<std::size_t>(k) * y + static_cast<std::size_t>(j)) * x +
           static_cast<std::size_t>(i);
  }

  /// The nearest obstacles around @p place, within a cell; distances above the largest radius are
  /// not distinguished.
  NearestFour nearestObstacles(Vec3 place, bool isMixed) const noexcept {
    NearestFour nearest;
    if (isMixed) {
      const auto boundary = body_.nearest(place);
      nearest.add(
          {boundary.distance,
           boundary.inward,
           dot(boundary.inward, place) - boundary.distance,
           true});
    }
    const auto cell = cellOf(place);
    std::array<int, 3> from{};
    std::array<int, 3> to{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      from[axis] = std::max(0, cell[axis] - 1);
      to[axis] = std::min(blocks_[axis] * kCellsPerBlockSide - 1, cell[axis] + 1);
    }
    for (int k = from[2]; k <= to[2]; ++k) {
      for (int j = from[1]; j <= to[1]; ++j) {
        for (int i = from[0]; i <= to[0]; ++i) addNearest(cells_[indexOf(i, j, k)], place, nearest);
      }
    }
    return nearest;
  }

  static void addNearest(
      const std::vector<Sphere>& cell, Vec3 place, NearestFour& nearest) noexcept {
    for (const auto& sphere : cell) {
      const Vec3 away = sphere.centre() - place;
      const double square = dot(away, away);
      // Compare with the fourth nearest by squared distances, before taking the root.
      const double limit = nearest.farthestDistance() + sphere.radius;
      if (limit <= 0.0 || square >= limit * limit) continue;
      nearest.add({std::sqrt(square) - sphere.radius, sphere.centre(), sphere.radius, false});
    }
  }

  void fill(const std::array<int, 3>& block, double radius) {
    const double side = cell_ * kCellsPerBlockSide;
    const int along = std::max(1, static_cast<int>(std::ceil(side / (kSpacing * radius))));
    const double step = side / along;
    const bool isMixed = cellKind(block[0], block[1], block[2]) == Kind::Mixed;
    // Every block of every pass has its own random numbers, so that they do not depend on the
    // thread.
    std::uint64_t salt = options_.seed;
    for (const int part : {passes_, block[0], block[1], block[2]}) {
      salt = base::SplitMix64(salt ^ static_cast<std::uint64_t>(part)).bits();
    }
    base::SplitMix64 random(salt);
    const Vec3 corner = cornerOf(block);
    for (int k = 0; k < along; ++k) {
      for (int j = 0; j < along; ++j) {
        for (int i = 0; i < along; ++i) {
          const Vec3 place =
              corner +
              step * Vec3{i + random.uniform(), j + random.uniform(), k + random.uniform()};
          fillAt(place, block, isMixed, radius);
        }
      }
    }
  }

  /// Moves from @p place to the locally largest space, and puts a sphere there.
  void fillAt(Vec3 place, const std::array<int, 3>& block, bool isMixed, double radius) {
    auto nearest = nearestObstacles(place, isMixed);
    double room = nearest.clearance();
    if (room < -0.2 * radius) return;  // deep inside a sphere or outside the body
    constexpr int kMostMoves = 5;
    Vec3 best = place;
    Vec3 from = place;
    for (int move = 0; move < kMostMoves && nearest.hasFour() && room < largest_; ++move) {
      const auto tangent = tangentTo(nearest.all(), from, 2.0 * largest_);
      if (!tangent || !isIn(tangent->centre, block)) break;
      from = tangent->centre;
      nearest = nearestObstacles(from, isMixed);
      if (nearest.clearance() > room) {
        room = nearest.clearance();
        best = from;
      }
      // The sphere touches its four nearest obstacles: it is locally the largest.
      if (std::abs(nearest.clearance() - tangent->radius) < 1e-6 * largest_) break;
    }
    if (room < radius || !isIn(best, block)) return;
    addSphere(best, block, isMixed);
  }

  bool isIn(Vec3 place, const std::array<int, 3>& block) const noexcept {
    const auto cell = cellOf(place);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (cell[axis] < kCellsPerBlockSide * block[axis] ||
          cell[axis] >= kCellsPerBlockSide * (block[axis] + 1)) {
        return false;
      }
    }
    return true;
  }

  /// Adds a sphere. The centre is rounded to single precision first, so that the radius is exact
  /// for it.
  void addSphere(Vec3 place, const std::array<int, 3>& block, bool isMixed) {
    const auto rounded = [&](double x) { return quantum_ * std::round(x / quantum_); };
    const Vec3 centre{rounded(place.x), rounded(place.y), rounded(place.z)};
    const double room = std::min(nearestObstacles(centre, isMixed).clearance(), largest_);
    if (!(room > 0.0) || !isIn(centre, block)) return;
    const auto cell = cellOf(centre);
    cells_[indexOf(cell[0], cell[1], cell[2])].push_back(
        {static_cast<float>(centre.x),
         static_cast<float>(centre.y),
         static_cast<float>(centre.z),
         std::nextafter(static_cast<float>(room), 0.0F)});  // rounding must not let two overlap
  }

  const Solid& body_;
  double largest_;
  double cell_;
  const PackingOptions& options_;
  std::array<int, 3> blocks_{};
  std::vector<Kind> kinds_;
  std::vector<std::vector<Sphere>> cells_;
  double quantum_ = 0.0;  ///< grid to which coordinates are rounded [m]
  int passes_ = 0;
};

/// Whether @p packing is complete; if so, removes the smallest spheres that are too many.
bool isFull(Packing& packing, const PackingOptions& options) {
  auto& spheres = packing.spheres;
  if (options.count) {
    if (spheres.size() < *options.count) return false;
    spheres.resize(*options.count);
    return true;
  }
  if (!options.coverage) return false;
  const double wanted = *options.coverage * packing.volume;
  double filled = 0.0;
  for (std::size_t i = 0; i < spheres.size(); ++i) {
    filled += 4.0 / 3.0 * std::numbers::pi * std::pow(double{spheres[i].radius}, 3.0);
    if (filled < wanted) continue;
    spheres.resize(i + 1);
    return true;
  }
  return false;
}

}  // namespace

std::optional<Packing> pack(
    const Solid& body,
    const PackingOptions& options,
    const std::function<bool(const PackingProgress&)>& onProgress) {
  if (const auto problem = problemOf(options); !problem.empty()) {
    throw std::invalid_argument(problem);
  }
  Packing packing{.volume = body.volume()};
  const double largest = largestRadiusOf(options, packing.volume);
  Builder builder(body, largest, options);
  const double least = options.smallestRadius.value_or(kSmallestRadiusShare * largest);
  for (double radius = largest; radius > 0.0;) {
    const PackingProgress progress{packing.spheres.size(), packing.coverage(), radius};
    if (!builder.pass(radius, [&] { return !onProgress || onProgress(progress); }))
      return std::nullopt;
    packing.spheres = builder.spheres();
    if (isFull(packing, options)) return packing;
    if (radius <= least) break;
    radius = std::max(kNextRadius * radius, least);
  }
  if (options.smallestRadius && !packing.spheres.empty()) return packing;
  throw std::invalid_argument(
      "the body has no room for it: with spheres down to " + std::to_string(1e3 * least) +
      " mm there are " + std::to_string(packing.spheres.size()) + ", and " +
      std::to_string(100.0 * packing.coverage()) +
      " % is covered. Ask for less, or choose another largest radius");
}

}  // namespace haptics::reaming
