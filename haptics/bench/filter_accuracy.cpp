// From a measured series to nodes: what each way costs and how far it is from the noiseless curve.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <vector>

#include "haptics/bench/measurement.h"
#include "haptics/reaming/material/low_pass.h"
#include "haptics/reaming/material/node_choice.h"
#include "haptics/reaming/material/sampled_curve.h"
#include "haptics/reaming/material/synthetic_series.h"

namespace haptics::bench {
namespace {

using reaming::CutoffRule;
using reaming::NodeRule;

constexpr const char* kFilterFamily = "filter";

template <typename Work>
double nanoseconds(Work work) {
  std::vector<double> times;
  for (int i = 0; i < 7; ++i) {
    const auto start = std::chrono::steady_clock::now();
    work();
    times.push_back(
        std::chrono::duration<double, std::nano>(std::chrono::steady_clock::now() - start).count());
  }
  std::sort(times.begin(), times.end());
  return times[times.size() / 2];
}

double rms(const std::vector<double>& a, const std::vector<double>& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += (a[i] - b[i]) * (a[i] - b[i]);
  return std::sqrt(sum / static_cast<double>(a.size()));
}

/// The best that any cut-off does, by trying many.
double oracle(const reaming::Series& series, const reaming::Series& truth) {
  double best = rms(series.force, truth.force);
  for (double cutoff = 0.005; cutoff < 20.0; cutoff *= 1.15) {
    best = std::min(
        best, rms(reaming::zeroPhaseLowPass(series.force, series.rate, cutoff), truth.force));
  }
  return best;
}

void measureCutoffs(const Report& report) {
  const reaming::SyntheticTest test{.hardness = 0.5, .seed = 7};
  const auto series = reaming::syntheticSeries(test);
  const auto truth = reaming::noiselessSeries(test);
  const auto samples = static_cast<double>(series.force.size());
  const auto add = [&](const char* method, double error, double time) {
    report(
        {.family = kFilterFamily,
         .setting = "cut-off and low-pass, RMS from the noiseless curve [N]",
         .method = method,
         .parameter = samples,
         .error = error,
         .time = Timing{time, time}});
  };
  for (const auto rule : {CutoffRule::Floor, CutoffRule::Plain}) {
    std::vector<double> filtered;
    const double time = nanoseconds([&] {
      const double cutoff = reaming::cutoffOf(series.force, series.rate, rule);
      filtered = reaming::zeroPhaseLowPass(series.force, series.rate, cutoff);
    });
    add(rule == CutoffRule::Floor ? "detrended-hann" : "plain", rms(filtered, truth.force), time);
  }
  add("the best of all cut-offs", oracle(series, truth), 0.0);
}

/// 2000 s at 100 Hz: so long that a slow way shows. A prime count, which is no trap.
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

void measurePreparation(const Report& report) {
  const auto series = longSeries();
  const double prepare = nanoseconds([&] {
    const double cutoff = reaming::cutoffOf(series.force, series.rate, CutoffRule::Floor);
    const auto filtered = reaming::zeroPhaseLowPass(series.force, series.rate, cutoff);
    const auto curve = reaming::normalised(reaming::curveOver(series.displacement, filtered), 2001);
    return reaming::chooseNodes(curve, 0.05, 10.0, NodeRule::Greedy).nodes.size();
  });
  report(
      {.family = kFilterFamily,
       .setting = "199,999 samples: cut-off, filter, nodes",
       .method = "palpate",
       .parameter = 199'999,
       .error = std::nullopt,
       .time = Timing{prepare, prepare}});
}

/// An analytic curve of 200,000 samples: nodes for an error, and the optimum as certificate where
/// it can be had.
void measureNodes(const Report& report) {
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
    const auto add = [&](const char* method, std::size_t nodes, double time) {
      report(
          {.family = kFilterFamily,
           .setting = "nodes for an error",
           .method = method,
           .parameter = wanted,
           .error = static_cast<double>(nodes),
           .time = Timing{time, time}});
    };
    std::size_t nodes = 0;
    const double greedy = nanoseconds(
        [&] { nodes = reaming::chooseNodes(many, wanted, 10.0, NodeRule::Greedy).nodes.size(); });
    add("greedy, 200,000 samples", nodes, greedy);
    const auto start = std::chrono::steady_clock::now();
    nodes = reaming::chooseNodes(few, wanted, 10.0, NodeRule::Optimal).nodes.size();
    add("optimal, 1000 samples",
        nodes,
        std::chrono::duration<double, std::nano>(std::chrono::steady_clock::now() - start).count());
  }
}

}  // namespace

void measureFilter(const Report& report) {
  measureCutoffs(report);
  measurePreparation(report);
  measureNodes(report);
}

}  // namespace haptics::bench
