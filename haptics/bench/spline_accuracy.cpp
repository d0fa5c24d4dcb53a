#include <algorithm>
#include <cmath>
#include <memory>
#include <random>
#include <span>

#include "haptics/bench/measurement.h"
#include "haptics/bench/peers/peers.h"
#include "haptics/engine/bucket_table.h"
#include "haptics/models/hermite_curve.h"
#include "haptics/models/interpolation.h"
#include "haptics/reaming/material/spline.h"

namespace haptics::bench {
namespace {

constexpr const char* kSplineFamily = "splines";
constexpr const char* kPalpatePchip = "palpate PCHIP";
constexpr const char* kLowerBound = "floor: one Horner";
constexpr double kEnd = 20.0;  // [mm]

/// Force [N] over depth [mm] of a smooth curve that resembles reaming: no force, the peak of the
/// lamella, a rise.
double forceAt(double x) {
  const double step = 1.0 / (1.0 + std::exp(-(x - 4.0) / 0.35));
  const double peak = std::exp(-(x - 5.0) * (x - 5.0) / 0.5);
  return 260.0 * step + 70.0 * peak + 1.2 * x * x;
}

double slopeAt(double x) {
  const double step = 1.0 / (1.0 + std::exp(-(x - 4.0) / 0.35));
  const double peak = std::exp(-(x - 5.0) * (x - 5.0) / 0.5);
  return 260.0 * step * (1.0 - step) / 0.35 - 4.0 * (x - 5.0) * 70.0 * peak + 2.4 * x;
}

/// Nearly evenly spaced nodes, as in measured data.
std::vector<double> jitteredNodes(int count) {
  std::mt19937_64 random(static_cast<std::uint64_t>(count));
  std::uniform_real_distribution<double> jitter(-0.3, 0.3);
  std::vector<double> xs;
  for (int i = 0; i < count; ++i) {
    const bool isEnd = i == 0 || i == count - 1;
    xs.push_back(kEnd * (i + (isEnd ? 0.0 : jitter(random))) / (count - 1));
  }
  return xs;
}

using peers::Spline;

/// Palpate's cubics between nodes with given slopes.
Spline cubics(
    const std::string& name,
    const std::vector<double>& xs,
    const std::vector<double>& ys,
    const std::vector<double>& slopes) {
  struct Nodes {
    explicit Nodes(const std::vector<double>& xs) : table(xs) {}
    engine::BucketTable table;
    std::vector<models::CubicSegment<double>> segments;
  };
  const auto nodes = std::make_shared<Nodes>(xs);
  for (std::size_t i = 0; i + 1 < xs.size(); ++i) {
    nodes->segments.push_back(models::CubicSegment<double>::between(
        {xs[i], ys[i], slopes[i]}, {xs[i + 1], ys[i + 1], slopes[i + 1]}));
  }
  const models::HermiteCurve<double> curve(
      nodes->segments.data(), nodes->segments.size(), nodes->table.index());
  return peers::splineOf(name, [nodes, curve, hint = std::size_t{0}](double x) mutable {
    return curve.at(x, hint).force;
  });
}

Spline straightLines(const std::vector<double>& xs, const std::vector<double>& ys) {
  struct Nodes {
    explicit Nodes(const std::vector<double>& xs) : table(xs) {}
    engine::BucketTable table;
    std::vector<models::CurveNode<double>> nodes;
  };
  const auto nodes = std::make_shared<Nodes>(xs);
  for (std::size_t i = 0; i < xs.size(); ++i) nodes->nodes.push_back({xs[i], ys[i]});
  const models::Interpolation<double> curve(
      nodes->nodes.data(), nodes->nodes.size(), {}, nodes->table.index());
  return peers::splineOf(
      "palpate straight lines",
      [nodes, curve, hint = std::size_t{0}](double x) mutable { return curve.at(x, hint).force; });
}

/// Palpate's splines, those of other libraries, and a single cubic without a search as the lower
/// bound of the time.
std::vector<Spline> allSplines(int count) {
  const auto xs = jitteredNodes(count);
  std::vector<double> ys;
  std::vector<double> slopes;
  for (const double x : xs) {
    ys.push_back(forceAt(x));
    slopes.push_back(slopeAt(x));
  }
  auto all = peers::splinePeers(xs, ys);
  all.push_back(straightLines(xs, ys));
  all.push_back(cubics(kPalpatePchip, xs, ys, reaming::monotoneSlopes(xs, ys)));
  all.push_back(cubics("palpate Hermite", xs, ys, slopes));
  all.push_back(peers::splineOf(
      kLowerBound, [](double x) { return 1.0 + x * (2.0 + x * (0.3 + x * 0.01)); }));
  return all;
}

double largestError(const Spline& spline) {
  constexpr int kPoints = 20'000;
  double largest = 0.0;
  // x is never exactly 0 or kEnd: some libraries refuse the ends of a spline.
  for (int i = 0; i < kPoints; ++i) {
    const double x = kEnd * (i + 0.5) / kPoints;
    largest = std::max(largest, std::abs(spline.at(x) - forceAt(x)));
  }
  return largest;
}

std::vector<double> randomQueries() {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> anywhere(1e-9, kEnd - 1e-9);
  std::vector<double> xs(1 << 14);
  for (auto& x : xs) x = anywhere(random);
  return xs;
}

/// Positions of a hand that moves back and forth, each close to the last.
std::vector<double> coherentQueries() {
  std::vector<double> xs(1 << 14);
  for (std::size_t i = 0; i < xs.size(); ++i) {
    xs[i] = 1e-9 + (kEnd - 2e-9) * (0.5 - 0.5 * std::cos(0.001 * static_cast<double>(i)));
  }
  return xs;
}

/// A contestant that evaluates at @p xs cyclically.
Contestant contestant(const Spline& spline, const std::vector<double>& xs) {
  return {spline.name, [&spline, &xs, next = std::size_t{0}](int steps) mutable {
            double last = xs[next];  // the result for 0 steps
            auto left = static_cast<std::size_t>(steps);
            while (left > 0) {
              const std::size_t count = std::min(left, xs.size() - next);
              last = spline.sweep(std::span(xs).subspan(next, count));
              next = (next + count) % xs.size();
              left -= count;
            }
            return last;
          }};
}

void compareSplines(
    const std::string& setting,
    int nodes,
    const std::vector<double>& xs,
    bool isCold,
    const AccuracyRun& run) {
  const auto all = allSplines(nodes);
  std::vector<Contestant> contestants;
  for (const auto& spline : all) contestants.push_back(contestant(spline, xs));
  constexpr int kColdRounds = 41;
  const auto times = isCold ? run.coldTimes(contestants, kColdRounds) : run.times(contestants);
  const double boostError = largestError(all.front());
  for (std::size_t i = 0; i < all.size(); ++i) {
    Measurement m{
        .family = kSplineFamily,
        .setting = setting,
        .method = all[i].name,
        .parameter = static_cast<double>(nodes),
        .time = times[i]};
    if (m.method != kLowerBound) m.error = largestError(all[i]);
    // Palpate's curve equals Boost's up to rounding. Boost uses other slopes at the ends, which
    // matters with four nodes.
    if (m.method == kPalpatePchip && nodes > 4) m.bound = boostError * (1.0 + 1e-9);
    run.report(m);
  }
}

}  // namespace

void measureSplines(const AccuracyRun& run) {
  const auto random = randomQueries();
  for (const int nodes : {4, 8, 12, 32, 100, 316, 1000, 10'000}) {
    if (run.isShortRun && nodes > 316) break;
    compareSplines("random", nodes, random, false, run);
  }
  if (run.isShortRun) return;
  const auto coherent = coherentQueries();
  for (const int nodes : {12, 10'000}) {
    compareSplines("coherent", nodes, coherent, false, run);
    compareSplines("cold", nodes, random, true, run);
  }
}

}  // namespace haptics::bench
