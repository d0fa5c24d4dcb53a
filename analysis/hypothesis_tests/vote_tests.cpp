#include "analysis/hypothesis_tests/vote_tests.h"

#include <algorithm>
#include <cstddef>
#include <stdexcept>

#include "analysis/data/ranks.h"
#include "analysis/hypothesis_tests/friedman.h"
#include "analysis/numerics/exact_arithmetic.h"
#include "analysis/numerics/tail_probabilities.h"

namespace analysis {
namespace {

constexpr std::size_t kTooMany = 127;               // both votes and options must be fewer
constexpr Int128 kMostOutcomes = Int128{1} << 126;  // largest divisor of exactQuotient()

const auto& binomials() {
  static const auto table = binomialCoefficients<Int128>(kTooMany - 1);
  return table;
}

/// Enumerates all outcomes. Outcomes that differ only in which option got which count are visited
/// together.
class Outcomes {
 public:
  explicit Outcomes(Int128 observed) : observed_(observed) {}

  /// Distributes the remaining @p votes over the remaining @p options, none of which gets more than
  /// @p largest. The counts chosen so far arise from @p orders orders of the votes and can be
  /// assigned to options in @p assignments ways.
  void visit(
      std::size_t votes,
      std::size_t options,
      std::size_t largest,
      Int128 orders,
      Int128 assignments) {
    if (votes == 0) {
      if (orders <= observed_) countOfNotMoreProbable_ += orders * assignments;
      return;
    }
    for (std::size_t votesEach = std::min(largest, votes);
         votesEach * options >= votes && votesEach > 0;
         --votesEach) {
      Int128 ordersHere = orders;
      for (std::size_t sameCountOptions = 1;
           sameCountOptions <= options && sameCountOptions * votesEach <= votes;
           ++sameCountOptions) {
        const std::size_t left = votes - sameCountOptions * votesEach;
        ordersHere *= binomials()[left + votesEach][votesEach];
        visit(
            left,
            options - sameCountOptions,
            votesEach - 1,
            ordersHere,
            assignments * binomials()[options][sameCountOptions]);
      }
    }
  }
  Int128 countOfNotMoreProbable() const { return countOfNotMoreProbable_; }

 private:
  Int128 observed_;
  Int128 countOfNotMoreProbable_ = 0;
};

/// kⁿ, or std::nullopt if it does not fit.
std::optional<Int128> outcomeCount(std::size_t options, std::uint64_t votes) {
  if (options >= kTooMany || votes >= kTooMany) return std::nullopt;
  Int128 count = 1;
  for (std::uint64_t i = 0; i < votes; ++i) {
    if (count > kMostOutcomes / static_cast<Int128>(options)) return std::nullopt;
    count *= static_cast<Int128>(options);
  }
  return count;
}

/// n! / (v₁! … v_k!)
Int128 ordersOf(const std::vector<VoteShare>& shares) {
  Int128 orders = 1;
  std::size_t votes = 0;
  for (const auto& share : shares) {
    votes += share.votes;
    orders *= binomials()[votes][share.votes];
  }
  return orders;
}

}  // namespace

std::optional<double> equalSharesP(const VoteCounts& votes) {
  const auto shares = votes.shares();
  const auto all = outcomeCount(shares.size(), votes.total());
  if (!all || votes.total() == 0) return std::nullopt;

  Outcomes outcomes(ordersOf(shares));
  outcomes.visit(votes.total(), shares.size(), votes.total(), 1, 1);
  return exactQuotient(outcomes.countOfNotMoreProbable(), *all).high;
}

namespace {

/// The two sums of Cochran's Q (see cochranQTest()), k ΣGⱼ² − (ΣGⱼ)² and k ΣLᵢ − ΣLᵢ², and the
/// number of persons who give the same answer to all options.
struct CochranSums {
  Int128 numeratorSum = 0;
  Int128 denominatorSum = 0;
  std::uint64_t unvaryingPersons = 0;
};

CochranSums cochranSumsOf(std::span<const std::vector<bool>> answers) {
  const std::size_t options = answers.front().size();
  const auto k = static_cast<Int128>(options);
  std::vector<Int128> yesTo(options, 0);
  CochranSums sums;
  Int128 all = 0;
  for (const auto& person : answers) {
    Int128 yes = 0;
    for (std::size_t j = 0; j < options; ++j) {
      if (!person[j]) continue;
      ++yesTo[j];
      ++yes;
    }
    if (yes == 0 || yes == k) ++sums.unvaryingPersons;
    sums.denominatorSum += k * yes - yes * yes;
    all += yes;
  }
  for (const Int128 yes : yesTo) sums.numeratorSum += k * yes * yes;
  sums.numeratorSum -= all * all;
  return sums;
}

/// Doubled midranks of the answers of each person who does not give the same answer to all options.
std::vector<std::vector<std::uint64_t>> doubledRanksOf(std::span<const std::vector<bool>> answers) {
  std::vector<std::vector<std::uint64_t>> blocks;
  for (const auto& person : answers) {
    std::vector<double> block;
    for (const bool yes : person) block.push_back(yes ? 1.0 : 0.0);
    if (block == std::vector<double>(block.size(), block.front())) continue;
    blocks.push_back(midranksOf(block).doubled);
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
  const auto n = static_cast<Int128>(result.votes);
  const auto k = static_cast<Int128>(shares.size());
  Int128 squares = 0;
  for (const auto& share : shares)
    squares += static_cast<Int128>(share.votes) * static_cast<Int128>(share.votes);
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
  const CochranSums sums = cochranSumsOf(answers);
  result.unvaryingPersons = sums.unvaryingPersons;
  if (sums.denominatorSum == 0) {
    result.reason = reason("same_to_all");
    return result;
  }
  const auto k = static_cast<Int128>(answers.front().size());
  result.q = exactQuotient((k - 1) * sums.numeratorSum, sums.denominatorSum).high;
  result.degreesOfFreedom = static_cast<double>(k - 1);
  result.p = chiSquaredP(*result.q, *result.degreesOfFreedom);
  result.log10P = log10ChiSquaredP(*result.q, *result.degreesOfFreedom);
  result.exactP = friedmanPermutationP(doubledRanksOf(answers));
  if (!result.exactP) result.reason = reason("too_many_answers");
  return result;
}

}  // namespace analysis
