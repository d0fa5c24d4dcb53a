// Places a given number of nodes so that the largest error of a spline is minimal.
#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "base/random.h"
#include "haptics/reaming/material/node_choice.h"

namespace haptics::reaming {
namespace {

using Nodes = std::vector<std::size_t>;

/// @p count evenly spaced samples, from the first to the last.
Nodes evenNodes(std::size_t samples, std::size_t count) {
  Nodes nodes;
  for (std::size_t i = 0; i < count; ++i) nodes.push_back(i * (samples - 1) / (count - 1));
  return nodes;
}

/// Nodes that are denser where the curve bends: the integral of √|f″| is equal over all pieces.
Nodes nodesByCurvature(const SplineDeviation& error, std::size_t count) {
  const auto& x = error.curve().x;
  const auto& slopes = error.slopes();
  std::vector<double> sum(error.size(), 0.0);
  for (std::size_t i = 1; i < sum.size(); ++i) {
    const double bend = std::abs(slopes[i] - slopes[i - 1]) / (x[i] - x[i - 1]);
    sum[i] = sum[i - 1] + std::sqrt(bend) * (x[i] - x[i - 1]);
  }
  Nodes nodes = evenNodes(sum.size(), count);
  for (std::size_t k = 1; k + 1 < count; ++k) {
    const double wanted = sum.back() * static_cast<double>(k) / static_cast<double>(count - 1);
    const auto found = std::lower_bound(sum.begin(), sum.end(), wanted) - sum.begin();
    nodes[k] =
        std::clamp(static_cast<std::size_t>(found), nodes[k - 1] + 1, sum.size() - (count - k));
  }
  return nodes;
}

/// For a local kind of spline: minimises the largest error of count − 1 pieces. Only 400 of the
/// samples can become nodes.
Nodes byDynamicProgramming(const SplineDeviation& error, std::size_t count) {
  constexpr std::size_t kCandidateCount = 400;
  const Nodes places =
      evenNodes(error.size(), std::max(count, std::min(error.size(), kCandidateCount)));
  const std::size_t n = places.size();
  std::vector<double> cost(n * n, 0.0);
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = i + 1; j < n; ++j) {
      cost[i * n + j] = error.worstOfPiece(places[i], places[j]).error;
    }
  }
  constexpr double kNever = std::numeric_limits<double>::infinity();
  std::vector<double> least(n, kNever);
  least[0] = 0.0;
  std::vector<std::vector<std::size_t>> before;
  for (std::size_t piece = 1; piece < count; ++piece) {
    std::vector<double> next(n, kNever);
    std::vector<std::size_t> from(n, 0);
    for (std::size_t j = piece; j < n; ++j) {
      for (std::size_t i = piece - 1; i < j; ++i) {
        const double with = std::max(least[i], cost[i * n + j]);
        if (with < next[j]) {
          next[j] = with;
          from[j] = i;
        }
      }
    }
    least = std::move(next);
    before.push_back(std::move(from));
  }
  Nodes nodes{places[n - 1]};
  for (std::size_t at = n - 1; !before.empty(); before.pop_back()) {
    at = before.back()[at];
    nodes.push_back(places[at]);
  }
  std::ranges::reverse(nodes);
  return nodes;
}

/// For a local kind of spline: moves all nodes together, each to the best sample near it, until no
/// node moves.
Nodes settledByPieces(const SplineDeviation& error, Nodes nodes) {
  constexpr std::ptrdiff_t kSamplesAround = 12;
  constexpr int kMostRounds = 40;
  for (int round = 0; round < kMostRounds; ++round) {
    std::vector<Nodes> layers;
    for (std::size_t k = 0; k < nodes.size(); ++k) {
      const bool isEnd = k == 0 || k + 1 == nodes.size();
      Nodes layer;
      for (std::ptrdiff_t by = isEnd ? 0 : -kSamplesAround; by <= (isEnd ? 0 : kSamplesAround);
           ++by) {
        const auto at = static_cast<std::ptrdiff_t>(nodes[k]) + by;
        const auto last = static_cast<std::ptrdiff_t>(error.size() - 1);
        if (isEnd || (at > 0 && at < last)) layer.push_back(static_cast<std::size_t>(at));
      }
      layers.push_back(std::move(layer));
    }
    constexpr double kNever = std::numeric_limits<double>::infinity();
    std::vector<double> least{0.0};
    std::vector<std::vector<std::size_t>> before;
    for (std::size_t k = 1; k < layers.size(); ++k) {
      std::vector<double> next(layers[k].size(), kNever);
      std::vector<std::size_t> from(layers[k].size(), 0);
      for (std::size_t j = 0; j < layers[k].size(); ++j) {
        for (std::size_t i = 0; i < layers[k - 1].size(); ++i) {
          if (layers[k - 1][i] >= layers[k][j] || least[i] >= next[j]) continue;
          const double piece = error.worstOfPiece(layers[k - 1][i], layers[k][j], next[j]).error;
          const double with = std::max(least[i], piece);
          if (with >= next[j]) continue;
          next[j] = with;
          from[j] = i;
        }
      }
      least = std::move(next);
      before.push_back(std::move(from));
    }
    Nodes moved(nodes.size());
    std::size_t at = 0;
    for (std::size_t k = nodes.size(); k-- > 0;) {
      moved[k] = layers[k][at];
      if (k > 0) at = before[k - 1][at];
    }
    if (moved == nodes) break;
    nodes = std::move(moved);
  }
  return nodes;
}

