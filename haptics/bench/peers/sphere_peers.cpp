#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>

#include "haptics/bench/peers/peers.h"

#ifdef PALPATE_HAS_NANOFLANN
#include <nanoflann.hpp>
#endif

namespace haptics::bench::peers {
namespace {

using reaming::Packing;
using reaming::Reamer;
using reaming::Vec3;

#ifdef PALPATE_HAS_NANOFLANN
/// The term a ρ of sphere @p i.
double pressingOfSphere(
    const Packing& packing, const double* densities, std::size_t i, const Reamer& r) {
  const auto& s = packing.spheres[i];
  const Vec3 away = s.centre() - r.centre;
  const double d = length(away);
  const double over = d - r.radius;
  const double lens = double{s.radius} * s.radius - over * over;
  if (lens <= 0.0 || dot(away, r.axis) < 0.0) return 0.0;
  return std::numbers::pi * r.radius * lens / d * densities[i];
}

double largestRadius(const Packing& packing) {
  double largest = 0.0;
  for (const auto& s : packing.spheres) largest = std::max(largest, double{s.radius});
  return largest;
}

/// Searches all centres within the outer radius; those too far inside the reamer are discarded
/// afterwards.
class Nanoflann {
 public:
  Nanoflann(const Packing& packing, const std::vector<double>& densities)
      : packing_(packing),
        densities_(densities),
        reach_(largestRadius(packing)),
        tree_(3, cloud_, nanoflann::KDTreeSingleIndexAdaptorParams(16)) {}

  double pressing(const Reamer& reamer) {
    const float centre[]{
        static_cast<float>(reamer.centre.x),
        static_cast<float>(reamer.centre.y),
        static_cast<float>(reamer.centre.z)};
    const auto reach = static_cast<float>(reamer.radius + reach_);
    found_.clear();
    nanoflann::SearchParams unsorted;
    unsorted.sorted = false;
    tree_.radiusSearch(centre, reach * reach, found_, unsorted);
    double sum = 0.0;
    for (const auto& [i, square] : found_)
      sum += pressingOfSphere(packing_, densities_.data(), i, reamer);
    return sum;
  }

 private:
  struct Cloud {
    const Packing& packing;
    std::size_t kdtree_get_point_count() const { return packing.spheres.size(); }
    float kdtree_get_pt(std::size_t i, std::size_t axis) const {
      const auto& s = packing.spheres[i];
      return axis == 0 ? s.x : axis == 1 ? s.y : s.z;
    }
    template <typename Box>
    bool kdtree_get_bbox(Box&) const {
      return false;
    }
  };
  using Tree = nanoflann::
      KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<float, Cloud>, Cloud, 3, std::uint32_t>;

  const Packing& packing_;
  const std::vector<double>& densities_;
  double reach_;
  Cloud cloud_{packing_};
  Tree tree_;
  std::vector<std::pair<std::uint32_t, float>> found_;
};
#endif

}  // namespace

std::function<double(const Reamer&)> nanoflannPressing(
    [[maybe_unused]] const Packing& packing,
    [[maybe_unused]] const std::vector<double>& densities) {
#ifdef PALPATE_HAS_NANOFLANN
  const auto tree = std::make_shared<Nanoflann>(packing, densities);
  return [tree](const Reamer& reamer) { return tree->pressing(reamer); };
#else
  return {};
#endif
}

}  // namespace haptics::bench::peers
