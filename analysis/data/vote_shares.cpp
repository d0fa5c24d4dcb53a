#include "analysis/data/vote_shares.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <stdexcept>
#include <utility>

#include <boost/math/special_functions/beta.hpp>

#include "analysis/numerics/tail_probabilities.h"

namespace analysis {
namespace {

std::size_t indexOf(std::string_view option, const std::vector<std::string>& options) {
  const auto found = std::ranges::find(options, option);
  if (found == options.end()) {
    throw std::invalid_argument("'" + std::string(option) + "' is not one of the options");
  }
  return static_cast<std::size_t>(found - options.begin());
}

}  // namespace

VoteCounts::VoteCounts(std::vector<std::string> options)
    : options_(std::move(options)), votes_(options_.size(), 0) {
  const std::set<std::string> different(options_.begin(), options_.end());
  if (options_.size() < 2) throw std::invalid_argument("a vote needs two options");
  if (different.size() != options_.size()) throw std::invalid_argument("an option is there twice");
}

void VoteCounts::add(std::string_view option, std::uint64_t times) {
  const std::size_t index = indexOf(option, options_);
  if (times > kMostVotes - total_) throw std::invalid_argument("too many votes to count");
  votes_[index] += times;
  total_ += times;
}

std::vector<VoteShare> VoteCounts::shares() const {
  std::vector<VoteShare> shares;
  for (std::size_t i = 0; i < options_.size(); ++i) {
    VoteShare share{.option = options_[i], .votes = votes_[i], .share = std::nullopt};
    if (total_ > 0) share.share = static_cast<double>(votes_[i]) / static_cast<double>(total_);
    shares.push_back(std::move(share));
  }
  return shares;
}

namespace {

void requireValidShare(std::uint64_t votes, std::uint64_t total, double level) {
  if (votes > total) throw std::invalid_argument("there are more votes for one option than votes");
  requireConfidenceLevel(level);
}

/// The upper end of Wilson's interval.
double wilsonUpperEnd(double share, double n, double z) {
  const double half = z * std::sqrt(share * (1.0 - share) / n + z * z / (4.0 * n * n));
  return std::min(1.0, (share + z * z / (2.0 * n) + half) / (1.0 + z * z / n));
}

}  // namespace

std::optional<Interval> wilsonInterval(std::uint64_t votes, std::uint64_t total, double level) {
  requireValidShare(votes, total, level);
  if (total == 0) return std::nullopt;
  const auto n = static_cast<double>(total);
  const double share = static_cast<double>(votes) / n;
  const double z = normalTwoSidedQuantile(level);
  const double high = wilsonUpperEnd(share, n, z);
  // Because low · high = s² / (1 + z²/n), the lower end is computed without a difference, which
  // would lose digits where the share is small.
  const double low = share * share / (1.0 + z * z / n) / high;
  return Interval{.low = low, .high = votes == total ? 1.0 : high};
}

std::optional<Interval> clopperPearsonInterval(
    std::uint64_t votes, std::uint64_t total, double level) {
  requireValidShare(votes, total, level);
  if (total == 0) return std::nullopt;
  const auto v = static_cast<double>(votes);
  const auto against = static_cast<double>(total - votes);
  const double tail = 0.5 * (1.0 - level);
  return Interval{
      .low = votes == 0 ? 0.0 : boost::math::ibeta_inv(v, against + 1.0, tail),
      .high = votes == total ? 1.0 : boost::math::ibetac_inv(v + 1.0, against, tail)};
}

}  // namespace analysis
