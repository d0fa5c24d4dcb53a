#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace analysis {

/// Answers on a scale of whole numbers, kept as how often each point was chosen.
///
/// With S the sum of the answers and Q that of their squares, both whole numbers,
///
///     m = S / n,   s² = (n Q − S²) / (n (n − 1)),
///
/// so that m and s² are correctly rounded, in any order of the answers.
class LikertCounts {
 public:
  static constexpr int kMostPoints = 1024;
  static constexpr std::uint64_t kMostAnswers = std::uint64_t{1} << 40;

  /// Starts without answers, on the scale @p lowest … @p highest, both in −10⁶ … 10⁶.
  /// @throws std::invalid_argument  for a scale of fewer than two points or more than kMostPoints.
  LikertCounts(int lowest, int highest);

  /// @p counts[i] is the number of answers with the value @p lowest + i.
  /// @throws std::invalid_argument  for a scale of fewer than two points or more than kMostPoints,
  ///     and for more than kMostAnswers answers.
  LikertCounts(int lowest, std::span<const std::uint64_t> counts);

  /// @throws std::invalid_argument  for a point that is not on the scale, or more than kMostAnswers
  ///     answers.
  void add(int point, std::uint64_t times = 1);

  int lowest() const noexcept { return lowest_; }
  int highest() const noexcept { return lowest_ + static_cast<int>(counts_.size()) - 1; }
  /// The number of answers at each point, from the lowest point to the highest.
  std::span<const std::uint64_t> counts() const noexcept { return counts_; }
  std::uint64_t total() const noexcept { return total_; }

  /// std::nullopt without answers.
  std::optional<double> mean() const;

  /// The sample variance (divided by n − 1); std::nullopt for fewer than two answers.
  std::optional<double> variance() const;

  bool operator==(const LikertCounts&) const = default;

 private:
  int lowest_;
  std::vector<std::uint64_t> counts_;
  std::uint64_t total_ = 0;
};

/// The largest variance that answers on the scale @p lowest … @p highest with the mean @p mean can
/// have if their distribution is unimodal: it rises up to some point, and falls from there on.
///
/// Every such distribution is a mixture of uniform ones over runs of points that all include the
/// peak (Khintchine's theorem for whole numbers; Dharmadhikari & Joag-Dev 1988, ch. 4). The second
/// moment is linear in the mixture, so that a mixture of two uniform distributions reaches the
/// largest variance for a given mean. Returns the population variance (divided by n).
///
/// @throws std::invalid_argument  for a scale of fewer than two points or a mean outside it.
double largestUnimodalVariance(int lowest, int highest, double mean);

/// Whether the answers vary more than any unimodal distribution with their mean can. If so, they
/// have two peaks, and few answers lie near the mean. Compares the sample variance (n − 1) with the
/// bound times n / (n − 1). std::nullopt for fewer than two answers.
std::optional<bool> exceedsUnimodalVariance(const LikertCounts& counts);

}  // namespace analysis
