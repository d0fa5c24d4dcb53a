#include <cmath>

#include <gtest/gtest.h>

#include "analysis/hypothesis_tests/t_tests.h"

namespace student_test {

using analysis::LikertCounts;
using analysis::studentTTest;
using Values = std::vector<double>;
using Counts = std::vector<std::uint64_t>;

// R: sleep (Cushny & Peebles 1905)
const Values kSleep1{0.7, -1.6, -0.2, -1.2, -0.1, 3.4, 3.7, 0.8, 0.0, 2.0};
const Values kSleep2{1.9, 0.8, 1.1, 0.1, -0.1, 4.4, 5.5, 1.6, 4.6, 3.4};

TEST(StudentTest, IsThatOfStudentsOwnData) {
  // R: t.test(extra ~ group, data = sleep, var.equal = TRUE)
  const auto result = studentTTest(kSleep1, kSleep2);

  EXPECT_NEAR(result.t.value(), -1.8608, 5e-5);
  EXPECT_EQ(result.degreesOfFreedom, 18.0);
  EXPECT_NEAR(result.p.value(), 0.07918671421593811, 1e-15);
}

TEST(StudentTest, EqualsWelchsForEqualSizesAndVariances) {
  const Values a{1.0, 2.0, 3.0, 4.0};
  const Values b{3.0, 4.0, 5.0, 6.0};
  const auto student = studentTTest(a, b);
  const auto welch = analysis::welchTTest(a, b);

  EXPECT_EQ(student.t, welch.t);
  EXPECT_EQ(student.degreesOfFreedom, welch.degreesOfFreedom);
  EXPECT_EQ(student.p, welch.p);
}

TEST(StudentTest, NeedsOnlyOneValueInOneGroup) {
  // R: t.test(5, c(1, 2, 4), var.equal = TRUE) has t = (5 − 7/3) / √(7/3 · 4/3), df = 2
  const auto result = studentTTest(Values{5.0}, Values{1.0, 2.0, 4.0});

  EXPECT_DOUBLE_EQ(result.t.value(), (5.0 - 7.0 / 3.0) / std::sqrt(7.0 / 3.0 * 4.0 / 3.0));
  EXPECT_EQ(result.degreesOfFreedom, 2.0);
}

TEST(StudentTest, IsTheSameFromCounts) {
  const LikertCounts a(1, Counts{2, 1, 3, 11, 13});
  const LikertCounts b(1, Counts{7, 4, 3, 7, 9});

  EXPECT_NEAR(
      studentTTest(momentsOf(a), momentsOf(b)).p.value(),
      0.02327568710969033,
      1e-16);  // golden.json, t03
}

TEST(StudentTest, IsUndefinedWithoutSpread) {
  EXPECT_FALSE(studentTTest(Values{1.0}, Values{2.0}).t.has_value());
  EXPECT_FALSE(studentTTest(Values{}, Values{1.0, 2.0, 3.0}).t.has_value());
  EXPECT_FALSE(studentTTest(Values{4.0, 4.0}, Values{4.0, 4.0}).t.has_value());

  const auto differing = studentTTest(Values{4.0, 4.0}, Values{5.0, 5.0});
  EXPECT_EQ(differing.t, -INFINITY);
  EXPECT_FALSE(differing.p.has_value());
}

}  // namespace student_test
