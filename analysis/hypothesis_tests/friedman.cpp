#include "analysis/hypothesis_tests/friedman.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <utility>

#include "analysis/data/ranks.h"
#include "analysis/numerics/distributions.h"
#include "analysis/numerics/exact_arithmetic.h"
#include "analysis/numerics/tail_probabilities.h"

namespace analysis {
namespace {

using Block = std::vector<std::uint64_t>;
constexpr std::size_t kMostMoves = 60'000'000;
constexpr Int128 kMostPermutations = Int128{1} << 126;  // largest divisor of exactQuotient()

/// The possible values of the doubled rank sums, minus 2 per block: a grid with one axis per
/// treatment except the last, whose sum follows from the others.
struct Grid {
  std::size_t axes = 0;
  std::size_t width = 0;
  std::size_t cells = 1;
};

std::optional<Grid> gridOf(std::size_t blocks, std::size_t treatments) {
  Grid grid{.axes = treatments - 1, .width = 2 * (treatments - 1) * blocks + 1, .cells = 1};
  for (std::size_t axis = 0; axis < grid.axes; ++axis) {
    if (grid.cells > kMostMoves / grid.width) return std::nullopt;
    grid.cells *= grid.width;
  }
  return grid;
}

/// The offset on the grid of each distinct permutation of a block; std::nullopt if there are more
/// than @p most.
std::optional<std::vector<std::size_t>> movesOf(Block block, const Grid& grid, std::size_t most) {
  std::ranges::sort(block);
  std::vector<std::size_t> moves;
  do {
    if (moves.size() == most) return std::nullopt;
    std::size_t move = 0;
    for (std::size_t axis = 0; axis < grid.axes; ++axis) {
      move = move * grid.width + static_cast<std::size_t>(block[axis] - 2);
    }
    moves.push_back(move);
  } while (std::ranges::next_permutation(block).found);
  return moves;
}

/// Σ over treatments of (doubled rank sum − its mean)²
Int128 inequality(std::size_t cell, const Grid& grid, Int128 blocks) {
  const Int128 treatments = static_cast<Int128>(grid.axes) + 1;
  const Int128 mean = blocks * (treatments - 1);  // of a doubled rank sum minus 2 per block
  Int128 rest = mean * treatments;
  Int128 sum = 0;
  for (std::size_t axis = 0; axis < grid.axes; ++axis) {
    const auto place = static_cast<Int128>(cell % grid.width);
    cell /= grid.width;
    rest -= place;
    sum += (place - mean) * (place - mean);
  }
  return sum + (rest - mean) * (rest - mean);
}

/// One step of the dynamic programming: the counts after one more block, which adds each of its
/// permutations to every sum reached so far.
std::vector<Int128> withOneMoreBlock(
    const std::vector<Int128>& counts, const std::vector<std::size_t>& moves) {
  std::vector<Int128> next(counts.size(), 0);
  for (std::size_t cell = 0; cell < counts.size(); ++cell) {
    if (counts[cell] == 0) continue;
    for (const std::size_t move : moves) next[cell + move] += counts[cell];
  }
  return next;
}

std::size_t cellOf(std::span<const Block> blocks, const Grid& grid) {
  std::size_t cell = 0;
  for (std::size_t axis = 0; axis < grid.axes; ++axis) {
    std::size_t place = 0;
    for (const auto& block : blocks) place += static_cast<std::size_t>(block[axis] - 2);
    cell = cell * grid.width + place;
  }
  return cell;
}

}  // namespace

std::optional<double> friedmanPermutationP(std::span<const Block> doubledRanks) {
  if (doubledRanks.empty()) return std::nullopt;
  const auto grid = gridOf(doubledRanks.size(), doubledRanks.front().size());
  if (!grid) return std::nullopt;

  const std::size_t mostMoves = kMostMoves / grid->cells / doubledRanks.size();
  std::vector<std::vector<std::size_t>> movesOfBlocks;
  Int128 all = 1;
  for (const auto& block : doubledRanks) {
    auto moves = movesOf(block, *grid, mostMoves);
    if (!moves || all > kMostPermutations / static_cast<Int128>(moves->size())) return std::nullopt;
    all *= static_cast<Int128>(moves->size());
    movesOfBlocks.push_back(std::move(*moves));
  }
  // Allocated last: for a p that is not computed the grid could need a gigabyte.
  std::vector<Int128> counts(grid->cells, 0);
  counts[0] = 1;
  for (const auto& moves : movesOfBlocks) counts = withOneMoreBlock(counts, moves);

  const auto count = static_cast<Int128>(doubledRanks.size());
  const Int128 observed = inequality(cellOf(doubledRanks, *grid), *grid, count);
  Int128 asUnequal = 0;
  for (std::size_t cell = 0; cell < counts.size(); ++cell) {
    if (counts[cell] > 0 && inequality(cell, *grid, count) >= observed) asUnequal += counts[cell];
  }
  return exactQuotient(asUnequal, all).high;
}

namespace {

/// The sums that the statistics are computed from, in whole numbers: ranks are doubled, so that
/// midranks are whole, and ties are exact.
struct Ranking {
  Int128 b = 0;
  Int128 k = 0;
  std::vector<std::vector<std::uint64_t>> doubledRanks;
  std::vector<Int128> doubledSums;
  Int128 inequality = 0;  ///< Σ (doubled sum − its mean)²
  Int128 squares = 0;     ///< Σ of squared doubled ranks
  /// b k (k + 1)(k − 1) − Σ(t³ − t): zero if all ranks are tied in every block.
  Int128 denominator = 0;
};

Ranking rankingOf(std::span<const std::vector<double>> blocks) {
  Ranking ranking;
  ranking.b = static_cast<Int128>(blocks.size());
  ranking.k = blocks.empty() ? 0 : static_cast<Int128>(blocks.front().size());
  ranking.doubledSums.assign(static_cast<std::size_t>(ranking.k), 0);
  ranking.denominator = ranking.b * ranking.k * (ranking.k + 1) * (ranking.k - 1);
  for (const auto& block : blocks) {
    const Midranks ranks = midranksOf(block);
    ranking.denominator -= ranks.tieSum;
    for (std::size_t j = 0; j < ranks.doubled.size(); ++j) {
      const auto rank = static_cast<Int128>(ranks.doubled[j]);
      ranking.doubledSums[j] += rank;
      ranking.squares += rank * rank;
    }
    ranking.doubledRanks.push_back(ranks.doubled);
  }
  for (const Int128 sum : ranking.doubledSums) {
    const Int128 excess = sum - ranking.b * (ranking.k + 1);
    ranking.inequality += excess * excess;
  }
  return ranking;
}

void requireRows(std::span<const std::vector<double>> blocks) {
  constexpr std::size_t kMostTreatments = 50;
  for (const auto& block : blocks) {
    if (block.size() != blocks.front().size()) {
      throw std::invalid_argument("every block has a value for every treatment");
    }
    if (block.size() < 2 || block.size() > kMostTreatments) {
      throw std::invalid_argument("a block ranks 2 to 50 treatments");
    }
  }
}

void addImanDavenport(FriedmanResult& result, const Ranking& ranking) {
  if (ranking.b < 2) return;
  const Int128 above = 3 * (ranking.b - 1) * ranking.inequality;
  const Int128 under = ranking.b * ranking.denominator - 3 * ranking.inequality;
  if (under == 0) {
    result.imanDavenportF = std::numeric_limits<double>::infinity();
    result.imanDavenportP = 0.0;
    return;
  }
  const double f = exactQuotient(above, under).high;
  const auto df = static_cast<double>(ranking.k - 1);
  result.imanDavenportF = f;
  const FisherDistribution fisher(df, df * static_cast<double>(ranking.b - 1));
  result.imanDavenportP = fisher.upperP(f);
}

RankComparison comparisonOf(const Ranking& ranking, std::size_t first, std::size_t second) {
  const Int128 difference = ranking.doubledSums[first] - ranking.doubledSums[second];
  const Int128 size = difference < 0 ? -difference : difference;
  RankComparison pair{
      .first = first,
      .second = second,
      .conoverT = {},
      .conoverDegreesOfFreedom = {},
      .conoverP = {}};
  pair.meanRankDifference = exactQuotient(difference, 2 * ranking.b).high;

  // q² = 3 d² / (b k (k + 1)), d the difference of doubled sums
  const DoubleDouble square =
      exactQuotient(3 * size * size, ranking.b * ranking.k * (ranking.k + 1));
  pair.nemenyiQ = squareRoot(square).high;
  pair.nemenyiP = studentizedRangeP(pair.nemenyiQ, static_cast<std::size_t>(ranking.k));
  pair.nemenyiLog10P = log10StudentizedRangeP(pair.nemenyiQ, static_cast<std::size_t>(ranking.k));

  // Conover's variance, 2 (b Σr² − ΣR²) / ((b − 1)(k − 1)), of doubled ranks.
  Int128 sumsSquared = 0;
  for (const Int128 sum : ranking.doubledSums) sumsSquared += sum * sum;
  const Int128 residual = ranking.b * ranking.squares - sumsSquared;
  const Int128 df = (ranking.b - 1) * (ranking.k - 1);
  if (residual > 0 && df > 0) {
    const DoubleDouble deviation = squareRoot(exactQuotient(2 * residual, df));
    pair.conoverT = (exactQuotient(difference, 1) / deviation).high;
    pair.conoverDegreesOfFreedom = static_cast<double>(df);
    pair.conoverP = StudentDistribution(static_cast<double>(df)).twoSidedP(*pair.conoverT);
  }
  return pair;
}

void addTest(FriedmanResult& result, const Ranking& ranking) {
  const auto df = static_cast<double>(ranking.k - 1);
  result.chiSquared =
      exactQuotient(3 * (ranking.k - 1) * ranking.inequality, ranking.denominator).high;
  result.p = chiSquaredP(*result.chiSquared, df);
  result.log10P = log10ChiSquaredP(*result.chiSquared, df);
  result.kendallW = exactQuotient(3 * ranking.inequality, ranking.b * ranking.denominator).high;
  addImanDavenport(result, ranking);
  result.exactP = friedmanPermutationP(ranking.doubledRanks);
  if (!result.exactP) result.reason = reason("too_many_blocks");
  if (ranking.b < 2) result.reason = reason("one_block");

  for (std::size_t i = 0; i < ranking.doubledSums.size(); ++i) {
    for (std::size_t j = i + 1; j < ranking.doubledSums.size(); ++j) {
      result.pairs.push_back(comparisonOf(ranking, i, j));
    }
  }
}

}  // namespace

FriedmanResult friedmanTest(std::span<const std::vector<double>> blocks) {
  constexpr std::size_t kMostBlocks = 1'000'000;
  requireRows(blocks);
  if (blocks.size() > kMostBlocks) throw std::invalid_argument("there are too many blocks");
  const Ranking ranking = rankingOf(blocks);
  FriedmanResult result;
  result.blocks = blocks.size();
  result.treatments = blocks.empty() ? 0 : blocks.front().size();
  if (blocks.empty()) {
    result.reason = reason("no_blocks");
  } else if (ranking.denominator == 0) {
    result.reason = reason("all_treatments_tied");
  } else {
    addTest(result, ranking);
  }
  return result;
}

}  // namespace analysis
