#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/numerics/interval.h"

namespace analysis {

/// The votes for one option, as a number and as a share of all votes.
struct VoteShare {
  std::string option;
  std::uint64_t votes = 0;
  std::optional<double> share;  ///< std::nullopt without votes
};

/// How often each option was preferred. Abstentions are not counted.
class VoteCounts {
 public:
  static constexpr std::uint64_t kMostVotes = std::uint64_t{1} << 40;

  /// Starts without votes. @throws std::invalid_argument for fewer than two options, or one option
  /// twice.
  explicit VoteCounts(std::vector<std::string> options);

  /// @throws std::invalid_argument  for an unknown option, or more than kMostVotes votes.
  void add(std::string_view option, std::uint64_t times = 1);

  std::uint64_t total() const noexcept { return total_; }

  /// In the order of the options.
  std::vector<VoteShare> shares() const;

 private:
  std::vector<std::string> options_;
  std::vector<std::uint64_t> votes_;
  std::uint64_t total_ = 0;
};

/// A confidence interval of the share of an option in the population, if @p votes of @p total are
/// for it.
///
/// Wilson's interval (1927) contains the shares that the normal test would not reject: with z the
/// normal quantile of the level and s = votes/total,
///
///     (s + z²/2n ± z √(s(1 − s)/n + z²/4n²)) / (1 + z²/n)
///
/// std::nullopt for a total of zero.
/// @throws std::invalid_argument  for more votes than the total, or a level that is not between 0
///     and 1.
std::optional<Interval> wilsonInterval(
    std::uint64_t votes, std::uint64_t total, double level = 0.95);

/// Clopper & Pearson's interval (1934) contains the shares that the exact binomial test would not
/// reject on either side; its confidence is never below the level.
///
///     low = B⁻¹((1 − level)/2; v, n − v + 1),   high = B⁻¹((1 + level)/2; v + 1, n − v)
///
/// with B⁻¹ the quantile of the beta distribution. std::nullopt for a total of zero.
/// @throws std::invalid_argument  for more votes than the total, or a level that is not between 0
///     and 1.
std::optional<Interval> clopperPearsonInterval(
    std::uint64_t votes, std::uint64_t total, double level = 0.95);

}  // namespace analysis
