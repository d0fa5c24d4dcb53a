#include "haptics/recordings/mean_curve.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace haptics::recordings {
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

std::optional<std::size_t> mostTypical(std::span<const ForceCurve> curves) {
  const std::optional<MeanCurve> mean = meanCurve(curves);
  if (!mean) return std::nullopt;
  const auto distance = [&](const ForceCurve& c) { return squaredDistance(c, mean->curve); };
  const auto nearest = std::ranges::min_element(curves, {}, distance);
  return static_cast<std::size_t>(nearest - curves.begin());
}

}  // namespace haptics::recordings
