#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/numerics/interval.h"

namespace analysis {

/// How many voted for one option, and which part of all votes that is.
struct VoteShare {
  std::string option;
  std::uint64_t votes = 0;
  std::optional<double> share;  ///< nothing without votes
};

/// Who was preferred how often. A vote that was not cast is not counted anywhere.
class VoteCounts {
 public:
  static constexpr std::uint64_t kMostVotes = std::uint64_t{1} << 40;

  /// No votes yet. @throws std::invalid_argument  for fewer than two options, or the same twice.
  explicit VoteCounts(std::vector<std::string> options);

  /// @throws std::invalid_argument  for an option that is not there, or beyond kMostVotes.
  void add(std::string_view option, std::uint64_t times = 1);

  std::uint64_t total() const noexcept { return total_; }

  /// In the order of the options.
  std::vector<VoteShare> shares() const;

 private:
  std::vector<std::string> options_;
  std::vector<std::uint64_t> votes_;
  std::uint64_t total_ = 0;
};

/// The interval of the share of an option in the population, if @p votes of @p total are for it.
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
/// with B⁻¹ the quantile of the beta law. std::nullopt for a total of zero.
/// @throws std::invalid_argument  as above.
std::optional<Interval> clopperPearsonInterval(
    std::uint64_t votes, std::uint64_t total, double level = 0.95);

}  // namespace analysis
