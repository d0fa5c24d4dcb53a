#include "haptics/reaming/packing/virtual_experiment.h"

#include <algorithm>
#include <cmath>

#include "haptics/reaming/bone/bone.h"
#include "haptics/reaming/bone/plunge.h"

namespace haptics::reaming {

ExperimentResult ream(const PackedBone& bone, double h, const ExperimentOptions& options) {
  constexpr double kMachine = 2e6;  // of a stiff machine [N/m]
  const double coverage = bone.packing.coverage();
  Bone cut(
      bone.packing,
      bone.densities(h, 1.0),
      {.coverage = coverage, .coupling = kMachine, .isGuided = true});
  const Plunge plunge = plungeInto(cut.field(), bone.reamerRadius);
  const double whole = cut.remainingMass();
  const double dt = options.step / options.feed;
  constexpr double kBefore = -0.0005;  // outside, until the bone has seen the tool there [m]
  for (int i = 0; i < 1000; ++i) cut.step(plunge.at(kBefore), dt);
  ExperimentResult result{.depth = {}, .force = {}, .stop = "the largest depth"};
  for (double device = kBefore; device < options.mostDepth + 0.002; device += options.step) {
    const auto felt = cut.step(plunge.at(device), dt);
    const double depth = cut.tool().centre.z - plunge.start;
    if (depth > options.mostDepth) break;
    if (depth <= 0.0 || (!result.depth.empty() && depth <= result.depth.back())) continue;
    result.depth.push_back(depth);
    result.force.push_back(-felt.force.z);
    if (-felt.force.z < options.mostForce) continue;
    result.stop = "the largest force";
    break;
  }
  result.removedShare = whole > 0.0 ? cut.removedMass() / whole : 0.0;
  return result;
}

double errorOf(
    const ExperimentResult& result,
    const std::vector<double>& depths,
    const std::vector<double>& wanted) {
  double difference = 0.0;
  double square = 0.0;
  for (std::size_t i = 0; i < depths.size(); ++i) {
    const auto after = std::lower_bound(result.depth.begin(), result.depth.end(), depths[i]);
    if (after == result.depth.begin() || after == result.depth.end()) continue;
    const auto k = static_cast<std::size_t>(after - result.depth.begin());
    const double share =
        (depths[i] - result.depth[k - 1]) / (result.depth[k] - result.depth[k - 1]);
    const double felt = result.force[k - 1] + share * (result.force[k] - result.force[k - 1]);
    difference += (felt - wanted[i]) * (felt - wanted[i]);
    square += wanted[i] * wanted[i];
  }
  return square > 0.0 ? std::sqrt(difference / square) : 1.0;
}

}  // namespace haptics::reaming
