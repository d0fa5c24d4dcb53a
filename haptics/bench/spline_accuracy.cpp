#include <algorithm>
#include <cmath>
#include <random>
#include <span>

#include "haptics/bench/measurement.h"
#include "haptics/bench/peers/spline_peers.h"
#include "haptics/engine/bucket_table.h"
#include "haptics/models/hermite_curve.h"
#include "haptics/models/interpolation.h"
#include "haptics/reaming/material/piecewise.h"

namespace haptics::bench {
namespace {

constexpr const char* kSplineFamily = "splines";
constexpr double kEnd = 20.0;  // [mm]

/// A curve of reaming's shape, all derivatives continuous: no force, a lamella that breaks, a rise.
/// Depth in mm, force in N.
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

/// As measured data lie: nearly, but not quite, evenly.
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

/// One of ours behind the peers' face.
class OurSpline final : public peers::SplinePeer {
 public:
  enum class Kind { DataSlopes, Monotone };

  OurSpline(Kind kind, bool hasHint, const std::vector<double>& xs, const std::vector<double>& ys)
      : kind_(kind), hasHint_(hasHint), table_(xs) {
    const auto slopes = kind == Kind::Monotone ? reaming::monotoneSlopes(xs, ys) : slopesAt(xs);
    for (std::size_t i = 0; i + 1 < xs.size(); ++i) {
      segments_.push_back(models::CubicSegment<double>::between(
          {xs[i], ys[i], slopes[i]}, {xs[i + 1], ys[i + 1], slopes[i + 1]}));
    }
  }

  std::string name() const override {
    return std::string(kind_ == Kind::Monotone ? "palpate PCHIP" : "palpate Hermite") +
           (hasHint_ ? "" : ", no hint");
  }
  double at(double x) const override {
    std::size_t hint = 0;
    return curve().at(x, hint).force;
  }
  double sweep(std::span<const double> xs) const override {
    const auto own = curve();
    std::size_t hint = 0;
    if (hasHint_) {
      return peers::oneAfterTheOther(xs, [&](double x) { return own.at(x, hint).force; });
    }
    return peers::oneAfterTheOther(xs, [&](double x) {
      std::size_t none = segments_.size();
      return own.at(x, none).force;
    });
  }

 private:
  static std::vector<double> slopesAt(const std::vector<double>& xs) {
    std::vector<double> slopes;
    for (const double x : xs) slopes.push_back(slopeAt(x));
    return slopes;
  }
  models::HermiteCurve<double> curve() const {
    return {segments_.data(), segments_.size(), table_.index()};
  }

  Kind kind_;
  bool hasHint_;
  engine::BucketTable table_;
  std::vector<models::CubicSegment<double>> segments_;
};

class OurLines final : public peers::SplinePeer {
 public:
  OurLines(const std::vector<double>& xs, const std::vector<double>& ys) : table_(xs) {
    for (std::size_t i = 0; i < xs.size(); ++i) nodes_.push_back({xs[i], ys[i]});
  }
  std::string name() const override { return "palpate straight lines"; }
  double at(double x) const override {
    std::size_t hint = 0;
    return curve().at(x, hint).force;
  }
  double sweep(std::span<const double> xs) const override {
    const auto own = curve();
    std::size_t hint = 0;
    return peers::oneAfterTheOther(xs, [&](double x) { return own.at(x, hint).force; });
  }

 private:
  models::Interpolation<double> curve() const {
    return {nodes_.data(), nodes_.size(), {}, table_.index()};
  }

  engine::BucketTable table_;
  std::vector<models::CurveNode<double>> nodes_;
};

/// The floor: one cubic by Horner's scheme, no search.
class OneCubic final : public peers::SplinePeer {
 public:
  std::string name() const override { return "floor: one Horner"; }
  double at(double x) const override { return 1.0 + x * (2.0 + x * (0.3 + x * 0.01)); }
  double sweep(std::span<const double> xs) const override {
    return peers::oneAfterTheOther(xs, [this](double x) { return at(x - 0.5); });
  }
};

using Peers = std::vector<std::unique_ptr<peers::SplinePeer>>;

Peers everybody(int nodes) {
  const auto xs = jitteredNodes(nodes);
  std::vector<double> ys;
  for (const double x : xs) ys.push_back(forceAt(x));
  auto all = peers::splinePeers(xs, ys);
  all.push_back(std::make_unique<OurLines>(xs, ys));
  all.push_back(std::make_unique<OurSpline>(OurSpline::Kind::Monotone, true, xs, ys));
  all.push_back(std::make_unique<OurSpline>(OurSpline::Kind::DataSlopes, false, xs, ys));
  all.push_back(std::make_unique<OurSpline>(OurSpline::Kind::DataSlopes, true, xs, ys));
  all.push_back(std::make_unique<OneCubic>());
  return all;
}

double largestError(const peers::SplinePeer& peer) {
  constexpr int kPoints = 20'000;
  double largest = 0.0;
  for (int i = 0; i < kPoints; ++i) {  // never quite the end, where peers may refuse
    const double x = kEnd * (i + 0.5) / kPoints;
    largest = std::max(largest, std::abs(peer.at(x) - forceAt(x)));
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

/// A hand that goes to and fro: next to where it was a tick ago.
std::vector<double> coherentQueries() {
  std::vector<double> xs(1 << 14);
  for (std::size_t i = 0; i < xs.size(); ++i) {
    xs[i] = 1e-9 + (kEnd - 2e-9) * (0.5 - 0.5 * std::cos(0.001 * static_cast<double>(i)));
  }
  return xs;
}

/// Steps through @p xs again and again.
Contestant contestant(const peers::SplinePeer& peer, const std::vector<double>& xs) {
  return {peer.name(), [&peer, &xs, next = std::size_t{0}](int steps) mutable {
            double last = xs[next];  // there, also where no step is made
            auto left = static_cast<std::size_t>(steps);
            while (left > 0) {
              const std::size_t count = std::min(left, xs.size() - next);
              last = peer.sweep(std::span(xs).subspan(next, count));
              next = (next + count) % xs.size();
              left -= count;
            }
            return last;
          }};
}

void raceAll(
    const std::string& setting,
    int nodes,
    const std::vector<double>& xs,
    bool isCold,
    bool hasErrors,
    const Report& report) {
  const auto all = everybody(nodes);
  std::vector<Contestant> contestants;
  for (const auto& peer : all) contestants.push_back(contestant(*peer, xs));
  constexpr int kColdRounds = 41;
  const auto timings = isCold ? raceCold(contestants, kColdRounds) : race(contestants);
  for (std::size_t i = 0; i < all.size(); ++i) {
    Measurement m{
        .family = kSplineFamily,
        .setting = setting,
        .method = all[i]->name(),
        .parameter = static_cast<double>(nodes),
        .time = timings[i]};
    const bool isFloor = i + 1 == all.size();
    if (hasErrors && !isFloor) m.error = largestError(*all[i]);
    report(m);
  }
}

}  // namespace

void measureSplines(const Report& report) {
  const auto random = randomQueries();
  const auto coherent = coherentQueries();
  for (const int nodes : {4, 8, 12, 32, 100, 316, 1000, 10'000}) {
    raceAll("random", nodes, random, false, true, report);
  }
  for (const int nodes : {12, 10'000}) {
    raceAll("coherent", nodes, coherent, false, false, report);
  }
  for (const int nodes : {12, 100, 10'000}) raceAll("cold", nodes, random, true, false, report);
}

}  // namespace haptics::bench
