#include "analysis/published/consistent_sizes.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>

#include "analysis/numerics/distributions.h"

namespace analysis {

PValueWindow::PValueWindow(const Interval& p, const PublishedConvention& convention)
    : p_(p), convention_(convention), limits_(1) {}

const PValueWindow::Limits& PValueWindow::limitsAt(std::size_t degreesOfFreedom) const {
  const double tails = convention_.tails == PublishedConvention::Tails::Two ? 1.0 : 2.0;
  while (limits_.size() <= degreesOfFreedom) {
    const StudentDistribution distribution(static_cast<double>(limits_.size()));
    const auto limit = [&](double p) {
      if (p <= 0.0) return std::numeric_limits<double>::infinity();
      return p >= 1.0 ? 0.0 : distribution.twoSidedQuantile(p);
    };
    limits_.push_back({.nearest = limit(tails * p_.high), .furthest = limit(tails * p_.low)});
  }
  return limits_[degreesOfFreedom];
}

bool PValueWindow::contains(const LatticePoint& group1, const LatticePoint& group2) const {
  constexpr double kMargin = 1e-9;  // of t: if t is nearer to a limit, p is computed
  const auto spread =
      spreadOfDifference(convention_.test, group1.variance, group1.n, group2.variance, group2.n);
  const double difference = std::abs(group1.mean - group2.mean);
  if (spread.standardError > 0.0) {
    const double t = difference / spread.standardError;
    // For a given p, t falls with the degrees of freedom.
    const auto below = static_cast<std::size_t>(spread.degreesOfFreedom);
    const Limits wide = limitsAt(below);
    const Limits narrow = limitsAt(below + 1);
    if (t > wide.nearest + kMargin && t < narrow.furthest - kMargin) return true;
    if (t < narrow.nearest - kMargin || t > wide.furthest + kMargin) return false;
  }
  const double p = pOf(difference, spread, convention_.tails);
  // p has an error of some 1e-14, and a printed p includes the ends of its interval.
  return p_.low - 1e-12 <= p && p <= p_.high + 1e-12;
}

namespace {

constexpr std::size_t kBitsPerWord = 64;
using Bits = std::vector<std::uint64_t>;

Bits allBits(std::size_t count) {
  Bits bits((count + kBitsPerWord - 1) / kBitsPerWord, 0);
  for (std::size_t i = 0; i < count; ++i)
    bits[i / kBitsPerWord] |= std::uint64_t{1} << (i % kBitsPerWord);
  return bits;
}

bool isSet(const Bits& bits, std::size_t i) {
  return ((bits[i / kBitsPerWord] >> (i % kBitsPerWord)) & 1U) != 0;
}

/// Intersects @p bits with @p other; false if the result is empty.
bool intersect(Bits& bits, const Bits& other) {
  std::uint64_t any = 0;
  for (std::size_t i = 0; i < bits.size(); ++i) any |= bits[i] &= other[i];
  return any != 0;
}

/// The pairs of points of two groups of given sizes that have the printed p: for each point of one
/// group a row of bits, one bit for each point of the other group.
struct Agreement {
  /// [point of the first group]: the points of the second group that agree.
  std::vector<Bits> forward;
  /// [point of the second group]: the points of the first group that agree.
  std::vector<Bits> backward;
  bool isEmpty = true;
};

/// A constraint search: the values of each group are the lattice points that reproduce its mean and
/// variance; a printed p is a constraint between two groups. The pairs of points that satisfy it
/// are computed once for each pair of sizes, as bits, and used for all combinations of sizes.
class SizeSearch {
 public:
  SizeSearch(
      const PublishedTable& table,
      std::span<const std::vector<std::uint64_t>> sizes,
      const AnswerLattice& lattice,
      const PublishedConvention& convention)
      : table_(table), sizes_(sizes), lattice_(lattice), convention_(convention) {
    for (std::size_t g = 0; g < sizes.size(); ++g) {
      auto& groupPoints = points_.emplace_back();
      for (const auto n : sizes[g]) {
        groupPoints.push_back(
            lattice.pointsOf(table.groups[g], n, convention.divisor, convention.rounding));
      }
    }
    for (const auto& comparison : table.comparisons) addAgreements(comparison);
  }

  ConsistentSizes found() const {
    ConsistentSizes result;
    result.convention = convention_;
    std::vector<std::size_t> at(sizes_.size(), 0);
    do {
      ++result.triedCombinations;
      if (!fits(at)) continue;
      GroupSizes combination;
      for (std::size_t g = 0; g < at.size(); ++g) combination.push_back(sizes_[g][at[g]]);
      result.fitting.push_back(combination);
    } while (advance(at));
    addPossibleSizes(result);
    addExampleAnswers(result);
    return result;
  }

 private:
  void addAgreements(const PublishedComparison& comparison) {
    const PValueWindow window(comparison.p.bounds(convention_.rounding), convention_);
    auto& table = agreements_.emplace_back();
    for (const auto& points1 : points_[comparison.first]) {
      auto& row = table.emplace_back();
      for (const auto& points2 : points_[comparison.second]) {
        row.push_back(agreementOf(points1, points2, window));
      }
    }
  }

  static Agreement agreementOf(
      const std::vector<LatticePoint>& points1,
      const std::vector<LatticePoint>& points2,
      const PValueWindow& window) {
    Agreement agreement;
    agreement.forward.assign(
        points1.size(), Bits((points2.size() + kBitsPerWord - 1) / kBitsPerWord, 0));
    agreement.backward.assign(
        points2.size(), Bits((points1.size() + kBitsPerWord - 1) / kBitsPerWord, 0));
    for (std::size_t i = 0; i < points1.size(); ++i) {
      for (std::size_t j = 0; j < points2.size(); ++j) {
        if (!window.contains(points1[i], points2[j])) continue;
        agreement.forward[i][j / kBitsPerWord] |= std::uint64_t{1} << (j % kBitsPerWord);
        agreement.backward[j][i / kBitsPerWord] |= std::uint64_t{1} << (i % kBitsPerWord);
        agreement.isEmpty = false;
      }
    }
    return agreement;
  }

