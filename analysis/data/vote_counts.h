#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

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

}  // namespace analysis
