#include "analysis/tests/friedman.h"

#include <cmath>
#include <limits>
#include <stdexcept>

#include "analysis/data/ranks.h"
#include "analysis/numerics/exact_arithmetic.h"
#include "analysis/numerics/fisher_distribution.h"
#include "analysis/numerics/student_distribution.h"
#include "analysis/numerics/tail_probabilities.h"
#include "analysis/tests/friedman_permutations.h"

namespace analysis {
namespace {

/// The sums that the statistics are computed from, in whole numbers: ranks are doubled, so that
/// midranks are whole, and ties are exact.
struct Ranking {
  Wide b = 0;
  Wide k = 0;
  std::vector<std::vector<std::uint64_t>> doubledRanks;
  std::vector<Wide> doubledSums;
  Wide inequality = 0;   ///< Σ (doubled sum − its mean)²
  Wide squares = 0;      ///< Σ of squared doubled ranks
  Wide denominator = 0;  ///< b k (k + 1)(k − 1) − Σ(t³ − t): zero if every block ties all
};

Ranking rankingOf(std::span<const std::vector<double>> blocks) {
  Ranking ranking;
  ranking.b = static_cast<Wide>(blocks.size());
  ranking.k = blocks.empty() ? 0 : static_cast<Wide>(blocks.front().size());
  ranking.doubledSums.assign(static_cast<std::size_t>(ranking.k), 0);
  ranking.denominator = ranking.b * ranking.k * (ranking.k + 1) * (ranking.k - 1);
  for (const auto& block : blocks) {
    const Midranks ranks = midranksOf(block);
    ranking.denominator -= ranks.tieSum;
    for (std::size_t j = 0; j < ranks.doubled.size(); ++j) {
      const auto rank = static_cast<Wide>(ranks.doubled[j]);
      ranking.doubledSums[j] += rank;
      ranking.squares += rank * rank;
    }
    ranking.doubledRanks.push_back(ranks.doubled);
  }
  for (const Wide sum : ranking.doubledSums) {
    const Wide excess = sum - ranking.b * (ranking.k + 1);
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
  const Wide above = 3 * (ranking.b - 1) * ranking.inequality;
  const Wide under = ranking.b * ranking.denominator - 3 * ranking.inequality;
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
  result.imanDavenportLog10P = fisher.log10UpperP(f);
}

RankComparison compared(const Ranking& ranking, std::size_t first, std::size_t second) {
  const Wide difference = ranking.doubledSums[first] - ranking.doubledSums[second];
  const Wide size = difference < 0 ? -difference : difference;
  RankComparison pair{.first = first, .second = second, .conoverT = {}, .conoverP = {}};
  pair.meanRankDifference = exactQuotient(difference, 2 * ranking.b).high;

  // q² = 3 d² / (b k (k + 1)), d the difference of doubled sums
  const DoubleDouble square =
      exactQuotient(3 * size * size, ranking.b * ranking.k * (ranking.k + 1));
  pair.nemenyiQ = squareRoot(square).high;
  pair.nemenyiP = studentizedRangeP(pair.nemenyiQ, static_cast<std::size_t>(ranking.k));
  pair.nemenyiLog10P = log10StudentizedRangeP(pair.nemenyiQ, static_cast<std::size_t>(ranking.k));

  // Conover's variance, 2 (b Σr² − ΣR²) / ((b − 1)(k − 1)), of doubled ranks.
  Wide sumsSquared = 0;
  for (const Wide sum : ranking.doubledSums) sumsSquared += sum * sum;
  const Wide residual = ranking.b * ranking.squares - sumsSquared;
  const Wide df = (ranking.b - 1) * (ranking.k - 1);
  if (residual > 0 && df > 0) {
    const DoubleDouble deviation = squareRoot(exactQuotient(2 * residual, df));
    pair.conoverT = (exactQuotient(difference, 1) / deviation).high;
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
      result.pairs.push_back(compared(ranking, i, j));
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
  for (const Wide sum : ranking.doubledSums) {
    result.rankSums.push_back(exactQuotient(sum, 2).high);
  }
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
