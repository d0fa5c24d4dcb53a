// The models with numbers over many decades, in both builds (with and without fused multiply-add).
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>

#include "haptics/bench/stability.h"
#include "haptics/bench/string_reference.h"
#include "haptics/reaming/material/spline.h"

namespace haptics::bench {
namespace plain {
extern const StabilityKernels kKernels;
}
#ifdef PALPATE_HAS_FUSED_KERNELS
namespace fused {
extern const StabilityKernels kKernels;
}
#endif

const StabilityKernels& plainKernels() noexcept {
  return plain::kKernels;
}

const StabilityKernels* fusedKernels() noexcept {
#ifdef PALPATE_HAS_FUSED_KERNELS
  return __builtin_cpu_supports("fma") != 0 ? &fused::kKernels : nullptr;
#else
  return nullptr;
#endif
}

namespace {

std::vector<const StabilityKernels*> availableKernels() {
  std::vector<const StabilityKernels*> kernels{&plainKernels()};
  if (const auto* fused = fusedKernels()) kernels.push_back(fused);
  return kernels;
}

int scaledCount(double effort, int whole) {
  return std::max(1, static_cast<int>(std::lround(effort * whole)));
}

double relativeError(double value, const HundredDigits& expected) {
  if (!std::isfinite(value)) return std::numeric_limits<double>::infinity();
  return static_cast<double>(abs(HundredDigits(value) / expected - 1));
}

/// Largest errors over several chains with the same range of stiffnesses, in double and single
/// precision.
struct ChainErrors {
  double inDouble = 0.0;
  double inFloat = 0.0;
};

/// The largest errors, one entry per build.
std::vector<ChainErrors> worstChains(int elements, int decades, int chains) {
  std::mt19937_64 random(static_cast<std::uint64_t>(elements) * 101 + decades);
  std::uniform_real_distribution<double> exponent(-decades, decades);
  const auto kernels = availableKernels();
  std::vector<ChainErrors> worst(kernels.size());
  for (int chain = 0; chain < chains; ++chain) {
    std::vector<float> k32(static_cast<std::size_t>(elements));
    for (auto& k : k32) k = static_cast<float>(std::pow(10.0, exponent(random)));
    const std::vector<double> k(k32.begin(), k32.end());
    const int element = std::uniform_int_distribution<int>(0, elements - 1)(random);
    // Keep the tool at least half an element from the ends, as StringReference requires.
    const double tool = std::clamp(element + 0.625, 0.5, elements - 0.5);
    const StringReference reference(k, tool);
    for (std::size_t i = 0; i < kernels.size(); ++i) {
      worst[i].inDouble = std::max(
          worst[i].inDouble,
          relativeError(kernels[i]->chainStiffness(k.data(), elements, tool), reference.stiffness));
      worst[i].inFloat = std::max(
          worst[i].inFloat,
          relativeError(
              static_cast<double>(
                  kernels[i]->chainStiffnessFloat(k32.data(), elements, static_cast<float>(tool))),
              reference.stiffness));
    }
  }
  return worst;
}

void sweepEnds(SweepChecks& checks) {
  // One element of stiffness 0 or infinity: the force must be 0, or that of the other side.
  constexpr double kInfinite = std::numeric_limits<double>::infinity();
  for (const auto* kernels : availableKernels()) {
    int wrong = 0;
    for (const double extreme : {0.0, 1e-308, 1e308, kInfinite}) {
      for (int where = 0; where < 5; ++where) {
        std::vector<double> k(5, 1.0);
        k[static_cast<std::size_t>(where)] = extreme;
        const double stiffness = kernels->chainStiffness(k.data(), 5, 2.625);
        wrong += std::isnan(stiffness) || stiffness < 0.0 ? 1 : 0;
      }
    }
    checks.add(
        "k → 0 and ∞: stiffnesses that are none",
        0.0,
        static_cast<double>(wrong),
        0.0,
        kernels->name);
  }
}

}  // namespace

void sweepFiniteElements(double effort, StabilityResult& result) {
  SweepChecks checks(result, "finite elements");
  constexpr double kDoubleBound = 4e-15;  // 18 units in the last place
  constexpr double kFloatBound = 1e-6;    // 8 units in the last place
  const auto kernels = availableKernels();
  for (const int elements : {1, 2, 5, 15, 100, 1000, 12'445}) {
    const int chains = scaledCount(effort, elements > 1000 ? 1 : elements > 100 ? 4 : 40);
    for (const int decades : {1, 2, 3, 4, 6, 8, 10, 12}) {
      if (elements > 1000 && decades % 6 != 0) continue;
      const auto worst = worstChains(elements, decades, chains);
      for (std::size_t i = 0; i < kernels.size(); ++i) {
        const std::string n = "N = " + std::to_string(elements);
        checks.add(
            n + ": relative error, double",
            static_cast<double>(decades),
            worst[i].inDouble,
            kDoubleBound,
            kernels[i]->name,
            elements);
        checks.add(
            n + ": relative error, float",
            static_cast<double>(decades),
            worst[i].inFloat,
            kFloatBound,
            kernels[i]->name,
            elements);
      }
    }
  }
  sweepEnds(checks);
}

namespace {

struct StateTally {
  long steps = 0;
  long negative = 0;
  long notFinite = 0;
};

/// Runs filters with random noise and steps over 10^±decades, with correlations up to 0.999, in all
/// four schemes.
StateTally stressTestAll(
    const StabilityKernels& kernels, double decades, bool hasProcess, bool isFloat, int filters) {
  std::mt19937_64 random(20261121);
  std::uniform_real_distribution<double> exponent(-decades, decades);
  std::uniform_real_distribution<double> correlation(-0.999, 0.999);
  const auto magnitude = [&] { return std::pow(10.0, exponent(random)); };
  std::array<double, 200> travelled{};
  StateTally tally;
  for (int i = 0; i < filters; ++i) {
    FilterStressTest a{.rElastic = magnitude(), .rRecorded = magnitude(), .scheme = i % 4};
    a.q11 = hasProcess ? magnitude() : 0.0;
    a.q22 = hasProcess ? magnitude() : 0.0;
    a.q12 = correlation(random) * std::sqrt(a.q11) * std::sqrt(a.q22);
    for (auto& d : travelled) d = magnitude() * (random() % 2 == 0 ? 1.0 : -1.0);
    a.travelled = travelled.data();
    a.steps = static_cast<long>(travelled.size());
    const auto verdict = isFloat ? kernels.stressTestFloat(a) : kernels.stressTest(a);
    if (verdict.isNoiseRefused) continue;
    tally.steps += a.steps;
    tally.negative += verdict.negative;
    tally.notFinite += verdict.notFinite;
  }
  return tally;
}

/// Drift of the force with a resting hand over @p steps steps, e.g. an hour at 1 kHz [N].
double driftAtRest(const StabilityKernels& kernels, int scheme, long steps) {
  FilterStressTest a{
      .q11 = 6.1024,
      .q12 = 0.2772,
      .q22 = 7.0275,
      .rElastic = 0.001,
      .rRecorded = 7.742,
      .scheme = scheme,
      .steps = 1000,
      .isResting = true};
  const double soon = kernels.stressTest(a).force;
  a.steps = steps;
  const double late = kernels.stressTest(a).force;
  return std::isfinite(late) ? std::abs(late - soon) : std::numeric_limits<double>::infinity();
}

}  // namespace

void sweepFilter(double effort, StabilityResult& result) {
  SweepChecks checks(result, "Kalman filter");
  for (const auto* kernels : availableKernels()) {
    for (const double decades : {1.0, 3.0, 6.0, 9.0, 12.0}) {
      for (const bool hasProcess : {true, false}) {
        const std::string q = hasProcess ? "" : ", Q = 0";
        const auto inDouble =
            stressTestAll(*kernels, decades, hasProcess, false, scaledCount(effort, 600));
        const auto inFloat =
            stressTestAll(*kernels, decades, hasProcess, true, scaledCount(effort, 600));
        checks.add(
            "negative variances, double" + q,
            decades,
            static_cast<double>(inDouble.negative),
            0.0,
            kernels->name);
        checks.add(
            "forces that are no number, double" + q,
            decades,
            static_cast<double>(inDouble.notFinite),
            0.0,
            kernels->name);
        checks.add(
            "negative variances, float" + q,
            decades,
            static_cast<double>(inFloat.negative),
            0.0,
            kernels->name);
      }
    }
    for (int scheme = 0; scheme < 4; ++scheme) {
      const auto steps = static_cast<long>(3.6e6 * std::min(1.0, effort * 4.0));
      checks.add(
          "Δθ = 0 for an hour: drift of the force [N], variant " + std::to_string(scheme + 1),
          0.0,
          driftAtRest(*kernels, scheme, steps),
          scheme == 0 ? 1.0 : 1e-3,
          kernels->name);
    }
    // Invalid noise must be refused: an indefinite Q, R < 0, Q = R = 0, values that are not finite.
    int accepted = 0;
    const FilterStressTest unsound[]{
        {.q11 = 1.0, .q12 = 2.0, .q22 = 1.0, .rElastic = 1.0, .rRecorded = 1.0},
        {.q11 = 1.0, .q22 = 1.0, .rElastic = -1e-9, .rRecorded = 1.0},
        {.q11 = 0.0, .q22 = 0.0, .rElastic = 0.0, .rRecorded = 0.0},
        {.q11 = -1.0, .q22 = 1.0, .rElastic = 1.0, .rRecorded = 1.0},
        {.q11 = NAN, .q22 = 1.0, .rElastic = 1.0, .rRecorded = 1.0},
        {.q11 = 1.0, .q22 = 1.0, .rElastic = INFINITY, .rRecorded = 1.0}};
    for (const auto& test : unsound) accepted += kernels->stressTest(test).isNoiseRefused ? 0 : 1;
    checks.add("noise that is none, accepted", 0.0, accepted, 0.0, kernels->name);
    // 1e155 squared overflows: the filter may fail, but must not return a finite, plausible force.
    const double leap = 1e155;
    FilterStressTest far{
        .q11 = 1.0,
        .q22 = 1.0,
        .rElastic = 1.0,
        .rRecorded = 1.0,
        .scheme = 2,
        .travelled = &leap,
        .steps = 1};
    const auto verdict = kernels->stressTest(far);
    const bool isSane = verdict.notFinite > 0 || (verdict.force >= 2.0 && verdict.force <= 3.0);
    checks.add(
        "Δθ = 1e155: a wrong force that looks right",
        155.0,
        isSane ? 0.0 : 1.0,
        0.0,
        kernels->name);
  }
}

void sweepSplines(double effort, StabilityResult& result) {
  SweepChecks checks(result, "splines");
  std::mt19937_64 random(5);
  for (const auto* kernels : availableKernels()) {
    for (const double decades : {0.0, 3.0, 9.0, 15.0, 100.0, 300.0}) {
      std::uniform_real_distribution<double> exponent(-decades, decades);
      int wrong = 0;
      const int cases = scaledCount(effort, 20'000);
      for (int i = 0; i < cases; ++i) {
        const double x = std::pow(10.0, exponent(random));
        const double a[3]{0.0, std::pow(10.0, exponent(random)), 0.0};
        const double b[3]{x, a[1] + std::pow(10.0, exponent(random)), 0.0};
        double force = 0.0;
        const double at = x * std::uniform_real_distribution<double>(0.0, 1.0)(random);
        if (!kernels->cubic(a, b, at, force)) continue;  // refused
        const double slack = 1e-12 * std::max(std::abs(a[1]), std::abs(b[1]));
        const bool isBetween = force >= a[1] - slack && force <= b[1] + slack;
        wrong += isBetween ? 0 : 1;
      }
      checks.add(
          "forces outside of their two nodes, slopes 0",
          decades,
          static_cast<double>(wrong),
          0.0,
          kernels->name);
    }
    // Two nodes at the same position have no slope between them.
    const double a[3]{1.0, 2.0, 0.0};
    const double b[3]{1.0, 3.0, 0.0};
    double force = 0.0;
    checks.add(
        "coincident nodes, accepted",
        0.0,
        kernels->cubic(a, b, 1.0, force) ? 1.0 : 0.0,
        0.0,
        kernels->name);
  }
  // Monotone slopes for two, three and more nodes, some very close to each other.
  double worst = 0.0;
  for (int i = 0; i < scaledCount(effort, 2000); ++i) {
    const int count = 2 + i % 11;
    std::vector<double> xs{0.0};
    std::vector<double> ys{0.0};
    for (int k = 1; k < count; ++k) {
      xs.push_back(xs.back() + std::exp(std::uniform_real_distribution<double>(-25, 0)(random)));
      ys.push_back(ys.back() + std::exp(std::uniform_real_distribution<double>(-9, 6)(random)));
    }
    const auto slopes = reaming::monotoneSlopes(xs, ys);
    for (int k = 0; k + 1 < count; ++k) {
      const auto n = static_cast<std::size_t>(k);
      const double a[3]{xs[n], ys[n], slopes[n]};
      const double b[3]{xs[n + 1], ys[n + 1], slopes[n + 1]};
      for (double t = 0.0; t <= 1.0; t += 0.05) {
        double force = 0.0;
        if (!plainKernels().cubic(a, b, a[0] + t * (b[0] - a[0]), force)) continue;
        const double beyond = std::max({a[1] - force, force - b[1], 0.0});
        worst = std::max(worst, beyond / ys.back());
      }
    }
  }
  checks.add("overshoot of 2 to 12 crowded nodes, of the largest force", 0.0, worst, 1e-12);
}

}  // namespace haptics::bench
