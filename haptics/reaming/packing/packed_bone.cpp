#include "haptics/reaming/packing/packed_bone.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <stdexcept>

#include "haptics/reaming/bone/bone.h"
#include "haptics/reaming/bone/sphere_field.h"

namespace haptics::reaming {

std::vector<double> PackedBone::densities(double h, double scale) const {
  const auto& softer = h <= 0.5 ? minimum : average;
  const auto& harder = h <= 0.5 ? average : maximum;
  const double share = h <= 0.5 ? 2.0 * h : 2.0 * h - 1.0;
  std::vector<double> all;
  all.reserve(softer.size());
  for (std::size_t i = 0; i < softer.size(); ++i) {
    all.push_back(scale * ((1.0 - share) * softer[i] + share * harder[i]));
  }
  return all;
}

std::string problemOf(const PackedBone& bone) {
  const double coverage = bone.packing.coverage();
  if (!(coverage > 0.0 && coverage <= 1.0)) {
    return "the spheres hold more than the whole body, or nothing: the packing is damaged";
  }
  bool isInTheWay = false;
  for (const auto& s : bone.packing.spheres) {
    if (!std::isfinite(s.x + s.y + s.z + s.radius)) return "a sphere is nowhere";
    if (s.radius >= bone.reamerRadius) {
      return "a sphere is as large as the reamer: build it with more and smaller ones";
    }
    isInTheWay |= std::hypot(double{s.x}, double{s.y}) < bone.reamerRadius;
  }
  if (isInTheWay) return {};
  return "the reamer passes beside the bone: turn and move the mesh so that +z through its origin "
         "goes into the cup";
}

BoneFitReport fitTo(
    PackedBone& bone,
    const HardnessCurves& curves,
    std::size_t depths,
    const std::function<void(const std::string&)>& goesOn,
    const DensityMethod& method) {
  const auto begin = std::chrono::steady_clock::now();
  if (const auto problem = problemOf(bone); !problem.empty()) throw std::invalid_argument(problem);
  const std::vector<double> ones(bone.packing.spheres.size(), 1.0);
  const Plunge plunge = plungeInto(SphereField(bone.packing, ones), bone.reamerRadius);
  const double deepest = std::max(
      {curves.minimum.back().position,
       curves.average.back().position,
       curves.maximum.back().position});
  std::vector<double> places;
  for (std::size_t i = 0; i < depths; ++i) {
    places.push_back(deepest * (static_cast<double>(i) + 0.5) / static_cast<double>(depths));
  }
  const auto matrix = contactMatrix(bone.packing, bone.packing.coverage(), plunge, places);
  const std::pair<const char*, const CurveNodes*> all[]{
      {"minimum", &curves.minimum}, {"average", &curves.average}, {"maximum", &curves.maximum}};
  std::vector<float>* densities[]{&bone.minimum, &bone.average, &bone.maximum};
  BoneFitReport report;
  report.knowsOptimum = !method;
  for (std::size_t k = 0; k < 3; ++k) {
    if (goesOn) goesOn(all[k].first);
    CurveFit curve{.curve = all[k].first, .depths = places, .wanted = {}, .felt = {}, .fit = {}};
    for (const double depth : places) {
      curve.wanted.push_back(std::max(0.0, forceOf(*all[k].second, depth)));
    }
    curve.fit = method ? method(matrix, curve.wanted) : fitBone(matrix, curve.wanted);
    curve.felt = matrix.times(curve.fit.densities);
    densities[k]->assign(curve.fit.densities.begin(), curve.fit.densities.end());
    report.curves.push_back(std::move(curve));
  }
  const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - begin;
  report.seconds = passed.count();
  return report;
}

FrictionFit fitFriction(const PackedBone& bone, const HardnessCurves& torque, std::size_t depths) {
  const CurveNodes* curves[]{&torque.minimum, &torque.average, &torque.maximum};
  double deepest = 0.0;
  for (const auto* curve : curves) deepest = std::max(deepest, curve->back().position);
  double product = 0.0;
  double square = 0.0;
  double wantedSquare = 0.0;
  for (int k = 0; k < 3; ++k) {
    const SphereField field(bone.packing, bone.densities(0.5 * k, 1.0));
    const Plunge plunge = plungeInto(field, bone.reamerRadius);
    for (std::size_t i = 0; i < depths; ++i) {
      const double depth = deepest * (static_cast<double>(i) + 0.5) / static_cast<double>(depths);
      const double lever = field.touch(plunge.at(depth), false).lever / bone.packing.coverage();
      const double wanted = std::max(0.0, forceOf(*curves[k], depth));
      product += lever * wanted;
      square += lever * lever;
      wantedSquare += wanted * wanted;
    }
  }
  if (!(square > 0.0 && wantedSquare > 0.0)) {
    throw std::invalid_argument("there is no torque, or the reamer touches nothing");
  }
  // |μ L − T|² is least at μ = L·T / L², and is then T² − (L·T)²/L².
  const double residual = std::max(0.0, wantedSquare - product * product / square);
  return {product / square, std::sqrt(residual / wantedSquare)};
}

ExperimentResult ream(const PackedBone& bone, double h, const ExperimentOptions& options) {
  constexpr double kMachine = 2e6;  // of a stiff machine [N/m]
  const double coverage = bone.packing.coverage();
  Bone cut(
      bone.packing,
      bone.densities(h, 1.0),
      {.coverage = coverage,
       .coupling = kMachine,
       .cuttingDamping = options.cuttingDamping,
       .mostFeed = options.mostFeed,
       .isGuided = true});
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
  result.removed = cut.removedMass();
  if (whole > 0.0) {
    result.removedShare = result.removed / whole;
    result.unaccounted = std::abs(result.removed + cut.remainingMass() - whole) / whole;
  }
  return result;
}

double forceAt(const ExperimentResult& result, double depth) {
  const auto after = std::lower_bound(result.depth.begin(), result.depth.end(), depth);
  if (after == result.depth.begin() || after == result.depth.end()) {
    return std::numeric_limits<double>::quiet_NaN();
  }
  const auto k = static_cast<std::size_t>(after - result.depth.begin());
  const double share = (depth - result.depth[k - 1]) / (result.depth[k] - result.depth[k - 1]);
  return result.force[k - 1] + share * (result.force[k] - result.force[k - 1]);
}

double errorOf(
    const ExperimentResult& result,
    const std::vector<double>& depths,
    const std::vector<double>& wanted) {
  double difference = 0.0;
  double square = 0.0;
  for (std::size_t i = 0; i < depths.size(); ++i) {
    const double felt = forceAt(result, depths[i]);
    if (std::isnan(felt)) continue;
    difference += (felt - wanted[i]) * (felt - wanted[i]);
    square += wanted[i] * wanted[i];
  }
  return square > 0.0 ? std::sqrt(difference / square) : 1.0;
}

}  // namespace haptics::reaming
