#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>

#include "haptics/bench/measurement.h"
#include "haptics/bench/peers/peers.h"
#include "haptics/bench/string_reference.h"
#include "haptics/models/kalman_filter.h"

namespace haptics::bench {
namespace {

constexpr const char* kKalmanFamily = "Kalman filter";
using models::KalmanScheme;
using peers::KalmanNoiseValues;

template <typename Scalar>
models::KalmanNoise<Scalar> noiseOf(const KalmanNoiseValues& n) {
  return {
      .processForce = Scalar(n.q11),
      .processCovariance = Scalar(n.q12),
      .processStiffness = Scalar(n.q22),
      .finiteElements = Scalar(n.rElastic),
      .interpolation = Scalar(n.rRecorded),
      .wandering = Scalar(n.q22)};
}

/// Palpate's filter, with the interface of the other filters.
template <typename Scalar>
struct OurFilter {
  models::KalmanFilter<Scalar> filter;

  explicit OurFilter(const KalmanNoiseValues& n, KalmanScheme scheme = KalmanScheme::Sequential)
      : filter(noiseOf<Scalar>(n).factored(), scheme) {}
  Scalar step(Scalar d, Scalar elastic, Scalar recorded) {
    return filter.step(d, elastic, recorded);
  }
};

/// Palpate's covariance class in the textbook's steps, from the same initial P as the other
/// filters.
template <typename Scalar>
struct OurCovariance {
  models::FactoredCovariance<Scalar> p;
  models::FactoredVariances<Scalar> q;
  Scalar f{}, z{};
  KalmanNoiseValues n;

  explicit OurCovariance(const KalmanNoiseValues& noiseValues)
      : q(noiseOf<Scalar>(noiseValues).factored().process), n(noiseValues) {
    p.set(models::FactoredVariances<Scalar>::of(
        Scalar(noiseValues.start11), Scalar(0), Scalar(noiseValues.start22)));
  }
  Scalar step(Scalar d, Scalar elastic, Scalar recorded) {
    f += z * d;
    p.predict(d, q);
    correct(elastic, Scalar(n.rElastic));
    correct(recorded, Scalar(n.rRecorded));
    return f;
  }
  bool hasNegativeVariance() const {
    return p.variances().force < Scalar(0) || p.variances().rest < Scalar(0);
  }

 private:
  void correct(Scalar measured, Scalar r) {
    const auto gain = p.correct(r);
    const Scalar innovation = measured - f;
    f += gain.force * innovation;
    z += gain.stiffness * innovation;
  }
};

template <typename Filter, typename Scalar>
Contestant contestant(std::string name, Filter filter) {
  return {std::move(name), [filter](int steps) mutable {
            Scalar force{};
            for (int i = 0; i < steps; ++i) {
              force =
                  filter.step((i & 64) != 0 ? Scalar(0.02) : Scalar(-0.02), Scalar(3), Scalar(2));
            }
            return static_cast<double>(force);
          }};
}

void timeSteps(const AccuracyRun& run) {
  const KalmanNoiseValues n;
  std::vector<Contestant> contestants;
  contestants.push_back(
      contestant<OurFilter<double>, double>("palpate LDLᵀ", OurFilter<double>(n)));
  contestants.push_back(
      contestant<OurFilter<float>, float>("palpate LDLᵀ, float", OurFilter<float>(n)));
  contestants.push_back(contestant<peers::StandardFilter<double>, double>(
      "standard, scalar", peers::StandardFilter<double>(n)));
  contestants.push_back(contestant<peers::JosephFilter<double>, double>(
      "Joseph, scalar", peers::JosephFilter<double>(n)));
  contestants.push_back(
      {"Eigen, fixed size", [n](int steps) { return peers::eigenFixed(n, steps, 0.02); }});
  contestants.push_back(
      {"Eigen, dynamic size", [n](int steps) { return peers::eigenDynamic(n, steps, 0.02); }});
  const std::pair<const char*, KalmanScheme> schemes[]{
      {"palpate, paper-text", KalmanScheme::PaperText},
      {"palpate, authors-firmware", KalmanScheme::AuthorsFirmware},
      {"palpate, space-domain", KalmanScheme::SpaceDomain}};
  for (const auto& [name, scheme] : schemes) {
    contestants.push_back(
        contestant<OurFilter<double>, double>(name, OurFilter<double>(n, scheme)));
  }
  constexpr int kColdRounds = 31;
  const auto warm = run.times(contestants);
  const auto cold = run.coldTimes(contestants, kColdRounds);
  for (std::size_t i = 0; i < contestants.size(); ++i) {
    for (const bool isCold : {false, true}) {
      run.report(
          {.family = kKalmanFamily,
           .setting = isCold ? "a step, cold" : "a step",
           .method = contestants[i].method,
           .parameter = 1.0,
           .time = isCold ? cold[i] : warm[i]});
    }
  }
}

/// Draws random noise and steps of magnitudes over 10^±decades.
struct HostileInput {
  std::mt19937_64 random;
  double decades;

