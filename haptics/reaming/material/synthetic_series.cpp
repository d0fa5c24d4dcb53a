#include "haptics/reaming/material/synthetic_series.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "base/random.h"

namespace haptics::reaming {
namespace {

constexpr double kRate = 100.0;          // [Hz]
constexpr double kLargestDepth = 0.020;  // [m]
constexpr double kForceLimit = 800.0;    // force limit of a static test [N]
constexpr double kPreload = 20.0;        // [N]
constexpr double kStaticFeed = 0.07e-3;  // [m/s]

double step(double x, double at, double width) {
  return 1.0 / (1.0 + std::exp(-(x - at) / width));
}

/// Force at a depth [m] during reaming: first almost none, then the peak of the lamella, then a
/// rise.
double dynamicForce(double depth, const SyntheticTest& test, double shift) {
  const double mm = 1000.0 * depth;
  const double scale = 0.25 + 1.5 * test.hardness;
  const double at = 3.6 + shift + (test.set == TestSet::Dynamic2 ? 0.5 : 0.0);
  const double lamella = 110.0 * step(mm, at, 0.30) - 45.0 * step(mm, at + 1.6, 0.35);
  const double rise = 9.0 * std::max(0.0, mm - at) + 0.9 * std::pow(std::max(0.0, mm - at), 2.0);
  return scale * (lamella + rise);
}

/// Force at a depth [m] without reaming: stiffer from the beginning.
double staticForce(double depth, const SyntheticTest& test) {
  const double mm = 1000.0 * depth;
  const double scale = 0.5 + test.hardness;
  return kPreload + scale * (14.0 * mm + 9.0 * mm * mm);
}

bool hasTestEnded(const SyntheticTest& test, double force, double torque) {
  constexpr double kStallTorque = 14.0;  // [N·m]
  return test.set == TestSet::Static ? force >= kForceLimit : torque >= kStallTorque;
}

double feedAt(const SyntheticTest& test, double depth) {
  const double feed = test.set == TestSet::Static ? kStaticFeed : test.feed;
  const bool isAltered = test.simulatedFault == SyntheticFault::FeedChange && depth > 0.004;
  return isAltered ? 2.5 * feed : feed;
}

}  // namespace

Series syntheticSeries(const SyntheticTest& test) {
  base::SplitMix64 random(test.seed);
  const bool isStatic = test.set == TestSet::Static;
  const double shift = 0.8 * (random.uniform() - 0.5);  // depth offset of the lamella [mm]
  const double breaksAt = 0.005 + 0.003 * random.uniform();
  Series series{.set = test.set, .rate = kRate, .isSynthetic = true};
  double depth = 0.0;
  for (std::size_t i = 0; depth <= kLargestDepth; ++i) {
    const double time = static_cast<double>(i) / kRate;
    double force = isStatic ? staticForce(depth, test) : dynamicForce(depth, test, shift);
    if (test.simulatedFault == SyntheticFault::BreakOut && depth > breaksAt) force *= 0.08;
    if (test.simulatedFault == SyntheticFault::ReamedThrough)
      force *= 1.0 - step(1000.0 * depth, 10.5, 0.15);
    const double line = isStatic ? 0.0
                                 : test.rotation * std::min(1.0, force / 50.0) *
                                       std::sin(2.0 * std::numbers::pi * test.rotationRate * time);
    const double torque = isStatic ? 0.0 : 0.028 * force;  // friction at about a reamer's radius
    series.displacement.push_back(depth);
    series.force.push_back(force + line + test.noise * random.normal());
    if (!isStatic) {
      series.torque.push_back(torque + 0.028 * line + 0.02 * test.noise * random.normal());
    }
    if (hasTestEnded(test, force, torque)) break;
    depth += feedAt(test, depth) / kRate;
  }
  return series;
}

Series noiselessSeries(SyntheticTest test) {
  test.noise = 0.0;
  test.rotation = 0.0;
  return syntheticSeries(test);
}

std::vector<Series> syntheticStudy(std::uint64_t seed) {
  constexpr int kSpecimens = 24;
  base::SplitMix64 random(seed);
  std::vector<Series> all;
  for (int specimen = 1; specimen <= kSpecimens; ++specimen) {
    SyntheticTest test{.hardness = random.uniform()};
    test.feed = specimen % 2 == 0 ? 0.01e-3 : 0.03e-3;
    for (const TestSet set : {TestSet::Static, TestSet::Dynamic1, TestSet::Dynamic2}) {
      test.set = set;
      test.seed =
          seed * 1000 + static_cast<std::uint64_t>(specimen) * 10 + static_cast<std::uint64_t>(set);
      test.simulatedFault = SyntheticFault::None;
      const bool isDynamic1 = set == TestSet::Dynamic1;
      const bool isDynamic2 = set == TestSet::Dynamic2;
      if (isDynamic1 && specimen <= 2) test.simulatedFault = SyntheticFault::FeedChange;
      if (isDynamic2 && specimen >= 3 && specimen <= 6)
        test.simulatedFault = SyntheticFault::BreakOut;
      if (isDynamic2 && specimen >= 7 && specimen <= 10)
        test.simulatedFault = SyntheticFault::ReamedThrough;
      auto series = syntheticSeries(test);
      series.name =
          "synthetic specimen " + std::to_string(specimen) + ", " + std::string(nameOf(set));
      all.push_back(std::move(series));
    }
  }
  return all;
}

}  // namespace haptics::reaming
