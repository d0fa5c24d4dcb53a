#include "analysis/published/answer_lattice.h"

#include <stdexcept>
#include <utility>

namespace analysis {
namespace {

constexpr std::uint64_t kWordBits = 64;

/// target |= source << shift.
void addShifted(
    std::vector<std::uint64_t>& target,
    const std::vector<std::uint64_t>& source,
    std::uint64_t shift) {
  const auto words = static_cast<std::size_t>(shift / kWordBits);
  const auto bits = static_cast<unsigned>(shift % kWordBits);
  if (target.size() < source.size() + words + 1) target.resize(source.size() + words + 1);
  for (std::size_t i = 0; i < source.size(); ++i) {
    target[i + words] |= source[i] << bits;
    if (bits > 0) target[i + words + 1] |= source[i] >> (kWordBits - bits);
  }
}

}  // namespace

AnswerLattice::AnswerLattice(const AnswerScale& scale, std::uint64_t mostAnswers) : scale_(scale) {
  const int points = (scale.highest - scale.lowest) * scale.parts + 1;
  if (scale.highest <= scale.lowest || scale.parts < 1 || points > kMostPoints) {
    throw std::invalid_argument("a scale has 2 to 101 points");
  }
  steps_ = static_cast<std::uint64_t>(points - 1);
  const auto most = static_cast<double>(mostAnswers);
  const auto steps = static_cast<double>(steps_);
  if (most * most * most * steps * steps * steps / 3.0 > kMostPairs) {
    throw std::invalid_argument(
        "groups of " + std::to_string(mostAnswers) +
        " answers on so fine a scale are too many to count out");
  }
  // Adding one answer u to n − 1 answers shifts every sum of squares by u².
  squares_.resize(mostAnswers + 1);
  squares_[0] = {{1}};
  for (std::uint64_t n = 1; n <= mostAnswers; ++n) {
    squares_[n].resize(n * steps_ + 1);
    for (std::uint64_t sum = 0; sum < squares_[n - 1].size(); ++sum) {
      for (std::uint64_t u = 0; u <= steps_; ++u) {
        addShifted(squares_[n][sum + u], squares_[n - 1][sum], u * u);
      }
    }
  }
}

bool AnswerLattice::isAttainable(std::uint64_t n, std::uint64_t sum, std::uint64_t squares) const {
  const auto& bits = squares_[n][sum];
  const auto word = squares / kWordBits;
  return word < bits.size() && ((bits[word] >> (squares % kWordBits)) & 1U) != 0;
}

std::vector<LatticePoint> AnswerLattice::pointsOf(
    const PublishedGroup& group,
    std::uint64_t n,
    PublishedConvention::Divisor divisor,
    RoundingRule rounding) const {
  if (n < 2 || n >= squares_.size()) throw std::invalid_argument("a group that was not counted");
  const auto count = static_cast<std::int64_t>(n);
  const std::int64_t parts = scale_.parts;
  const bool isSample = divisor == PublishedConvention::Divisor::Sample;
  const std::int64_t freedom = isSample ? count - 1 : count;

  std::vector<LatticePoint> points;
  for (std::uint64_t sum = 0; sum <= n * steps_; ++sum) {
    const auto total = static_cast<std::int64_t>(sum);
    const std::int64_t scaledMean = total + count * parts * scale_.lowest;  // · n · parts
    if (!group.mean.matchesQuotient(scaledMean, count * parts, rounding)) continue;
    // For whole u from 0 to steps, u ≤ u² ≤ u · steps.
    for (std::uint64_t squares = sum; squares <= sum * steps_; ++squares) {
      if (!isAttainable(n, sum, squares)) continue;
      const std::int64_t over = count * static_cast<std::int64_t>(squares) - total * total;
      const std::int64_t under = count * freedom * parts * parts;
      const bool isPrinted = group.isStandardDeviation
                                 ? group.spread.matchesRootOf(over, under, rounding)
                                 : group.spread.matchesQuotient(over, under, rounding);
      if (!isPrinted) continue;
      points.push_back(
          {.n = n,
           .mean = static_cast<double>(scaledMean) / static_cast<double>(count * parts),
           .variance =
               static_cast<double>(over) / static_cast<double>(count * (count - 1) * parts * parts),
           .sum = sum,
           .squares = squares});
    }
  }
  return points;
}

std::vector<std::uint64_t> AnswerLattice::answersOf(const LatticePoint& point) const {
  std::vector<std::uint64_t> counts(steps_ + 1, 0);
  auto [sum, squares] = std::pair(point.sum, point.squares);
  // squares_ guarantees that after each answer the remaining sums are attainable with the remaining
  // answers.
  for (std::uint64_t remaining = point.n; remaining > 0; --remaining) {
    std::uint64_t u = 0;
    while (u > sum || u * u > squares || sum - u > (remaining - 1) * steps_ ||
           !isAttainable(remaining - 1, sum - u, squares - u * u)) {
      if (++u > steps_) throw std::logic_error("no answers have this sum and sum of squares");
    }
    ++counts[u];
    sum -= u;
    squares -= u * u;
  }
  return counts;
}

}  // namespace analysis
