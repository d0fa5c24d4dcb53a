#include "haptics/reaming/material/node_choice.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <queue>

namespace haptics::reaming {
namespace {

/// A piece that may have to be split; the piece with the largest error comes first in a queue.
struct Piece {
  double error = 0.0;
  std::size_t at = 0;
  std::size_t from = 0;
  std::size_t to = 0;

  bool operator<(const Piece& other) const { return error < other.error; }
};

/// Greedy rule for a local kind of spline: after a split only the two new pieces need a new error.
std::vector<std::size_t> greedyByPieces(const SplineDeviation& error, double wanted) {
  const auto pieceOf = [&](std::size_t from, std::size_t to) {
    const auto worst = error.worstOfPiece(from, to);
    return Piece{worst.error, worst.at, from, to};
  };
  std::priority_queue<Piece> pieces;
  pieces.push(pieceOf(0, error.size() - 1));
  std::vector<std::size_t> nodes{0, error.size() - 1};
  while (pieces.top().error > wanted) {
    const Piece worst = pieces.top();
    pieces.pop();
    // Not at an end of the piece, so that it is really split.
    const std::size_t at = std::clamp(worst.at, worst.from + 1, worst.to - 1);
    nodes.push_back(at);
    pieces.push(pieceOf(worst.from, at));
    pieces.push(pieceOf(at, worst.to));
  }
  std::ranges::sort(nodes);
  return nodes;
}

/// Greedy rule for kinds in which every node changes all pieces.
std::vector<std::size_t> greedyOverAll(const SplineDeviation& error, double wanted) {
  std::vector<std::size_t> nodes{0, error.size() - 1};
  for (auto worst = error.worstOfSpline(nodes); worst.error > wanted;
       worst = error.worstOfSpline(nodes)) {
    nodes.insert(std::upper_bound(nodes.begin(), nodes.end(), worst.at), worst.at);
  }
  return nodes;
}

/// |f″| of each sample, from the slopes of its neighbours.
std::vector<double> curvatures(const SplineDeviation& error) {
  const auto& x = error.curve().x;
  const auto& s = error.slopes();
  std::vector<double> result(error.size(), 0.0);
  for (std::size_t i = 1; i + 1 < error.size(); ++i) {
    result[i] = std::abs((s[i + 1] - s[i - 1]) / (x[i + 1] - x[i - 1]));
  }
  return result;
}

std::vector<std::size_t> samplesAbove(
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

/// PaperLiteral and Thinned: the threshold begins at the largest curvature and falls by 1 % per
/// iteration.
std::vector<std::size_t> byThreshold(const SplineDeviation& error, double wanted, bool isThinned) {
  constexpr double kThresholdFactor = 0.99;
  constexpr int kMostFalls = 3000;
  const auto curvature = curvatures(error);
  double threshold = *std::ranges::max_element(curvature);
  std::vector<std::size_t> best = samplesAbove(curvature, threshold, isThinned);
  double bestError = error.worstOfSpline(best).error;
  for (int fall = 0; fall < kMostFalls && bestError > wanted; ++fall) {
    threshold *= kThresholdFactor;
    auto nodes = samplesAbove(curvature, threshold, isThinned);
    if (nodes.size() == best.size() && !isThinned) continue;
    const double now = error.worstOfSpline(nodes).error;
    if (now >= bestError && isThinned) continue;
    bestError = now;
    best = std::move(nodes);
  }
  return best;
}

/// Optimal: the shortest path over the samples, in which two samples are joined by an edge if one
/// piece between them meets the error.
std::vector<std::size_t> optimal(const SplineDeviation& error, double wanted) {
  const std::size_t n = error.size();
  constexpr auto kUnreached = std::numeric_limits<std::size_t>::max();
  std::vector<std::size_t> count(n, kUnreached);
  std::vector<std::size_t> before(n, 0);
  count[0] = 1;
  for (std::size_t from = 0; from + 1 < n; ++from) {
    if (count[from] == kUnreached) continue;
    for (std::size_t to = from + 1; to < n; ++to) {
      if (count[from] + 1 >= count[to]) continue;
      if (error.worstOfPiece(from, to, wanted).error > wanted) continue;
      count[to] = count[from] + 1;
      before[to] = from;
    }
  }
  std::vector<std::size_t> nodes;
  for (std::size_t at = n - 1; at != 0; at = before[at]) nodes.push_back(at);
  nodes.push_back(0);
  std::ranges::reverse(nodes);
  return nodes;
}

/// Evenly spaced indices of at most @p most of @p count samples.
std::vector<std::size_t> thinnedOut(std::size_t count, std::size_t most) {
  std::vector<std::size_t> kept;
  const std::size_t left = std::min(count, most);
  for (std::size_t i = 0; i < left; ++i) kept.push_back(i * (count - 1) / (left - 1));
  return kept;
}

std::vector<std::size_t> optimalOfThinned(
    const SampledCurve& curve, const NodeCriterion& nodeCriterion) {
  constexpr std::size_t kFeasible = 2001;
  const auto kept = thinnedOut(curve.size(), kFeasible);
  SampledCurve thin;
  for (const std::size_t i : kept) {
    thin.x.push_back(curve.x[i]);
    thin.y.push_back(curve.y[i]);
  }
  std::vector<std::size_t> nodes;
  for (const std::size_t node :
       optimal(SplineDeviation(thin, nodeCriterion), nodeCriterion.error)) {
    nodes.push_back(kept[node]);
  }
  return nodes;
}

std::vector<std::size_t> nodesBy(
    const SampledCurve& curve, const SplineDeviation& error, const NodeCriterion& nodeCriterion) {
  switch (nodeCriterion.rule) {
    case NodeRule::Greedy:
      return isLocal(nodeCriterion.kind) ? greedyByPieces(error, nodeCriterion.error)
                                         : greedyOverAll(error, nodeCriterion.error);
    case NodeRule::PaperLiteral:
      return byThreshold(error, nodeCriterion.error, false);
    case NodeRule::Thinned:
      return byThreshold(error, nodeCriterion.error, true);
    case NodeRule::Optimal:
      return optimalOfThinned(curve, nodeCriterion);
  }
  return {};
}

}  // namespace

std::optional<std::string> problemOf(const NodeCriterion& nodeCriterion) {
  if (nodeCriterion.rule != NodeRule::Optimal || isLocal(nodeCriterion.kind)) return std::nullopt;
  return "the fewest nodes are only found for a spline whose pieces depend on their two nodes "
         "alone";
}

NodeChoice chooseNodes(const SampledCurve& curve, const NodeCriterion& nodeCriterion) {
  const SplineDeviation error(curve, nodeCriterion);
  NodeChoice choice{.nodes = nodesBy(curve, error, nodeCriterion)};
  choice.error = error.worstOfSpline(choice.nodes).error;
  choice.isMet = choice.error <= nodeCriterion.error;
  return choice;
}

NodeChoice chooseNodes(
    const SampledCurve& curve, std::size_t count, const NodeCriterion& nodeCriterion) {
  const SplineDeviation error(curve, nodeCriterion);
  NodeChoice choice{.nodes = nodesOfLeastError(error, count, nodeCriterion)};
  choice.error = error.worstOfSpline(choice.nodes).error;
  choice.isMet = choice.error <= nodeCriterion.error;
  return choice;
}

SplineDeviation::SplineDeviation(const SampledCurve& curve, const NodeCriterion& nodeCriterion)
    : curve_(curve), criterion_(nodeCriterion), slopes_(dataSlopes(curve)) {
  if (nodeCriterion.rule == NodeRule::PaperLiteral) criterion_.floor = 0.0;
}

SplineDeviation::Worst SplineDeviation::worstOfCubic(
    const models::CubicSegment<double>& piece,
    std::size_t from,
    std::size_t to,
    double errorLimit) const {
  Worst worst{.at = from + (to - from) / 2};
  for (std::size_t i = from + 1; i < to; ++i) {
    const double y = curve_.y[i];
    const double measure = std::max(std::abs(y), criterion_.floor);
    if (measure == 0.0) continue;  // the paper's e_a is not defined at 0
    const double error = std::abs(piece.at(curve_.x[i]).force - y) / measure;
    if (error > worst.error) worst = {error, i};
    if (worst.error > errorLimit) break;
  }
  return worst;
}

SplineDeviation::Worst SplineDeviation::worstOfPiece(
    std::size_t from, std::size_t to, double errorLimit) const {
  models::HermiteNode<double> a{curve_.x[from], curve_.y[from], slopes_[from]};
  models::HermiteNode<double> b{curve_.x[to], curve_.y[to], slopes_[to]};
  if (criterion_.kind == SplineKind::Linear) {
    a.slope = b.slope = (b.force - a.force) / (b.position - a.position);
  }
  return worstOfCubic(models::CubicSegment<double>::between(a, b), from, to, errorLimit);
}

SplineDeviation::Worst SplineDeviation::worstOfSpline(
    std::span<const std::size_t> nodes, double errorLimit) const {
  const auto spline = splineThrough(curve_, slopes_, nodes, criterion_.kind);
  Worst worst;
  for (std::size_t i = 0; i + 1 < nodes.size() && worst.error <= errorLimit; ++i) {
    const auto here = worstOfCubic(spline.segments[i], nodes[i], nodes[i + 1], errorLimit);
    if (here.error > worst.error) worst = here;
  }
  return worst;
}

namespace {

/// Index of the sample at @p x.
std::size_t sampleAt(const SampledCurve& curve, double x) {
  const auto found = std::lower_bound(curve.x.begin(), curve.x.end(), x);
  return static_cast<std::size_t>(found - curve.x.begin());
}

double deviationAt(const SampledCurve& curve, const Spline& spline, std::size_t i) {
  return std::abs(spline.at(curve.x[i]) - curve.y[i]);
}

}  // namespace

SplineComparison compareSplines(
    const SampledCurve& curve, std::vector<std::size_t> nodes, double floor) {
  SplineComparison comparison{.nodes = std::move(nodes)};
  const auto slopes = dataSlopes(curve);
  for (const auto kind : {SplineKind::NaturalCubic, SplineKind::HermiteDataSlope}) {
    ComparedSpline compared{
        .kind = kind, .spline = splineThrough(curve, slopes, comparison.nodes, kind)};
    compared.error = errorOf(curve, compared.spline, floor);
    const auto& first = comparison.splines.empty() ? compared : comparison.splines.front();
    const auto published = sampleAt(curve, first.error.publishedPosition);
    const auto floored = sampleAt(curve, first.error.flooredPosition);
    const double v = std::abs(curve.y[published]);
    if (v > 0.0)
      compared.publishedErrorAtWorst = deviationAt(curve, compared.spline, published) / v;
    compared.flooredErrorAtWorst =
        deviationAt(curve, compared.spline, floored) / std::max(std::abs(curve.y[floored]), floor);
    comparison.splines.push_back(std::move(compared));
  }
  return comparison;
}

}  // namespace haptics::reaming