  bool advance(std::vector<std::size_t>& at) const {
    for (std::size_t g = at.size(); g-- > 0;) {
      if (++at[g] < sizes_[g].size()) return true;
      at[g] = 0;
    }
    return false;
  }

  bool fits(const std::vector<std::size_t>& at) const {
    for (std::size_t c = 0; c < agreements_.size(); ++c) {
      const auto& comparison = table_.comparisons[c];
      if (agreements_[c][at[comparison.first]][at[comparison.second]].isEmpty) return false;
    }
    std::vector<Bits> remaining;
    for (std::size_t g = 0; g < at.size(); ++g) {
      const std::size_t count = points_[g][at[g]].size();
      if (count == 0) return false;
      remaining.push_back(allBits(count));
    }
    std::vector<std::size_t> chosen;
    return canChoose(at, 0, remaining, chosen);
  }

  /// Backtracking with forward checking: chooses a point for one group after the other, and keeps
  /// of the later groups the points that agree with it.
  /// @param chosen  the points chosen for the groups before @p group; those of all groups on
  ///     success.
  bool canChoose(
      const std::vector<std::size_t>& at,
      std::size_t group,
      const std::vector<Bits>& remaining,
      std::vector<std::size_t>& chosen) const {
    if (group == at.size()) return true;
    for (std::size_t point = 0; point < points_[group][at[group]].size(); ++point) {
      if (!isSet(remaining[group], point)) continue;
      auto remainingAfter = remaining;
      chosen.push_back(point);
      if (propagate(at, group, point, remainingAfter) &&
          canChoose(at, group + 1, remainingAfter, chosen))
        return true;
      chosen.pop_back();
    }
    return false;
  }

  bool propagate(
      const std::vector<std::size_t>& at,
      std::size_t group,
      std::size_t point,
      std::vector<Bits>& remaining) const {
    for (std::size_t c = 0; c < agreements_.size(); ++c) {
      const auto& [first, second, p] = table_.comparisons[c];
      const auto& agreement = agreements_[c][at[first]][at[second]];
      if (first == group && second > group) {
        if (!intersect(remaining[second], agreement.forward[point])) return false;
      }
      if (second == group && first > group) {
        if (!intersect(remaining[first], agreement.backward[point])) return false;
      }
    }
    return true;
  }

  void addExampleAnswers(ConsistentSizes& result) const {
    const auto largestSizes = result.largestFittingSizes();
    if (!largestSizes) return;
    std::vector<std::size_t> at;
    std::vector<Bits> remaining;
    for (std::size_t g = 0; g < sizes_.size(); ++g) {
      const auto place = std::ranges::find(sizes_[g], (*largestSizes)[g]);
      at.push_back(static_cast<std::size_t>(place - sizes_[g].begin()));
      remaining.push_back(allBits(points_[g][at[g]].size()));
    }
    std::vector<std::size_t> chosen;
    if (!canChoose(at, 0, remaining, chosen)) return;
    for (std::size_t g = 0; g < at.size(); ++g) {
      result.exampleAnswers.push_back(lattice_.answersOf(points_[g][at[g]][chosen[g]]));
    }
  }

  void addPossibleSizes(ConsistentSizes& result) const {
    for (std::size_t g = 0; g < sizes_.size(); ++g) {
      auto& possibleSizes = result.possibleSizes.emplace_back();
      for (std::size_t i = 0; i < sizes_[g].size(); ++i) {
        if (!points_[g][i].empty()) possibleSizes.push_back(sizes_[g][i]);
      }
    }
  }

  const PublishedTable& table_;
  std::span<const std::vector<std::uint64_t>> sizes_;
  const AnswerLattice& lattice_;
  PublishedConvention convention_;
  std::vector<std::vector<std::vector<LatticePoint>>> points_;   ///< [group][size]
  std::vector<std::vector<std::vector<Agreement>>> agreements_;  ///< [comparison][size][size]
};

}  // namespace

std::vector<std::uint64_t> ConsistentSizes::equalSizes() const {
  std::vector<std::uint64_t> equal;
  for (const auto& sizes : fitting) {
    const bool isEqual =
        std::ranges::all_of(sizes, [&](std::uint64_t n) { return n == sizes.front(); });
    if (isEqual) equal.push_back(sizes.front());
  }
  return equal;
}

std::optional<GroupSizes> ConsistentSizes::largestFittingSizes() const {
  const auto total = [](const GroupSizes& sizes) {
    return std::accumulate(sizes.begin(), sizes.end(), std::uint64_t{0});
  };
  const auto most = std::ranges::max_element(fitting, {}, total);
  return most == fitting.end() ? std::nullopt : std::optional(*most);
}

ConsistentSizes consistentSizes(
    const PublishedTable& table,
    std::span<const std::vector<std::uint64_t>> sizes,
    const AnswerLattice& lattice,
    const PublishedConvention& convention) {
  if (sizes.size() != table.groups.size()) throw std::invalid_argument("every group has its sizes");
  double combinations = 1.0;
  for (const auto& groupPoints : sizes) combinations *= static_cast<double>(groupPoints.size());
  if (combinations < 1.0 || combinations > kMostSizeCombinations) {
    throw std::invalid_argument("no sizes to try, or more than two million combinations of them");
  }
  return SizeSearch(table, sizes, lattice, convention).found();
}

}  // namespace analysis
