#include "analysis/data/likert_counts.h"

#include <random>
#include <stdexcept>

#include <gtest/gtest.h>

#include "analysis/data/moments.h"

namespace likert_counts_test {

using analysis::LikertCounts;
using Counts = std::vector<std::uint64_t>;

LikertCounts counts(int lowest, const Counts& each) {
  return {lowest, each};
}

TEST(LikertCounts, HaveTheScaleTheyWereMadeWith) {
  const LikertCounts answers(1, 7);
  EXPECT_EQ(answers.lowest(), 1);
  EXPECT_EQ(answers.highest(), 7);
  EXPECT_EQ(answers.counts().size(), 7U);
  EXPECT_EQ(answers.total(), 0U);
}

TEST(LikertCounts, CountAnswers) {
  LikertCounts answers(1, 5);
  answers.add(5);
  answers.add(2, 3);

  EXPECT_EQ(answers, counts(1, {0, 3, 0, 0, 1}));
  EXPECT_EQ(answers.total(), 4U);
}

TEST(LikertCounts, RejectAnswersOutsideTheScale) {
  LikertCounts answers(1, 5);
  EXPECT_THROW(answers.add(0), std::invalid_argument);
  EXPECT_THROW(answers.add(6), std::invalid_argument);
  EXPECT_EQ(answers.total(), 0U);
}

TEST(LikertCounts, RejectInvalidScales) {
  EXPECT_THROW(LikertCounts(1, 1), std::invalid_argument);
  EXPECT_THROW(LikertCounts(5, 1), std::invalid_argument);
  EXPECT_THROW(LikertCounts(0, 5000), std::invalid_argument);
  EXPECT_THROW(LikertCounts(2'000'000, 2'000'005), std::invalid_argument);
  EXPECT_THROW(LikertCounts(-2147483647, 2147483647), std::invalid_argument);
  EXPECT_THROW(counts(1, {3}), std::invalid_argument);
}

TEST(LikertCounts, RejectMoreThanTheyCanSumExactly) {
  LikertCounts answers(1, 5);
  answers.add(1, LikertCounts::kMostAnswers);
  EXPECT_THROW(answers.add(1), std::invalid_argument);
  EXPECT_THROW(counts(1, {~std::uint64_t{0}, 2}), std::invalid_argument);
}

TEST(LikertCounts, HaveMeanAndVariance) {
  const auto answers = counts(1, {0, 0, 2, 0, 1});  // 3, 3, 5
  EXPECT_EQ(answers.mean(), 11.0 / 3.0);
  EXPECT_EQ(answers.variance(), 4.0 / 3.0);  // R: var(c(3, 3, 5))
}

TEST(LikertCounts, HaveNoVarianceBelowTwoAnswers) {
  LikertCounts answers(1, 5);
  EXPECT_FALSE(answers.mean().has_value());
  answers.add(4);
  EXPECT_EQ(answers.mean(), 4.0);
  EXPECT_FALSE(answers.variance().has_value());
}

TEST(LikertCounts, HaveZeroVarianceWhereAllAnswersAreEqual) {
  EXPECT_EQ(counts(1, {0, 0, 0, 0, 1'000'000}).variance(), 0.0);
}

TEST(LikertCounts, RoundMeanAndVarianceExactly) {
  std::mt19937_64 random(7);
  for (int i = 0; i < 1000; ++i) {
    Counts each(5);
    std::uint64_t n = 0;
    std::uint64_t sum = 0;
    std::uint64_t squares = 0;
    for (std::uint64_t point = 1; point <= 5; ++point) {
      const auto times = random() % 1'000'000;
      each[point - 1] = times;
      n += times;
      sum += point * times;
      squares += point * point * times;
    }
    // All four below are whole numbers under 2^53, and a processor rounds their quotient exactly.
    const auto answers = counts(1, each);
    ASSERT_EQ(answers.mean(), static_cast<double>(sum) / static_cast<double>(n));
    ASSERT_EQ(
        answers.variance(),
        static_cast<double>(n * squares - sum * sum) / static_cast<double>(n * (n - 1)));
  }
}

TEST(LikertCounts, SumTheWidestScaleAndTheMostAnswersExactly) {
  LikertCounts answers(-1'000'000, -1'000'000 + LikertCounts::kMostPoints - 1);
  answers.add(answers.lowest(), LikertCounts::kMostAnswers / 2);
  answers.add(answers.highest(), LikertCounts::kMostAnswers / 2);

  EXPECT_EQ(answers.mean(), -1'000'000 + 1023.0 / 2.0);
  // n / (n − 1) · (1023 / 2)², n = 2^40
  EXPECT_DOUBLE_EQ(answers.variance().value(), 1023.0 * 1023.0 / 4.0 * (1.0 + 0x1p-40));
}

TEST(LikertCounts, EqualTheMomentsOfTheSingleAnswers) {
  const auto answers = counts(0, {7, 4, 3, 7, 9, 0, 2});
  std::vector<double> values;
  double point = 0.0;
  for (const auto times : answers.counts()) values.insert(values.end(), times, point++);

  const auto fromCounts = analysis::summarise(analysis::momentsOf(answers));
  const auto fromValues = analysis::summarise(values);
  EXPECT_EQ(fromCounts.n, fromValues.n);
  EXPECT_EQ(fromCounts.mean, fromValues.mean);
  EXPECT_EQ(fromCounts.variance, fromValues.variance);
}

}  // namespace likert_counts_test