  double magnitude() {
    return std::pow(10.0, std::uniform_real_distribution<double>(-decades, decades)(random));
  }
  KalmanNoiseValues noiseValues() {
    // No process noise: it would hide the rounding errors in which the forms of the update differ.
    return {0.0, 0.0, 0.0, magnitude(), magnitude(), magnitude(), magnitude()};
  }
  double travelled() { return magnitude() * (random() % 2 == 0 ? 1.0 : -1.0); }
};

struct Tally {
  std::vector<double> errors;
  std::int64_t negative = 0;
  std::int64_t steps = 0;
};

template <typename Filter>
void tallyErrors(
    Filter filter,
    const std::vector<double>& travelled,
    const std::vector<double>& expected,
    Tally& tally) {
  for (std::size_t i = 0; i < travelled.size(); ++i) {
    using Scalar = decltype(filter.step(1.0F, 1.0F, 1.0F));
    const auto force =
        static_cast<double>(filter.step(static_cast<Scalar>(travelled[i]), Scalar(3), Scalar(2)));
    const double error = std::abs(force / expected[i] - 1.0);
    tally.errors.push_back(std::isfinite(error) ? error : 1e300);
    tally.negative += filter.hasNegativeVariance() ? 1 : 0;
    ++tally.steps;
  }
}

/// Reports the 99 % quantile of the relative error of the force, and how often a variance was
/// negative.
void reportErrorsOnHostileInput(double decades, const AccuracyRun& run) {
  constexpr int kFilters = 60;
  constexpr int kSteps = 40;
  HostileInput hostile{std::mt19937_64(7), decades};
  const std::vector<std::string> names{
      "palpate LDLᵀ",
      "palpate LDLᵀ, float",
      "standard, scalar",
      "Joseph, scalar",
      "standard, scalar, float",
      "Joseph, scalar, float"};
  constexpr std::size_t kPalpateFilters = 2;  // the first in names
  std::vector<Tally> tallies(names.size());
  for (int i = 0; i < kFilters; ++i) {
    const auto n = hostile.noiseValues();
    std::vector<double> travelled(kSteps);
    for (auto& d : travelled) d = static_cast<double>(static_cast<float>(hostile.travelled()));
    // The reference is the standard form with 100 digits.
    peers::StandardFilter<HundredDigits> reference(n);
    std::vector<double> expected;
    for (const double d : travelled) {
      expected.push_back(static_cast<double>(reference.step(d, 3, 2)));
    }
    tallyErrors(OurCovariance<double>(n), travelled, expected, tallies[0]);
    tallyErrors(OurCovariance<float>(n), travelled, expected, tallies[1]);
    tallyErrors(peers::StandardFilter<double>(n), travelled, expected, tallies[2]);
    tallyErrors(peers::JosephFilter<double>(n), travelled, expected, tallies[3]);
    tallyErrors(peers::StandardFilter<float>(n), travelled, expected, tallies[4]);
    tallyErrors(peers::JosephFilter<float>(n), travelled, expected, tallies[5]);
  }
  for (std::size_t i = 0; i < names.size(); ++i) {
    auto& errors = tallies[i].errors;
    std::ranges::sort(errors);
    const double p99 =
        errors[static_cast<std::size_t>(0.99 * static_cast<double>(errors.size() - 1))];
    run.report(
        {.family = kKalmanFamily,
         .setting = "Q = 0, relative error",
         .method = names[i],
         .parameter = decades,
         .error = p99});
    run.report(
        {.family = kKalmanFamily,
         .setting = "Q = 0, negative variances of 100 steps",
         .method = names[i],
         .parameter = decades,
         .error = 100.0 * static_cast<double>(tallies[i].negative) /
                  static_cast<double>(tallies[i].steps),
         .bound = i < kPalpateFilters ? std::optional(0.0) : std::nullopt});
  }
}

}  // namespace

void measureKalmanFilter(const AccuracyRun& run) {
  if (!run.isShortRun) timeSteps(run);
  for (const double decades : {1.0, 2.0, 3.0, 4.0, 6.0, 9.0, 12.0})
    reportErrorsOnHostileInput(decades, run);
}

}  // namespace haptics::bench
