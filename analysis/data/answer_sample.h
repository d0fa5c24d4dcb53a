#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <utility>

#include "analysis/data/likert_counts.h"
#include "analysis/data/moments.h"

namespace analysis {

/// All answers of one group: points of a scale with their counts, or real numbers, such as those of
/// a slider with fine steps or the scores of a questionnaire.
class AnswerSample {
 public:
  AnswerSample(LikertCounts points)  // NOLINT(google-explicit-constructor): it is a sample
      : points_(std::move(points)), moments_(momentsOf(*points_)) {}
  /// @throws std::invalid_argument  if a value is infinite or NaN.
  explicit AnswerSample(std::span<const double> values) : moments_(momentsOf(values)) {}

  /// How often each point was chosen; std::nullopt if the answers are real numbers.
  const std::optional<LikertCounts>& points() const noexcept { return points_; }
  const Moments& moments() const noexcept { return moments_; }

  std::uint64_t total() const noexcept { return moments_.n; }
  std::optional<double> mean() const { return summarise(moments_).mean; }
  std::optional<double> variance() const { return summarise(moments_).variance; }

 private:
  std::optional<LikertCounts> points_;
  Moments moments_;
};

}  // namespace analysis
