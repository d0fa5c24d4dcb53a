// Filtering of series and choice of nodes: error and run time of several methods.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <vector>

#include "haptics/bench/measurement.h"
#include "haptics/filters/averages.h"
#include "haptics/filters/low_pass.h"
#include "haptics/filters/spectrum.h"
#include "haptics/reaming/material/node_choice.h"
#include "haptics/reaming/material/sampled_curve.h"
#include "haptics/reaming/material/synthetic_series.h"

namespace haptics::bench {
namespace {

using filters::CutoffRule;
using reaming::NodeRule;

constexpr const char* kFilterFamily = "filter";
// Largest allowed ratio of the error with the automatic cut-off to that with the best cut-off, and
// of the number of greedy nodes to the smallest possible number.
constexpr double kMostTimesTheBestCutoff = 4.0;
constexpr double kMostTimesTheFewestNodes = 2.0;

/// The median time of several repetitions [ns].
template <typename Work>
double medianNanoseconds(Work work, int repetitions = 7) {
  std::vector<double> times;
  for (int i = 0; i < repetitions; ++i) {
    const auto start = std::chrono::steady_clock::now();
    work();
    times.push_back(nanosecondsSince(start));
  }
  return filters::upperMedian(times);
}

/// The smallest error of many cut-offs, compared with the noiseless curve.
double bestOfAllCutoffs(const reaming::Series& series, const reaming::Series& truth) {
  double best = filters::rmsDifference(series.force, truth.force);
  for (double cutoff = 0.005; cutoff < 20.0; cutoff *= 1.15) {
    best = std::min(
        best,
        filters::rmsDifference(
            filters::zeroPhaseLowPass(series.force, series.rate, cutoff), truth.force));
  }
  return best;
}

void measureCutoffs(const AccuracyRun& run) {
  const reaming::SyntheticTest test{.hardness = 0.5, .seed = 7};
  const auto series = reaming::syntheticSeries(test);
  const auto truth = reaming::noiselessSeries(test);
  const auto samples = static_cast<double>(series.force.size());
  const auto add = [&](const char* method, double error, std::optional<double> bound, double time) {
    run.report(
        {.family = kFilterFamily,
         .setting = "cut-off and low-pass, RMS from the noiseless curve [N]",
         .method = method,
         .parameter = samples,
         .error = error,
         .bound = bound,
         .time = Timing{time, time}});
  };
  const double best = bestOfAllCutoffs(series, truth);
  for (const auto rule : {CutoffRule::Floor, CutoffRule::Plain}) {
    std::vector<double> filtered;
    const double time = medianNanoseconds([&] {
      const double cutoff = filters::cutoffOf(series.force, series.rate, rule);
      filtered = filters::zeroPhaseLowPass(series.force, series.rate, cutoff);
    });
    const bool isOurs = rule == CutoffRule::Floor;
    add(isOurs ? "detrended-hann" : "plain",
        filters::rmsDifference(filtered, truth.force),
        isOurs ? std::optional(kMostTimesTheBestCutoff * best) : std::nullopt,
        time);
  }
  add("the best of all cut-offs", best, std::nullopt, 0.0);
}

/// A series of 2000 s at 100 Hz. The number of samples is prime, the worst case of a fast Fourier
/// transform.
reaming::Series longSeries() {
  auto series = reaming::syntheticSeries({.hardness = 0.5, .feed = 0.01e-3, .seed = 3});
  constexpr std::size_t kSamples = 199'999;
  while (series.force.size() < kSamples) {
    series.force.push_back(series.force.back());
    series.displacement.push_back(series.displacement.back() + 1e-10);
  }
  series.force.resize(kSamples);
  series.displacement.resize(kSamples);
  return series;
}

void measurePreparation(const AccuracyRun& run) {
  const auto series = longSeries();
  const double prepare = medianNanoseconds([&] {
    const double cutoff = filters::cutoffOf(series.force, series.rate, CutoffRule::Floor);
    const auto filtered = filters::zeroPhaseLowPass(series.force, series.rate, cutoff);
    const auto curve = reaming::normalised(reaming::curveOver(series.displacement, filtered), 2001);
    return reaming::chooseNodes(curve, reaming::NodeCriterion()).nodes.size();
  });
  run.report(
      {.family = kFilterFamily,
       .setting = "199,999 samples: cut-off, filter, nodes",
       .method = "palpate",
       .parameter = 199'999,
       .error = std::nullopt,
       .time = Timing{prepare, prepare}});
}

/// Choice of nodes for an analytic curve of 200,000 samples, compared with the fewest possible,
/// which dynamic programming finds for 1000 samples.
void measureNodes(const AccuracyRun& run) {
  const auto curveOf = [](std::size_t count) {
    reaming::SampledCurve curve;
    for (std::size_t i = 0; i < count; ++i) {
      const double x = 0.02 * static_cast<double>(i) / static_cast<double>(count - 1);
      const double mm = 1000.0 * x;
      const auto step = [&](double at, double width) {
        return 1.0 / (1.0 + std::exp(-(mm - at) / width));
      };
      curve.x.push_back(x);
      curve.y.push_back(
          110.0 * step(3.6, 0.3) - 45.0 * step(5.2, 0.35) + 9.0 * std::max(0.0, mm - 3.6) +
          0.9 * std::pow(std::max(0.0, mm - 3.6), 2.0));
    }
    return curve;
  };
  const auto many = curveOf(200'000);
  const auto few = curveOf(1000);
  for (const double wanted : {0.41, 0.14, 0.05, 0.01}) {
    const auto add =
        [&](const char* method, double nodes, std::optional<double> bound, double time) {
          run.report(
              {.family = kFilterFamily,
               .setting = "nodes for an error",
               .method = method,
               .parameter = wanted,
               .error = nodes,
               .bound = bound,
               .time = Timing{time, time}});
        };
    const auto count = [&](const reaming::SampledCurve& curve, NodeRule rule) {
      const reaming::NodeCriterion nodeCriterion{.rule = rule, .error = wanted};
      return static_cast<double>(reaming::chooseNodes(curve, nodeCriterion).nodes.size());
    };
    double greedy = 0.0;
    const double time = medianNanoseconds([&] { greedy = count(many, NodeRule::Greedy); });
    double optimal = 0.0;
    const double timeOfOptimal =
        medianNanoseconds([&] { optimal = count(few, NodeRule::Optimal); }, 1);
    add("greedy, 200,000 samples", greedy, kMostTimesTheFewestNodes * optimal, time);
    add("optimal, 1000 samples", optimal, std::nullopt, timeOfOptimal);
  }
}

}  // namespace

void measureFilter(const AccuracyRun& run) {
  measureCutoffs(run);
  if (!run.isShortRun) measurePreparation(run);
  measureNodes(run);
}

}  // namespace haptics::bench
