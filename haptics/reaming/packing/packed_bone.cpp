#include "haptics/reaming/packing/packed_bone.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <stdexcept>

#include "haptics/reaming/bone/bone.h"
#include "haptics/reaming/bone/sphere_field.h"
#include "haptics/timing/stopwatch.h"

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

namespace {

/// The forces or torques of a curve at some depths; negative values count as 0.
std::vector<double> valuesAt(const CurveNodes& curve, std::span<const double> depths) {
  std::vector<double> values;
  values.reserve(depths.size());
  for (const double depth : depths) values.push_back(std::max(0.0, forceOf(curve, depth)));
  return values;
}

/// Every @p stride-th value, beginning at stride / 2.
std::vector<double> everyNth(std::span<const double> all, std::size_t stride) {
  std::vector<double> some;
  for (std::size_t i = stride / 2; i < all.size(); i += stride) some.push_back(all[i]);
  return some;
}

/// The virtual experiment: matrices and targets of the fit of a bone.
struct VirtualExperiment {
  // A quarter of the depths suffices, since the torque is as smooth as the force.
  static constexpr std::size_t kTorqueStride = 4;

  const Packing& packing;
  PlungePath plunge;
  std::vector<double> depths;
  std::vector<double> torqueDepths = everyNth(depths, kTorqueStride);

  ContactMatrix forces(std::span<const double> at) const {
    return contactMatrix(packing, packing.coverage(), plunge, at);
  }
  ContactMatrix levers() const {
    return leverMatrix(packing, packing.coverage(), plunge, torqueDepths);
  }
  /// Fits μ with a quarter of the depths, because a dozen fits are needed to find it.
  double friction(const CurveNodes& force, const CurveNodes& torque) const {
    return bestFriction(
        forces(torqueDepths),
        valuesAt(force, torqueDepths),
        {.levers = levers(), .torques = valuesAt(torque, torqueDepths)});
  }
};

void addTorqueErrors(
    BoneFitReport& report,
    const VirtualExperiment& experiment,
    const HardnessCurves& torque,
    double friction) {
  const CurveNodes* curves[]{&torque.minimum, &torque.average, &torque.maximum};
  const auto levers = experiment.levers();
  for (std::size_t k = 0; k < report.curves.size(); ++k) {
    auto densities = report.curves[k].fit.densities;
    for (double& density : densities) density *= friction;
    report.curves[k].torqueError =
        errorOf(levers, densities, valuesAt(*curves[k], experiment.torqueDepths));
  }
}

}  // namespace

BoneFitReport fitBoneToMaterial(
    PackedBone& bone,
    const HardnessCurves& force,
    const HardnessCurves& torque,
    const BoneFitOptions& options) {
  const auto begin = std::chrono::steady_clock::now();
  if (const auto problem = problemOf(bone); !problem.empty()) throw std::invalid_argument(problem);
  const std::vector<double> ones(bone.packing.spheres.size(), 1.0);
  const double deepest = force.end();
  std::vector<double> places;
  const auto count = static_cast<double>(options.depths);
  for (std::size_t i = 0; i < options.depths; ++i) {
    places.push_back(deepest * (static_cast<double>(i) + 0.5) / count);
  }
  const VirtualExperiment experiment{
      .packing = bone.packing,
      .plunge = plungePathInto(SphereField(bone.packing, ones), bone.reamerRadius),
      .depths = places};
  const auto matrix = experiment.forces(places);
  const bool isJoint = !torque.isEmpty() && !options.method;
  TorqueRows rows;
  if (isJoint) {
    if (options.onProgress) options.onProgress("the friction");
    rows.levers = experiment.levers();
    rows.friction =
        options.friction ? *options.friction : experiment.friction(force.average, torque.average);
  }
  struct Curve {
    const char* name;
    const CurveNodes& force;
    const CurveNodes& torque;
    std::vector<float>& densities;
  };
  const Curve all[]{
      {"minimum", force.minimum, torque.minimum, bone.minimum},
      {"average", force.average, torque.average, bone.average},
      {"maximum", force.maximum, torque.maximum, bone.maximum}};
  BoneFitReport report;
  report.hasOptimalityGap = !options.method;
  for (const auto& [name, wanted, wantedTorque, densities] : all) {
    if (options.onProgress) options.onProgress(std::string("the ") + name + " curve");
    CurveFit curve{
        .curve = name,
        .depths = places,
        .wanted = valuesAt(wanted, places),
        .fittedForce = {},
        .fit = {}};
    if (options.method) {
      curve.fit = options.method(matrix, curve.wanted);
    } else if (isJoint) {
      rows.torques = valuesAt(wantedTorque, experiment.torqueDepths);
      curve.fit = fitBone(matrix, curve.wanted, rows);
    } else {
      curve.fit = fitBone(matrix, curve.wanted);
    }
    curve.fittedForce = matrix.times(curve.fit.densities);
    densities.assign(curve.fit.densities.begin(), curve.fit.densities.end());
    report.curves.push_back(std::move(curve));
  }
  bone.friction = options.friction;
  if (!torque.isEmpty()) {
    if (!options.friction) bone.friction = fitFriction(bone, torque).friction;
    addTorqueErrors(report, experiment, torque, *bone.friction);
  }
  report.friction = bone.friction;
  report.seconds = timing::secondsSince(begin);
  return report;
}

