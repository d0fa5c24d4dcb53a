#include "analysis/tests/equal_shares.h"

#include <algorithm>
#include <array>
#include <cstddef>

#include "analysis/numerics/exact_arithmetic.h"

namespace analysis {
namespace {

constexpr std::size_t kTooMany = 127;           // fewer votes and options than this
constexpr Wide kMostOutcomes = Wide{1} << 126;  // what exactQuotient() can divide by

/// Pascal's triangle, as far as outcomes can be counted.
class Binomials {
 public:
  Binomials() {
    for (std::size_t n = 0; n < kTooMany; ++n) {
      rows_[n][0] = rows_[n][n] = 1;
      for (std::size_t k = 1; k < n; ++k) rows_[n][k] = rows_[n - 1][k - 1] + rows_[n - 1][k];
    }
  }
  Wide operator()(std::size_t n, std::size_t k) const { return rows_[n][k]; }

 private:
  std::array<std::array<Wide, kTooMany>, kTooMany> rows_{};
};

const Binomials& binomials() {
  static const Binomials table;
  return table;
}

/// Visits all outcomes; those that differ only in which option got which count are visited
/// together.
class Outcomes {
 public:
  explicit Outcomes(Wide observed) : observed_(observed) {}

  /// So far the outcome can come about in @p orders ways, and its numbers fall to the options in
  /// @p placements ways; what is left is shared by the other options, none getting more than @p
  /// largest.
  void visit(
      std::size_t votes, std::size_t options, std::size_t largest, Wide orders, Wide placements) {
    if (votes == 0) {
      if (orders <= observed_) notMoreProbable_ += orders * placements;
      return;
    }
    for (std::size_t each = std::min(largest, votes); each * options >= votes && each > 0; --each) {
      Wide ordersHere = orders;
      for (std::size_t alike = 1; alike <= options && alike * each <= votes; ++alike) {
        const std::size_t left = votes - alike * each;
        ordersHere *= binomials()(left + each, each);
        visit(
            left, options - alike, each - 1, ordersHere, placements * binomials()(options, alike));
      }
    }
  }
  Wide notMoreProbable() const { return notMoreProbable_; }

 private:
  Wide observed_;
  Wide notMoreProbable_ = 0;
};

/// kⁿ, or std::nullopt if it does not fit.
std::optional<Wide> outcomeCount(std::size_t options, std::uint64_t votes) {
  if (options >= kTooMany || votes >= kTooMany) return std::nullopt;
  Wide count = 1;
  for (std::uint64_t i = 0; i < votes; ++i) {
    if (count > kMostOutcomes / static_cast<Wide>(options)) return std::nullopt;
    count *= static_cast<Wide>(options);
  }
  return count;
}

/// n! / (v₁! … v_k!)
Wide ordersOf(const std::vector<VoteShare>& shares) {
  Wide orders = 1;
  std::size_t votes = 0;
  for (const auto& share : shares) {
    votes += share.votes;
    orders *= binomials()(votes, share.votes);
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
  return exactQuotient(outcomes.notMoreProbable(), *all).high;
}

}  // namespace analysis
