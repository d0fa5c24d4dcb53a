#include "analysis/data/likert_counts.h"

#include <algorithm>
#include <functional>
#include <stdexcept>
#include <string>

#include "analysis/data/moments.h"

namespace analysis {
namespace {

std::size_t pointsOf(int lowest, std::int64_t points) {
  constexpr int kFarthest = 1'000'000;
  if (points < 2 || points > LikertCounts::kMostPoints) {
    throw std::invalid_argument(
        "a scale has 2 to " + std::to_string(LikertCounts::kMostPoints) + " points, not " +
        std::to_string(points));
  }
  if (lowest < -kFarthest || lowest > kFarthest) {
    throw std::invalid_argument("a scale cannot begin at " + std::to_string(lowest));
  }
  return static_cast<std::size_t>(points);
}

}  // namespace

LikertCounts::LikertCounts(int lowest, int highest)
    : lowest_(lowest), counts_(pointsOf(lowest, std::int64_t{highest} - lowest + 1), 0) {}

LikertCounts::LikertCounts(int lowest, std::span<const std::uint64_t> counts)
    : lowest_(lowest), counts_(pointsOf(lowest, std::ssize(counts)), 0) {
  for (std::size_t i = 0; i < counts.size(); ++i) add(lowest + static_cast<int>(i), counts[i]);
}

void LikertCounts::add(int point, std::uint64_t times) {
  if (point < lowest() || point > highest()) {
    throw std::invalid_argument(
        "the answer " + std::to_string(point) + " is not on the scale " + std::to_string(lowest()) +
        " to " + std::to_string(highest()));
  }
  if (times > kMostAnswers - total_) throw std::invalid_argument("too many answers");
  counts_[static_cast<std::size_t>(point - lowest_)] += times;
  total_ += times;
}

void LikertCounts::merge(const LikertCounts& other) {
  if (other.lowest() != lowest() || other.highest() != highest()) {
    throw std::invalid_argument("answers on different scales cannot be pooled");
  }
  if (other.total_ > kMostAnswers - total_) throw std::invalid_argument("too many answers");
  std::ranges::transform(counts_, other.counts_, counts_.begin(), std::plus<>{});
  total_ += other.total_;
}

LikertCounts LikertCounts::reversed() const {
  LikertCounts result = *this;
  std::ranges::reverse(result.counts_);
  return result;
}

std::optional<double> LikertCounts::mean() const {
  return total_ == 0 ? std::nullopt : std::optional(momentsOf(*this).mean.high);
}

std::optional<double> LikertCounts::variance() const {
  return total_ < 2 ? std::nullopt : std::optional(momentsOf(*this).variance.high);
}

}  // namespace analysis
