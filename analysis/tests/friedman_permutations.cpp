#include "analysis/tests/friedman_permutations.h"

#include <algorithm>
#include <cstddef>

#include "analysis/numerics/exact_arithmetic.h"

namespace analysis {
namespace {

using Block = std::vector<std::uint64_t>;
constexpr std::size_t kMostMoves = 60'000'000;
constexpr Wide kMostPermutations = Wide{1} << 126;  // what exactQuotient() can divide by

/// Where each doubled rank sum, less two per block, can lie: a grid with an axis per treatment but
/// the last, whose sum follows.
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

/// How far each distinct permutation of a block moves on the grid; std::nullopt if they are too
/// many.
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
Wide inequality(std::size_t cell, const Grid& grid, Wide blocks) {
  const Wide treatments = static_cast<Wide>(grid.axes) + 1;
  const Wide mean = blocks * (treatments - 1);  // of a doubled rank sum less two per block
  Wide rest = mean * treatments;
  Wide sum = 0;
  for (std::size_t axis = 0; axis < grid.axes; ++axis) {
    const auto place = static_cast<Wide>(cell % grid.width);
    cell /= grid.width;
    rest -= place;
    sum += (place - mean) * (place - mean);
  }
  return sum + (rest - mean) * (rest - mean);
}

/// One step of the dynamic programming: the counts after one more block, which adds each of its
/// permutations to every sum reached so far.
std::vector<Wide> moved(const std::vector<Wide>& ways, const std::vector<std::size_t>& moves) {
  std::vector<Wide> next(ways.size(), 0);
  for (std::size_t cell = 0; cell < ways.size(); ++cell) {
    if (ways[cell] == 0) continue;
    for (const std::size_t move : moves) next[cell + move] += ways[cell];
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
  std::vector<Wide> ways(grid->cells, 0);
  ways[0] = 1;
  Wide all = 1;
  for (const auto& block : doubledRanks) {
    const auto moves = movesOf(block, *grid, mostMoves);
    if (!moves || all > kMostPermutations / static_cast<Wide>(moves->size())) return std::nullopt;
    all *= static_cast<Wide>(moves->size());
    ways = moved(ways, *moves);
  }

  const auto count = static_cast<Wide>(doubledRanks.size());
  const Wide observed = inequality(cellOf(doubledRanks, *grid), *grid, count);
  Wide asUnequal = 0;
  for (std::size_t cell = 0; cell < ways.size(); ++cell) {
    if (ways[cell] > 0 && inequality(cell, *grid, count) >= observed) asUnequal += ways[cell];
  }
  return exactQuotient(asUnequal, all).high;
}

}  // namespace analysis
