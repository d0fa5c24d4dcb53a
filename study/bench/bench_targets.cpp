// What the models are meant to reach, and whether they did.
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "study/bench/bench_report.h"

namespace study::app {
namespace {

using Measured = std::vector<haptics::bench::Repeated>;

/// A ratio of two medians in one setting.
struct RatioTarget {
  const char* id;
  const char* what;
  const char* family;
  const char* setting;
  double parameter;
  const char* numerator;
  const char* denominator;
  double wanted;
  bool isAtMost = false;
};

constexpr const char* kOurs = "palpate Hermite";
constexpr const char* kMesh = "palpate, force and mesh";
constexpr const char* kFilter = "palpate LDLᵀ";
constexpr const char* kBoost = "Boost PCHIP";
constexpr const char* kGsl = "GSL natural cubic";
constexpr const char* kHorner = "floor: one Horner";
constexpr const char* kLu = "Eigen dense LU, each step";
constexpr const char* kAlike = "elements alike";

constexpr RatioTarget kRatios[]{
    {"splines",
     "coherent, 12 nodes: times as fast as GSL",
     "splines",
     "coherent",
     12,
     kGsl,
     kOurs,
     1.4},
    {"splines",
     "coherent, 12 nodes: times as fast as Boost",
     "splines",
     "coherent",
     12,
     kBoost,
     kOurs,
     1.8},
    {"splines",
     "random, 10,000 nodes: times as fast as GSL",
     "splines",
     "random",
     10'000,
     kGsl,
     kOurs,
     3.0},
    {"splines",
     "random, 10,000 nodes: times as fast as Boost",
     "splines",
     "random",
     10'000,
     kBoost,
     kOurs,
     3.0},
    {"splines",
     "cold, 12 nodes: times as fast as Boost",
     "splines",
     "cold",
     12,
     kBoost,
     kOurs,
     1.0},
    {"splines", "cold, 12 nodes: times as fast as GSL", "splines", "cold", 12, kGsl, kOurs, 1.8},
    {"splines",
     "cold, 100 nodes: times as fast as Boost",
     "splines",
     "cold",
     100,
     kBoost,
     kOurs,
     1.0},
    {"splines", "cold, 100 nodes: times as fast as GSL", "splines", "cold", 100, kGsl, kOurs, 1.8},
    {"splines",
     "cold, 10,000 nodes: times as fast as Boost",
     "splines",
     "cold",
     10'000,
     kBoost,
     kOurs,
     1.0},
    {"splines",
     "cold, 10,000 nodes: times as fast as GSL",
     "splines",
     "cold",
     10'000,
     kGsl,
     kOurs,
     1.8},
    {"splines",
     "coherent, 12 nodes: times one cubic",
     "splines",
     "coherent",
     12,
     kOurs,
     kHorner,
     1.4,
     true},
    {"splines",
     "random, 10,000 nodes: times one cubic",
     "splines",
     "random",
     10'000,
     kOurs,
     kHorner,
     5.0,
     true},
    {"finite elements",
     "N = 5: times as fast as dense LU",
     "finite elements",
     kAlike,
     5,
     kLu,
     kMesh,
     12},
    {"finite elements",
     "N = 15: times as fast as dense LU",
     "finite elements",
     kAlike,
     15,
     kLu,
     kMesh,
     45},
    {"finite elements",
     "N = 12,445: times as fast as LDLᵀ factorised before",
     "finite elements",
     kAlike,
     12'445,
     "Eigen sparse LDLᵀ, once",
     kMesh,
     40},
    {"filter",
     "times as fast as Eigen, fixed size",
     "Kalman filter",
     "a step",
     1,
     "Eigen, fixed size",
     kFilter,
     2.0},
    {"filter",
     "times as fast as Eigen, dynamic size",
     "Kalman filter",
     "a step",
     1,
     "Eigen, dynamic size",
     kFilter,
     25.0},
    {"filter",
     "times the standard scalar form",
     "Kalman filter",
     "a step",
     1,
     kFilter,
     "standard, scalar",
     1.5,
     true},
    {"spheres",
     "201,532 spheres: times as fast as nanoflann",
     "packing",
     "contact",
     201'532,
     "nanoflann",
     "palpate",
     5.0},
    {"spheres",
     "201,532 spheres: times as fast as Embree",
     "packing",
     "contact",
     201'532,
     "Embree",
     "palpate",
     8.0},
    {"spheres",
     "201,532 spheres: times as fast as all of them",
     "packing",
     "contact",
     201'532,
     "all of them, same loop",
     "palpate",
     2.5}};

/// The median time [ns]; not a number where it was not measured.
double timeOf(const Measured& all, const RatioTarget& target, const char* method) {
  for (const auto& r : all) {
    const auto& m = r.measurement;
    const bool isIt = m.family == target.family && m.setting == target.setting &&
                      m.method == method && m.parameter == target.parameter;
    if (isIt && m.time) return m.time->median;
  }
  return std::numeric_limits<double>::quiet_NaN();
}

/// The largest error of a method up to N = 1000, at every contrast.
void addErrorTarget(
    const Measured& all,
    const std::string& method,
    const char* what,
    double wanted,
    std::vector<Target>& targets) {
  double worst = -1.0;
  for (const auto& r : all) {
    const auto& m = r.measurement;
    const bool isOfIt = m.family == "finite elements" && m.method == method && m.parameter <= 1000;
    if (isOfIt && m.error) worst = std::max(worst, *m.error);
  }
  if (worst >= 0.0) targets.push_back({"finite elements", what, worst, wanted, true});
}

void addVarianceTarget(const Measured& all, std::vector<Target>& targets) {
  double negative = 0.0;
  bool isMeasured = false;
  for (const auto& r : all) {
    const auto& m = r.measurement;
    const bool isOurs = m.setting.find("negative variances") != std::string::npos &&
                        m.method.starts_with("palpate");
    if (!isOurs) continue;
    isMeasured = true;
    negative += m.error.value_or(0.0);
  }
  if (isMeasured) targets.push_back({"filter", "negative variances", negative, 0.0, true});
}

/// The largest of what @p valueOf makes of the measurements it makes something of.
template <typename ValueOf>
std::optional<double> worstOf(const Measured& all, ValueOf valueOf) {
  std::optional<double> worst;
  for (const auto& r : all) {
    const std::optional<double> value = valueOf(r.measurement);
    if (value) worst = std::max(worst.value_or(*value), *value);
  }
  return worst;
}

using haptics::bench::Measurement;

/// What a method came to in a setting of a family.
const Measurement* find(
    const Measured& all,
    const std::string& family,
    const std::string& setting,
    const std::string& method,
    std::optional<double> parameter = std::nullopt) {
  for (const auto& r : all) {
    const auto& m = r.measurement;
    if (m.family != family || m.setting != setting || m.method != method) continue;
    if (!parameter || m.parameter == *parameter) return &m;
  }
  return nullptr;
}

void addPackingTargets(const Measured& all, std::vector<Target>& targets) {
  constexpr double kMicrosecond = 1000.0;  // [ns]
  constexpr double kTick = 1e6;            // [ns]
  if (const auto* cold = find(all, "packing", "removal at 2 mm/s, cold", "palpate")) {
    const double p99 = cold->time->p99 / kMicrosecond;
    targets.push_back({"spheres", "201,532 spheres, removal, cold: p99 [µs]", p99, 260.0, true});
  }
  const auto most = worstOf(all, [&](const Measurement& m) -> std::optional<double> {
    const bool isIt = m.family == "packing" && m.setting == "removal at 0.5 mm/s";
    return isIt && m.time->p99 < kTick ? std::optional(m.parameter) : std::nullopt;
  });
  if (most) targets.push_back({"most spheres", "spheres with removal, p99 below 1 ms", *most, 3e6});
}

void addDensityTargets(const Measured& all, std::vector<Target>& targets) {
  const std::string ours = "palpate, bounded least squares";
  const auto gap = worstOf(all, [](const Measurement& m) {
    const bool isIt = m.family == "density" && m.setting == "above the optimum, at most";
    return isIt ? m.error : std::nullopt;
  });
  if (gap)
    targets.push_back(
        {"densities", "densities: above the bounded optimum, a share", *gap, 0.01, true});
  const auto* best = find(all, "density", "all spheres", ours, 1e-6);
  const auto* swarm = find(all, "density", "all spheres", "swarm, median of 20 seeds", 8);
  if (best == nullptr || swarm == nullptr) return;
  targets.push_back(
      {"densities",
       "densities: error of the swarm, times ours, after " +
           std::to_string(static_cast<int>(std::round(swarm->time->median / best->time->median))) +
           " times the time",
       *swarm->error / *best->error,
       100.0});
}

void addFilterTargets(const Measured& all, std::vector<Target>& targets) {
  constexpr double kMillisecond = 1e6;  // [ns]
  const std::string nodes = "nodes for an error";
  const std::string greedy = "greedy, 200,000 samples";
  const auto share = worstOf(all, [&](const Measurement& m) -> std::optional<double> {
    if (m.family != "filter" || m.setting != nodes || m.method != greedy) return std::nullopt;
    const auto* best = find(all, "filter", nodes, "optimal, 1000 samples", m.parameter);
    return best != nullptr ? std::optional(*m.error / *best->error) : std::nullopt;
  });
  const auto time = worstOf(all, [&](const Measurement& m) -> std::optional<double> {
    const bool isIt = m.family == "filter" && m.setting == nodes && m.method == greedy;
    return isIt ? std::optional(m.time->median / kMillisecond) : std::nullopt;
  });
  if (share) targets.push_back({"nodes", "nodes: times as many as the optimum", *share, 2.0, true});
  if (time) targets.push_back({"nodes", "nodes of 200,000 samples [ms]", *time, 5.0, true});
  const std::string cutoff = "cut-off and low-pass, RMS from the noiseless curve [N]";
  const auto* found = find(all, "filter", cutoff, "detrended-hann");
  const auto* oracle = find(all, "filter", cutoff, "the best of all cut-offs");
  if (found != nullptr && oracle != nullptr) {
    targets.push_back(
        {"low-pass",
         "residual: times the best cut-off's",
         *found->error / *oracle->error,
         4.0,
         true});
  }
  if (const auto* all200 =
          find(all, "filter", "199,999 samples: cut-off, filter, nodes", "palpate")) {
    targets.push_back(
        {"low-pass",
         "2000 s at 100 Hz prepared [ms]",
         all200->time->median / kMillisecond,
         25.0,
         true});
  }
}

}  // namespace

std::vector<Target> accuracyTargets(const Measured& all) {
  std::vector<Target> targets;
  for (const auto& ratio : kRatios) {
    const double measured =
        timeOf(all, ratio, ratio.numerator) / timeOf(all, ratio, ratio.denominator);
    if (!std::isfinite(measured)) continue;
    targets.push_back({ratio.id, ratio.what, measured, ratio.wanted, ratio.isAtMost});
  }
  addErrorTarget(all, kMesh, "largest relative error, double", 4e-15, targets);
  addErrorTarget(
      all, std::string(kMesh) + ", float", "largest relative error, float", 1e-6, targets);
  addVarianceTarget(all, targets);
  addFilterTargets(all, targets);
  addPackingTargets(all, targets);
  addDensityTargets(all, targets);
  return targets;
}

}  // namespace study::app
