#include "haptics/recordings/force_curve.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace haptics::recordings {

ForceCurve::ForceCurve(std::vector<CurvePoint> nodes) : nodes_(std::move(nodes)) {
  if (nodes_.size() < 2) throw std::invalid_argument("a force curve has at least two nodes");
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    if (!std::isfinite(nodes_[i].travel) || !std::isfinite(nodes_[i].force)) {
      throw std::invalid_argument("node " + std::to_string(i + 1) + " of a curve is not finite");
    }
    if (i > 0 && !(nodes_[i].travel > nodes_[i - 1].travel)) {
      throw std::invalid_argument(
          "node " + std::to_string(i + 1) + " of a curve does not lie above the one before it");
    }
  }
}

double ForceCurve::forceAt(double travel) const noexcept {
  if (!(travel > start())) return nodes_.front().force;
  if (travel >= end()) return nodes_.back().force;
  const auto above = std::ranges::upper_bound(nodes_, travel, {}, &CurvePoint::travel);
  const CurvePoint& high = *above;
  const CurvePoint& low = *(above - 1);
  const double share = (travel - low.travel) / (high.travel - low.travel);
  return low.force + (high.force - low.force) * share;
}

double ForceCurve::largestSlope() const noexcept {
  double largest = 0.0;
  for (std::size_t i = 1; i < nodes_.size(); ++i) {
    const double slope =
        (nodes_[i].force - nodes_[i - 1].force) / (nodes_[i].travel - nodes_[i - 1].travel);
    largest = std::max(largest, std::abs(slope));
  }
  return largest;
}

namespace {

constexpr double kTravelTolerance = 1e-6;  // [travel units]

/// Samples that are merged into one node, and their mean.
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
    while (!pools.empty() && !(pool.travel > pools.back().travel + kTravelTolerance)) {
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

namespace {

/// min_y (f(y) + K |x − y|), in place.
void lowerEnvelope(std::vector<CurvePoint>& nodes, double maxSlope) {
  const auto pull = [&](CurvePoint& node, const CurvePoint& neighbour) {
    const double reach = maxSlope * std::abs(node.travel - neighbour.travel);
    node.force = std::min(node.force, neighbour.force + reach);
  };
  for (std::size_t i = 1; i < nodes.size(); ++i) pull(nodes[i], nodes[i - 1]);
  for (std::size_t i = nodes.size() - 1; i > 0; --i) pull(nodes[i - 1], nodes[i]);
}

std::vector<CurvePoint> mirrored(std::vector<CurvePoint> nodes) {
  for (CurvePoint& node : nodes) node.force = -node.force;
  return nodes;
}

}  // namespace

SlopeLimited limitSlope(const ForceCurve& curve, double maxSlope) {
  if (!std::isfinite(maxSlope) || !(maxSlope > 0.0)) {
    throw std::invalid_argument("a slope limit is positive and finite");
  }
  std::vector<CurvePoint> lower = curve.nodes();
  lowerEnvelope(lower, maxSlope);
  std::vector<CurvePoint> upper = mirrored(curve.nodes());
  lowerEnvelope(upper, maxSlope);
  upper = mirrored(std::move(upper));

  double largestChange = 0.0;
  double largestChangeAt = curve.start();
  for (std::size_t i = 0; i < lower.size(); ++i) {
    const double before = curve.nodes()[i].force;
    lower[i].force = lower[i].force + (upper[i].force - lower[i].force) / 2.0;
    const double change = std::abs(lower[i].force - before);
    if (change <= largestChange) continue;
    largestChange = change;
    largestChangeAt = lower[i].travel;
  }
  return {ForceCurve(std::move(lower)), largestChange, largestChangeAt};
}

namespace {

std::vector<double> sharedTravels(std::span<const ForceCurve> curves) {
  double start = -std::numeric_limits<double>::infinity();
  double end = std::numeric_limits<double>::infinity();
  for (const ForceCurve& curve : curves) {
    start = std::max(start, curve.start());
    end = std::min(end, curve.end());
  }
  constexpr double kLeastShared = 1e-3;  // [travel units]
  if (curves.empty() || !(end - start > kLeastShared)) return {};
  std::vector<double> travels;
  for (std::size_t i = 0; i < MeanCurve::kNodes; ++i) {
    const double share = static_cast<double>(i) / static_cast<double>(MeanCurve::kNodes - 1);
    travels.push_back(start + (end - start) * share);
  }
  return travels;
}

double meanAt(std::span<const ForceCurve> curves, double travel) {
  double sum = 0.0;
  for (const ForceCurve& curve : curves) sum += curve.forceAt(travel);
  return sum / static_cast<double>(curves.size());
}

double deviationAt(std::span<const ForceCurve> curves, double travel, double mean) {
  if (curves.size() < 2) return 0.0;
  double sum = 0.0;
  for (const ForceCurve& curve : curves) sum += std::pow(curve.forceAt(travel) - mean, 2);
  return std::sqrt(sum / static_cast<double>(curves.size() - 1));
}

double squaredDistance(const ForceCurve& curve, const ForceCurve& mean) {
  double sum = 0.0;
  for (const CurvePoint& node : mean.nodes()) {
    sum += std::pow(curve.forceAt(node.travel) - node.force, 2);
  }
  return sum;
}

}  // namespace

std::optional<MeanCurve> meanCurve(std::span<const ForceCurve> curves) {
  std::vector<CurvePoint> nodes;
  std::vector<double> deviation;
  for (const double travel : sharedTravels(curves)) {
    const double mean = meanAt(curves, travel);
    nodes.push_back({travel, mean});
    deviation.push_back(deviationAt(curves, travel, mean));
  }
  if (nodes.empty()) return std::nullopt;
  return MeanCurve{ForceCurve(std::move(nodes)), std::move(deviation)};
}

std::optional<std::size_t> indexOfMostTypical(std::span<const ForceCurve> curves) {
  const std::optional<MeanCurve> mean = meanCurve(curves);
  if (!mean) return std::nullopt;
  const auto distance = [&](const ForceCurve& c) { return squaredDistance(c, mean->curve); };
  const auto nearest = std::ranges::min_element(curves, {}, distance);
  return static_cast<std::size_t>(nearest - curves.begin());
}

}  // namespace haptics::recordings
