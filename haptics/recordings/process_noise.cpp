#include "haptics/recordings/process_noise.h"

#include <cmath>
#include <vector>

#include "haptics/recordings/recording.h"

namespace haptics::recordings {
namespace {

double meanOf(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double value : values) sum += value;
  return sum / static_cast<double>(values.size());
}

double covarianceOf(const std::vector<double>& a, const std::vector<double>& b) {
  const double meanA = meanOf(a);
  const double meanB = meanOf(b);
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += (a[i] - meanA) * (b[i] - meanB);
  return sum / static_cast<double>(a.size() - 1);
}

}  // namespace

ProcessNoise processNoiseOf(const Trace& trace, std::span<const RowRange> rows, double leastStep) {
  constexpr std::size_t kFewest = 3;
  std::vector<double> force;
  std::vector<double> stiffness;
  ProcessNoise noise;
  double lastTravel = 0.0;
  for (const RowRange& range : rows) {
    for (std::size_t row = range.first - 1; row < range.last; ++row) {
      const double travelled = trace.travel[row] - lastTravel;
      const bool isFirst = force.empty();
      if (!isFirst && (travelled == 0.0 || std::abs(travelled) < leastStep)) {
        ++noise.resting;
        continue;
      }
      stiffness.push_back(isFirst ? 0.0 : (trace.force[row] - force.back()) / travelled);
      force.push_back(trace.force[row]);
      lastTravel = trace.travel[row];
    }
  }
  if (force.size() < kFewest) {
    throw Error("Two rows and fewer say nothing about a variance. Name longer ranges of rows.");
  }
  noise.samples = force.size();
  noise.force = covarianceOf(force, force);
  noise.covariance = covarianceOf(force, stiffness);
  noise.stiffness = covarianceOf(stiffness, stiffness);
  return noise;
}

}  // namespace haptics::recordings
