// What the models are meant to reach, and whether they did: targets T1, T3 and T4.
#include <algorithm>
#include <cmath>
#include <limits>

#include "study/app/bench_report.h"

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
    {"T1", "coherent, 12 nodes: times as fast as GSL", "splines", "coherent", 12, kGsl, kOurs, 1.4},
    {"T1",
     "coherent, 12 nodes: times as fast as Boost",
     "splines",
     "coherent",
     12,
     kBoost,
     kOurs,
     1.8},
    {"T1",
     "random, 10,000 nodes: times as fast as GSL",
     "splines",
     "random",
     10'000,
     kGsl,
     kOurs,
     3.0},
    {"T1",
     "random, 10,000 nodes: times as fast as Boost",
     "splines",
     "random",
     10'000,
     kBoost,
     kOurs,
     3.0},
    {"T1", "cold, 12 nodes: times as fast as Boost", "splines", "cold", 12, kBoost, kOurs, 1.0},
    {"T1", "cold, 12 nodes: times as fast as GSL", "splines", "cold", 12, kGsl, kOurs, 1.8},
    {"T1", "cold, 100 nodes: times as fast as Boost", "splines", "cold", 100, kBoost, kOurs, 1.0},
    {"T1", "cold, 100 nodes: times as fast as GSL", "splines", "cold", 100, kGsl, kOurs, 1.8},
    {"T1",
     "cold, 10,000 nodes: times as fast as Boost",
     "splines",
     "cold",
     10'000,
     kBoost,
     kOurs,
     1.0},
    {"T1", "cold, 10,000 nodes: times as fast as GSL", "splines", "cold", 10'000, kGsl, kOurs, 1.8},
    {"T1",
     "coherent, 12 nodes: times one cubic",
     "splines",
     "coherent",
     12,
     kOurs,
     kHorner,
     1.4,
     true},
    {"T1",
     "random, 10,000 nodes: times one cubic",
     "splines",
     "random",
     10'000,
     kOurs,
     kHorner,
     5.0,
     true},
    {"T3", "N = 5: times as fast as dense LU", "finite elements", kAlike, 5, kLu, kMesh, 12},
    {"T3", "N = 15: times as fast as dense LU", "finite elements", kAlike, 15, kLu, kMesh, 45},
    {"T3",
     "N = 12,445: times as fast as LDLᵀ factorised before",
     "finite elements",
     kAlike,
     12'445,
     "Eigen sparse LDLᵀ, once",
     kMesh,
     40},
    {"T4",
     "times as fast as Eigen, fixed size",
     "Kalman filter",
     "a step",
     1,
     "Eigen, fixed size",
     kFilter,
     2.0},
    {"T4",
     "times as fast as Eigen, dynamic size",
     "Kalman filter",
     "a step",
     1,
     "Eigen, dynamic size",
     kFilter,
     25.0},
    {"T4",
     "times the standard scalar form",
     "Kalman filter",
     "a step",
     1,
     kFilter,
     "standard, scalar",
     1.5,
     true}};

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
  if (worst >= 0.0) targets.push_back({"T3", what, worst, wanted, true});
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
  if (isMeasured) targets.push_back({"T4", "negative variances", negative, 0.0, true});
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
  return targets;
}

}  // namespace study::app