/// Adds nodes one by one where the error is largest.
Nodes worstFirst(const SplineDeviation& error, std::size_t count) {
  Nodes nodes{0, error.size() - 1};
  while (nodes.size() < count) {
    const auto worst = error.worstOfSpline(nodes);
    const auto place = std::lower_bound(nodes.begin(), nodes.end(), worst.at);
    if (place != nodes.end() && *place == worst.at) return evenNodes(error.size(), count);
    nodes.insert(place, worst.at);
  }
  return nodes;
}

/// Differential evolution (Storn & Price 1997, best/1/bin with a dithered weight) of the inner
/// nodes, followed by moves of single nodes. Deterministic.
class Evolution {
 public:
  Evolution(const SplineDeviation& error, std::span<const Nodes> starts)
      : error_(error), count_(starts.front().size()) {
    for (std::size_t m = 0; m < kMembers; ++m) {
      auto places = innerOf(starts[m % starts.size()]);
      // First the starts themselves, then copies with increasing random offsets.
      const std::size_t round = m / starts.size();
      const double reach = 0.3 * static_cast<double>(round * error.size()) / kMembers;
      for (double& place : places) place += reach * random_.normal();
      const auto cost = error_.worstOfSpline(nodesOf(places)).error;
      members_.push_back({std::move(places), cost});
    }
  }

  Nodes run() {
    constexpr int kGenerations = 400;
    for (int generation = 0; generation < kGenerations; ++generation) {
      const double weight = 0.3 + 0.6 * random_.uniform();
      for (auto& member : members_) mutate(member, weight);
    }
    Nodes nodes = nodesOf(best().places);
    moveSingleNodes(nodes);
    return nodes;
  }

 private:
  static constexpr std::size_t kMembers = 100;
  struct Member {
    std::vector<double> places;
    double cost = 0.0;
  };

  static std::vector<double> innerOf(const Nodes& nodes) {
    return {nodes.begin() + 1, nodes.end() - 1};
  }

  /// Rounds positions to increasing, distinct samples, and adds both ends.
  Nodes nodesOf(std::vector<double> places) const {
    std::ranges::sort(places);
    Nodes nodes{0};
    for (std::size_t k = 0; k < places.size(); ++k) {
      const auto last = static_cast<double>(error_.size() - 1 - (places.size() - k));
      const auto first = static_cast<double>(nodes.back() + 1);
      nodes.push_back(static_cast<std::size_t>(std::clamp(std::round(places[k]), first, last)));
    }
    nodes.push_back(error_.size() - 1);
    return nodes;
  }

  const Member& best() const {
    return *std::ranges::min_element(
        members_, [](const auto& a, const auto& b) { return a.cost < b.cost; });
  }

  const Member& randomMember() { return members_[random_.bits() % kMembers]; }

  void mutate(Member& member, double weight) {
    constexpr double kCrossoverProbability = 0.7;
    const auto& origin = best().places;
    const auto& one = randomMember().places;
    const auto& other = randomMember().places;
    auto tried = member.places;
    const std::size_t sure = random_.bits() % std::max<std::size_t>(1, tried.size());
    for (std::size_t k = 0; k < tried.size(); ++k) {
      if (random_.uniform() < kCrossoverProbability || k == sure) {
        tried[k] = origin[k] + weight * (one[k] - other[k]);
      }
    }
    std::ranges::sort(tried);
    const double cost = error_.worstOfSpline(nodesOf(tried), member.cost).error;
    if (cost <= member.cost) member = {std::move(tried), cost};
  }

  /// Moves single nodes, in large and small steps, while the largest error falls.
  void moveSingleNodes(Nodes& nodes) const {
    double least = error_.worstOfSpline(nodes).error;
    const auto improves = [&](std::size_t k, std::ptrdiff_t by) {
      const std::size_t kept = nodes[k];
      nodes[k] = static_cast<std::size_t>(std::clamp(
          static_cast<std::ptrdiff_t>(kept) + by,
          static_cast<std::ptrdiff_t>(nodes[k - 1]) + 1,
          static_cast<std::ptrdiff_t>(nodes[k + 1]) - 1));
      const double with = error_.worstOfSpline(nodes, least).error;
      if (with >= least) {
        nodes[k] = kept;
        return false;
      }
      least = with;
      return true;
    };
    for (bool isBetter = true; isBetter;) {
      isBetter = false;
      for (std::size_t k = 1; k + 1 < count_; ++k) {
        for (std::ptrdiff_t by = 64; by > 0; by /= 2) {
          while (improves(k, by) || improves(k, -by)) isBetter = true;
        }
      }
    }
  }

  const SplineDeviation& error_;
  std::size_t count_;
  base::SplitMix64 random_{1};
  std::vector<Member> members_;
};

}  // namespace

std::vector<std::size_t> nodesOfLeastError(
    const SplineDeviation& error, std::size_t count, const NodeCriterion& nodeCriterion) {
  if (isLocal(nodeCriterion.kind))
    return settledByPieces(error, byDynamicProgramming(error, count));
  NodeCriterion local = nodeCriterion;
  local.kind = SplineKind::HermiteDataSlope;
  const Nodes starts[]{
      byDynamicProgramming(SplineDeviation(error.curve(), local), count),
      worstFirst(error, count),
      nodesByCurvature(error, count),
      evenNodes(error.size(), count)};
  return count > 2 ? Evolution(error, starts).run() : evenNodes(error.size(), count);
}

}  // namespace haptics::reaming
