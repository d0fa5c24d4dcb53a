#include "analysis/hypothesis_tests/vote_tests.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>

#include <boost/math/special_functions/gamma.hpp>

#include "analysis/data/ranks.h"
#include "analysis/hypothesis_tests/friedman.h"
#include "analysis/numerics/exact_arithmetic.h"
#include "analysis/numerics/tail_probabilities.h"

namespace analysis {
namespace {

constexpr std::size_t kTooMany = 127;             // of whole numbers: votes and options
constexpr Int128 kMostOrders = Int128{1} << 126;  // largest divisor of exactQuotient()
constexpr std::size_t kMostOutcomes = std::size_t{1} << 20U;
constexpr double kSameLog = 1e-9;  // logarithms of equal probabilities differ by less

const auto& binomials() {
  static const auto table = binomialCoefficients<Int128>(kTooMany - 1);
  return table;
}

/// So many options got so many votes each.
struct SameCount {
  std::size_t votesEach;
  std::size_t options;
};

/// All outcomes of a vote. Outcomes that differ only in which option got which count are one.
class Outcomes {
 public:
  /// Calls @p visit with each outcome: the counts above zero, the largest first. Returns whether
  /// there are at most kMostOutcomes; visits no more than these.
  template <typename Visit>
  static bool forEach(std::size_t votes, std::size_t options, const Visit& visit) {
    std::vector<SameCount> outcome;
    std::size_t left = kMostOutcomes;
    return distribute(votes, options, votes, outcome, [&] {
      if (left == 0) return false;
      --left;
      visit(outcome);
      return true;
    });
  }

 private:
  /// Distributes the remaining @p votes over the remaining @p options, none of which gets more than
  /// @p largest.
  template <typename Visit>
  static bool distribute(
      std::size_t votes,
      std::size_t options,
      std::size_t largest,
      std::vector<SameCount>& outcome,
      const Visit& visit) {
    if (votes == 0) return visit();
    for (std::size_t each = std::min(largest, votes); each * options >= votes && each > 0; --each) {
      for (std::size_t same = 1; same <= options && same * each <= votes; ++same) {
        outcome.push_back({each, same});
        const bool goesOn =
            distribute(votes - same * each, options - same, each - 1, outcome, visit);
        outcome.pop_back();
        if (!goesOn) return false;
      }
    }
    return true;
  }
};

/// kⁿ, or std::nullopt if it does not fit.
std::optional<Int128> orderCount(std::size_t options, std::size_t votes) {
  if (options >= kTooMany || votes >= kTooMany) return std::nullopt;
  Int128 count = 1;
  for (std::size_t i = 0; i < votes; ++i) {
    if (count > kMostOrders / static_cast<Int128>(options)) return std::nullopt;
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

/// In whole numbers, so that equal terms are recognised.
std::optional<double> wholeP(const std::vector<VoteShare>& shares, std::size_t votes, Int128 all) {
  const Int128 observed = ordersOf(shares);
  Int128 notMoreProbable = 0;
  const bool isComplete = Outcomes::forEach(votes, shares.size(), [&](const auto& outcome) {
    Int128 orders = 1;
    Int128 assignments = 1;
    std::size_t left = votes;
    std::size_t options = shares.size();
    for (const auto& [each, same] : outcome) {
      assignments *= binomials()[options][same];
      options -= same;
      for (std::size_t i = 0; i < same; ++i, left -= each) orders *= binomials()[left][each];
    }
    if (orders <= observed) notMoreProbable += orders * assignments;
  });
  if (!isComplete) return std::nullopt;
  return exactQuotient(notMoreProbable, all).high;
}

/// By logarithms, for numbers that do not fit.
std::optional<double> logarithmicP(const std::vector<VoteShare>& shares, std::size_t votes) {
  const std::size_t options = shares.size();
  if (votes > 2 * kMostOutcomes || options > kMostOutcomes) return std::nullopt;
  std::vector<double> logFactorials{0.0};
  for (std::size_t n = 1; n <= std::max(votes, options); ++n) {
    logFactorials.push_back(boost::math::lgamma(static_cast<double>(n) + 1.0));
  }
  const double all = static_cast<double>(votes) * std::log(static_cast<double>(options));
  double observed = logFactorials[votes];
  for (const auto& share : shares) observed -= logFactorials[share.votes];
  double p = 0.0;
  const bool isComplete = Outcomes::forEach(votes, options, [&](const auto& outcome) {
    double orders = logFactorials[votes];
    double assignments = logFactorials[options];
    std::size_t withoutVotes = options;
    for (const auto& [each, same] : outcome) {
      orders -= static_cast<double>(same) * logFactorials[each];
      assignments -= logFactorials[same];
      withoutVotes -= same;
    }
    assignments -= logFactorials[withoutVotes];
    if (orders <= observed + kSameLog) p += std::exp(orders + assignments - all);
  });
  if (!isComplete) return std::nullopt;
  return std::min(p, 1.0);
}

}  // namespace

std::optional<double> equalSharesP(const VoteCounts& votes) {
  const auto shares = votes.shares();
  const auto total = static_cast<std::size_t>(votes.total());
  if (total == 0) return std::nullopt;
  const auto all = orderCount(shares.size(), total);
  return all ? wholeP(shares, total, *all) : logarithmicP(shares, total);
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
