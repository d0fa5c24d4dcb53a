#pragma once

#include <cstdint>
#include <vector>

#include "analysis/published/published_convention.h"
#include "analysis/published/published_table.h"

namespace analysis {

/// An answer scale: lowest, lowest + 1/parts … highest. An answer that is the mean of two
/// statements on 1 … 5 has parts = 2.
struct AnswerScale {
  int lowest = 1;
  int highest = 5;
  int parts = 1;
};

/// One possible mean and variance of the answers of a group.
struct LatticePoint {
  std::uint64_t n = 0;
  double mean = 0.0;
  double variance = 0.0;      ///< divided by n − 1
  std::uint64_t sum = 0;      ///< Σ u, an answer being lowest + u/parts
  std::uint64_t squares = 0;  ///< Σ u²

  bool operator==(const LatticePoint&) const = default;
};

/// All pairs of a sum S and a sum of squares Q that n answers on a scale can have.
///
/// A printed mean may be impossible for n whole-numbered answers (GRIM, Brown & Heathers 2017), and
/// so may a variance together with a mean (GRIMMER, Anaya 2016). These tests are necessary
/// conditions; this class enumerates the possible pairs, so that its result is exact.
class AnswerLattice {
 public:
  static constexpr int kMostPoints = 101;
  /// The largest number of combinations of n, S and Q that is enumerated, within some seconds.
  static constexpr double kMostPairs = 1e9;

  /// Enumerates the pairs for groups of up to @p mostAnswers answers.
  /// @throws std::invalid_argument  for a scale of fewer than two points or more than kMostPoints,
  ///     for parts that are not positive, and for more than kMostPairs combinations.
  AnswerLattice(const AnswerScale& scale, std::uint64_t mostAnswers);

  /// All S and Q whose mean and variance would be printed like those of @p group. Computed exactly,
  /// in whole numbers.
  /// @param n  2 … mostAnswers.
  std::vector<LatticePoint> pointsOf(
      const PublishedGroup& group,
      std::uint64_t n,
      PublishedConvention::Divisor divisor,
      RoundingRule rounding) const;

  /// One set of answers with this sum and sum of squares, as the count of each point of the scale
  /// from the lowest.
  /// @param point  one that pointsOf() returned.
  std::vector<std::uint64_t> answersOf(const LatticePoint& point) const;

 private:
  using Bits = std::vector<std::uint64_t>;

  bool isAttainable(std::uint64_t n, std::uint64_t sum, std::uint64_t squares) const;

  AnswerScale scale_;
  std::uint64_t steps_ = 0;                 ///< answers are lowest + u/parts, u = 0 … steps_
  std::vector<std::vector<Bits>> squares_;  ///< [n][Σ u]: a bit for every possible Σ u²
};

}  // namespace analysis
