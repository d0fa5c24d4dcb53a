#include "haptics/reaming/material/node_choice.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <queue>

#include "haptics/reaming/material/piecewise.h"

namespace haptics::reaming {
namespace {

/// A curve, its slopes, and how far a Hermite piece over some of it is off.
class Data {
 public:
  Data(const SampledCurve& curve, double floor)
      : curve_(curve), slopes_(dataSlopes(curve)), floor_(floor) {}

  std::size_t size() const { return curve_.size(); }
  const SampledCurve& curve() const { return curve_; }
  const std::vector<double>& slopes() const { return slopes_; }

  struct Worst {
    double error = 0.0;
    std::size_t at = 0;
  };

  /// Of the piece between two samples; stops looking where it is above @p enough.
  Worst worstBetween(
      std::size_t from,
      std::size_t to,
      double enough = std::numeric_limits<double>::infinity()) const {
    const auto piece = models::CubicSegment<double>::between(
        {curve_.x[from], curve_.y[from], slopes_[from]}, {curve_.x[to], curve_.y[to], slopes_[to]});
    Worst worst{.at = from + (to - from) / 2};
    for (std::size_t i = from + 1; i < to; ++i) {
      const double y = curve_.y[i];
      const double off = std::abs(piece.at(curve_.x[i]).force - y);
      const double error = off / std::max(std::abs(y), floor_);
      if (error > worst.error) worst = {error, i};
      if (worst.error > enough) break;
    }
    return worst;
  }

  double errorOf(const std::vector<std::size_t>& nodes) const {
    double worst = 0.0;
    for (std::size_t i = 0; i + 1 < nodes.size(); ++i) {
      worst = std::max(worst, worstBetween(nodes[i], nodes[i + 1]).error);
    }
    return worst;
  }

 private:
  const SampledCurve& curve_;
  std::vector<double> slopes_;
  double floor_;
};

/// A piece that may have to be split, the worst first.
struct Piece {
  double error = 0.0;
  std::size_t at = 0;
  std::size_t from = 0;
  std::size_t to = 0;

  bool operator<(const Piece& other) const { return error < other.error; }
};

std::vector<std::size_t> greedy(const Data& data, double wanted) {
  const auto pieceOf = [&](std::size_t from, std::size_t to) {
    const auto worst = data.worstBetween(from, to);
    return Piece{worst.error, worst.at, from, to};
  };
  std::priority_queue<Piece> pieces;
  pieces.push(pieceOf(0, data.size() - 1));
  std::vector<std::size_t> nodes{0, data.size() - 1};
  while (pieces.top().error > wanted) {
    const Piece worst = pieces.top();
    pieces.pop();
    // Never next to an end: a piece of one sample is no piece.
    const std::size_t at = std::clamp(worst.at, worst.from + 1, worst.to - 1);
    nodes.push_back(at);
    pieces.push(pieceOf(worst.from, at));
    pieces.push(pieceOf(at, worst.to));
  }
  std::sort(nodes.begin(), nodes.end());
  return nodes;
}

/// |f″| of each sample, by the slopes of its neighbours.
std::vector<double> curvatures(const Data& data) {
  const auto& x = data.curve().x;
  const auto& s = data.slopes();
  std::vector<double> result(data.size(), 0.0);
  for (std::size_t i = 1; i + 1 < data.size(); ++i) {
    result[i] = std::abs((s[i + 1] - s[i - 1]) / (x[i + 1] - x[i - 1]));
  }
  return result;
}

std::vector<std::size_t> above(
    const std::vector<double>& curvature, double threshold, bool isThinned) {
  std::vector<std::size_t> nodes{0};
  for (std::size_t i = 1; i + 1 < curvature.size(); ++i) {
    if (!(curvature[i] > threshold)) continue;
    std::size_t last = i;
    if (isThinned) {
      while (last + 2 < curvature.size() && curvature[last + 1] > threshold) ++last;
    }
    nodes.push_back(i + (last - i) / 2);
    i = last;
  }
  nodes.push_back(curvature.size() - 1);
  return nodes;
}

/// The threshold falls from the largest curvature on, by a hundredth part each time.
std::vector<std::size_t> byThreshold(const Data& data, double wanted, bool isThinned) {
  constexpr double kFall = 0.99;
  constexpr int kMostFalls = 3000;
  const auto curvature = curvatures(data);
  double threshold = *std::max_element(curvature.begin(), curvature.end());
  std::vector<std::size_t> best = above(curvature, threshold, isThinned);
  double bestError = data.errorOf(best);
  for (int fall = 0; fall < kMostFalls && bestError > wanted; ++fall) {
    threshold *= kFall;
    auto nodes = above(curvature, threshold, isThinned);
    if (nodes.size() == best.size() && !isThinned) continue;
    const double error = data.errorOf(nodes);
    if (error >= bestError && isThinned) continue;
    bestError = error;
    best = std::move(nodes);
  }
  return best;
}

/// Shortest path over the samples: an edge where one piece does it.
std::vector<std::size_t> optimal(const Data& data, double wanted) {
  const std::size_t n = data.size();
  constexpr auto kUnreached = std::numeric_limits<std::size_t>::max();
  std::vector<std::size_t> count(n, kUnreached);
  std::vector<std::size_t> before(n, 0);
  count[0] = 1;
  for (std::size_t from = 0; from + 1 < n; ++from) {
    if (count[from] == kUnreached) continue;
    for (std::size_t to = from + 1; to < n; ++to) {
      if (count[from] + 1 >= count[to]) continue;
      if (data.worstBetween(from, to, wanted).error > wanted) continue;
      count[to] = count[from] + 1;
      before[to] = from;
    }
  }
  std::vector<std::size_t> nodes;
  for (std::size_t at = n - 1; at != 0; at = before[at]) nodes.push_back(at);
  nodes.push_back(0);
  std::reverse(nodes.begin(), nodes.end());
  return nodes;
}

/// Every so many samples, so that at most @p most are left; indices into the whole.
std::vector<std::size_t> thinnedOut(std::size_t count, std::size_t most) {
  std::vector<std::size_t> kept;
  const std::size_t left = std::min(count, most);
  for (std::size_t i = 0; i < left; ++i) kept.push_back(i * (count - 1) / (left - 1));
  return kept;
}

std::vector<std::size_t> optimalOfThinned(const SampledCurve& curve, double wanted, double floor) {
  constexpr std::size_t kFeasible = 2000;
  const auto kept = thinnedOut(curve.size(), kFeasible);
  SampledCurve thin;
  for (const std::size_t i : kept) {
    thin.x.push_back(curve.x[i]);
    thin.y.push_back(curve.y[i]);
  }
  const Data data(thin, floor);
  std::vector<std::size_t> nodes;
  for (const std::size_t node : optimal(data, wanted)) nodes.push_back(kept[node]);
  return nodes;
}

}  // namespace

NodeChoice chooseNodes(const SampledCurve& curve, double wanted, double floor, NodeRule rule) {
  const Data data(curve, floor);
  NodeChoice choice;
  switch (rule) {
    case NodeRule::Greedy:
      choice.nodes = greedy(data, wanted);
      break;
    case NodeRule::PaperLiteral:
      choice.nodes = byThreshold(data, wanted, false);
      break;
    case NodeRule::Thinned:
      choice.nodes = byThreshold(data, wanted, true);
      break;
    case NodeRule::Optimal:
      choice.nodes = optimalOfThinned(curve, wanted, floor);
      break;
  }
  choice.error = data.errorOf(choice.nodes);
  return choice;
}

}  // namespace haptics::reaming
