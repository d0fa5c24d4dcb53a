#pragma once

#include <cstdint>
#include <vector>

#include "analysis/published/published_convention.h"
#include "analysis/published/published_table.h"

namespace analysis {

/// An answer scale: lowest, lowest + 1/parts … highest. Means of two statements on
/// 1 … 5 have parts = 2.
struct AnswerScale {
  int lowest = 1;
  int highest = 5;
  int parts = 1;
};

/// One possible mean and variance of the answers of a group.
struct LatticePoint {
  std::uint64_t n = 0;
  double mean = 0.0;
  double variance = 0.0;      ///< with n − 1
  std::uint64_t sum = 0;      ///< Σ u, an answer being lowest + u/parts
  std::uint64_t squares = 0;  ///< Σ u²

  bool operator==(const LatticePoint&) const = default;
};

/// The pairs of a sum S and a sum of squares Q that n answers on a scale can have at all.
///
/// Not every mean is a number of whole answers divided by n (GRIM, Brown & Heathers 2017), and not
/// every variance belongs to such a mean (GRIMMER, Anaya 2016). Here the possible pairs are
/// enumerated, answer by answer: the result is exact, not a necessary condition only.
class AnswerLattice {
 public:
  static constexpr int kMostPoints = 101;
  /// How many combinations of n, S and Q are enumerated at most: a matter of seconds.
  static constexpr double kMostPairs = 1e9;

  /// For groups of up to @p mostAnswers.
  /// @throws std::invalid_argument  for a scale of fewer than two points or more than kMostPoints,
  ///     for parts that are not positive, and beyond kMostPairs.
  AnswerLattice(const AnswerScale& scale, std::uint64_t mostAnswers);

  /// Every S and Q whose mean and variance would be printed as the group's are, in whole numbers
  /// and without any error.
  /// @param n  2 … mostAnswers.
  std::vector<LatticePoint> pointsOf(
      const PublishedGroup& group,
      std::uint64_t n,
      PublishedConvention::Divisor divisor,
      Reading reading) const;

  /// One set of answers with this sum and sum of squares: how often each point of the scale was
  /// given, from the lowest up.
  /// @param point  of pointsOf().
  std::vector<std::uint64_t> answersOf(const LatticePoint& point) const;

 private:
  using Bits = std::vector<std::uint64_t>;

  bool isAttainable(std::uint64_t n, std::uint64_t sum, std::uint64_t squares) const;

  AnswerScale scale_;
  std::uint64_t steps_ = 0;                 ///< answers are lowest + u/parts, u = 0 … steps_
  std::vector<std::vector<Bits>> squares_;  ///< [n][Σ u]: a bit for every possible Σ u²
};

}  // namespace analysis
