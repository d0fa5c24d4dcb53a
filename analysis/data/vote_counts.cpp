#include "analysis/data/vote_counts.h"

#include <algorithm>
#include <set>
#include <stdexcept>
#include <utility>

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

}  // namespace analysis
