#include "haptics/recordings/monotone_curve.h"

#include <utility>
#include <vector>

namespace haptics::recordings {
namespace {

constexpr double kSameTravel = 1e-6;  // [travel units]

/// Samples that share one node, their mean.
struct Pool {
  double travel = 0.0;
  double force = 0.0;
  double count = 0.0;

  void take(const Pool& other) {
    const double share = other.count / (count + other.count);
    travel += (other.travel - travel) * share;
    force += (other.force - force) * share;
    count += other.count;
  }
};

}  // namespace

MonotoneCurve monotoneCurve(std::span<const CurvePoint> samples) {
  std::vector<Pool> pools;
  for (const CurvePoint& sample : samples) {
    Pool pool{sample.travel, sample.force, 1.0};
    while (!pools.empty() && !(pool.travel > pools.back().travel + kSameTravel)) {
      Pool before = pools.back();
      pools.pop_back();
      before.take(pool);
      pool = before;
    }
    pools.push_back(pool);
  }
  std::vector<CurvePoint> nodes;
  nodes.reserve(pools.size());
  for (const Pool& pool : pools) nodes.push_back({pool.travel, pool.force});
  const std::size_t merged = samples.size() - nodes.size();
  return {ForceCurve(std::move(nodes)), samples.size(), merged};
}

}  // namespace haptics::recordings
