#include "analysis/tests/vote_tests.h"

#include <stdexcept>

#include "analysis/numerics/exact_arithmetic.h"
#include "analysis/numerics/tail_probabilities.h"
#include "analysis/tests/equal_shares.h"
#include "analysis/tests/friedman.h"

namespace analysis {
namespace {

/// k ΣGⱼ² − (ΣGⱼ)² and k ΣLᵢ − ΣLᵢ²
struct CochranSums {
  Wide above = 0;
  Wide under = 0;
  std::uint64_t undecided = 0;
};

CochranSums sumsOf(std::span<const std::vector<bool>> answers) {
  const std::size_t options = answers.front().size();
  const auto k = static_cast<Wide>(options);
  std::vector<Wide> yesTo(options, 0);
  CochranSums sums;
  Wide all = 0;
  for (const auto& person : answers) {
    Wide yes = 0;
    for (std::size_t j = 0; j < options; ++j) {
      if (!person[j]) continue;
      ++yesTo[j];
      ++yes;
    }
    if (yes == 0 || yes == k) ++sums.undecided;
    sums.under += k * yes - yes * yes;
    all += yes;
  }
  for (const Wide yes : yesTo) sums.above += k * yes * yes;
  sums.above -= all * all;
  return sums;
}

std::vector<std::vector<double>> asNumbers(std::span<const std::vector<bool>> answers) {
  std::vector<std::vector<double>> blocks;
  for (const auto& person : answers) {
    std::vector<double> block;
    for (const bool yes : person) block.push_back(yes ? 1.0 : 0.0);
    if (block != std::vector<double>(block.size(), block.front())) blocks.push_back(block);
  }
  return blocks;
}

void requireRows(std::span<const std::vector<bool>> answers) {
  for (const auto& person : answers) {
    if (person.size() != answers.front().size()) {
      throw std::invalid_argument("every person answers to every option");
    }
    if (person.size() < 2) throw std::invalid_argument("a vote needs two options");
  }
}

}  // namespace

EqualSharesResult equalSharesTest(const VoteCounts& votes) {
  const auto shares = votes.shares();
  EqualSharesResult result;
  result.votes = votes.total();
  if (result.votes == 0) {
    result.reason = reason("nobody_voted");
    return result;
  }
  const auto n = static_cast<Wide>(result.votes);
  const auto k = static_cast<Wide>(shares.size());
  Wide squares = 0;
  for (const auto& share : shares)
    squares += static_cast<Wide>(share.votes) * static_cast<Wide>(share.votes);
  result.exactP = equalSharesP(votes);
  if (!result.exactP) result.reason = reason("too_many_votes");
  result.chiSquared = exactQuotient(k * squares - n * n, n).high;
  result.degreesOfFreedom = static_cast<double>(k - 1);
  result.p = chiSquaredP(*result.chiSquared, *result.degreesOfFreedom);
  result.log10P = log10ChiSquaredP(*result.chiSquared, *result.degreesOfFreedom);
  return result;
}

CochranResult cochranQTest(std::span<const std::vector<bool>> answers) {
  requireRows(answers);
  CochranResult result;
  result.persons = answers.size();
  if (answers.empty()) {
    result.reason = reason("nobody_answered");
    return result;
  }
  const CochranSums sums = sumsOf(answers);
  result.undecided = sums.undecided;
  if (sums.under == 0) {
    result.reason = reason("same_to_all");
    return result;
  }
  const auto k = static_cast<Wide>(answers.front().size());
  result.q = exactQuotient((k - 1) * sums.above, sums.under).high;
  result.degreesOfFreedom = static_cast<double>(k - 1);
  result.p = chiSquaredP(*result.q, *result.degreesOfFreedom);
  result.log10P = log10ChiSquaredP(*result.q, *result.degreesOfFreedom);
  result.exactP = friedmanTest(asNumbers(answers)).exactP;
  if (!result.exactP) result.reason = reason("too_many_answers");
  return result;
}

}  // namespace analysis