FrictionFit fitFriction(const PackedBone& bone, const HardnessCurves& torque, std::size_t depths) {
  const CurveNodes* curves[]{&torque.minimum, &torque.average, &torque.maximum};
  const double deepest = torque.end();
  double product = 0.0;
  double square = 0.0;
  double wantedSquare = 0.0;
  for (int k = 0; k < 3; ++k) {
    const SphereField field(bone.packing, bone.densities(0.5 * k, 1.0));
    const PlungePath plunge = plungePathInto(field, bone.reamerRadius);
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
  // |μ L − T|² has its minimum T² − (L·T)²/L² at μ = L·T / L².
  const double residual = std::max(0.0, wantedSquare - product * product / square);
  return {product / square, std::sqrt(residual / wantedSquare)};
}

ExperimentResult ream(const PackedBone& bone, double h, const ExperimentOptions& options) {
  constexpr double kMachineStiffness = 2e6;  // stiffness of a testing machine [N/m]
  const double coverage = bone.packing.coverage();
  Bone cut(
      bone.packing,
      bone.densities(h, 1.0),
      {.coverage = coverage,
       .coupling = kMachineStiffness,
       .cuttingDamping = options.cuttingDamping,
       .mostFeed = options.mostFeed,
       .isGuided = true});
  const PlungePath plunge = plungePathInto(cut.field(), bone.reamerRadius);
  const double whole = cut.remainingMass();
  const double dt = options.step / options.feed;
  constexpr double kStartDepth = -0.0005;  // start outside the bone, until Bone::isOutside() [m]
  for (int i = 0; i < 1000; ++i) cut.step(plunge.at(kStartDepth), dt);
  ExperimentResult result{.depth = {}, .force = {}, .stop = "the largest depth"};
  for (double device = kStartDepth; device < options.mostDepth + 0.002; device += options.step) {
    const auto fittedForce = cut.step(plunge.at(device), dt);
    const double depth = cut.tool().centre.z - plunge.start;
    if (depth > options.mostDepth) break;
    if (depth <= 0.0 || (!result.depth.empty() && depth <= result.depth.back())) continue;
    result.depth.push_back(depth);
    result.force.push_back(-fittedForce.force.z);
    if (-fittedForce.force.z < options.largestForce) continue;
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
    const double fittedForce = forceAt(result, depths[i]);
    if (std::isnan(fittedForce)) continue;
    difference += (fittedForce - wanted[i]) * (fittedForce - wanted[i]);
    square += wanted[i] * wanted[i];
  }
  return square > 0.0 ? std::sqrt(difference / square) : 1.0;
}

}  // namespace haptics::reaming
