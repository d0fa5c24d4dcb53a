#include <gtest/gtest.h>

#include "analysis/published/published_table.h"

namespace reported_number_test {

using analysis::reportedNumber;
using analysis::RoundingRule;

TEST(ReportedNumber, KeepsTrailingZeros) {
  const auto number = reportedNumber("4.10");
  ASSERT_TRUE(number);
  EXPECT_EQ(number->digits, 410);
  EXPECT_EQ(number->decimals, 2);
  EXPECT_DOUBLE_EQ(number->value(), 4.1);
  EXPECT_EQ(number->text(), "4.10");
  EXPECT_EQ(reportedNumber(".021")->text(), "0.021");
  EXPECT_EQ(reportedNumber("-.5")->text(), "-0.5");
  EXPECT_EQ(reportedNumber("-3")->text(), "-3");
}

TEST(ReportedNumber, RejectsOtherText) {
  for (const char* text : {"", ".", "-", "4.1.2", "4,1", "4.1 ", "1e3", "nan", "1234567890"}) {
    EXPECT_FALSE(reportedNumber(text)) << text;
  }
  EXPECT_EQ(reportedNumber("4,1", base::DecimalMark::PointOrComma)->digits, 41);
}

TEST(ReportedNumber, StandsForAnInterval) {
  const auto rounded = reportedNumber("4.1")->bounds(RoundingRule::Rounded);
  EXPECT_DOUBLE_EQ(rounded.low, 4.05);
  EXPECT_DOUBLE_EQ(rounded.high, 4.15);
  const auto truncated = reportedNumber("4.1")->bounds(RoundingRule::Truncated);
  EXPECT_DOUBLE_EQ(truncated.low, 4.1);
  EXPECT_DOUBLE_EQ(truncated.high, 4.2);
  const auto below = reportedNumber("-4.1")->bounds(RoundingRule::Truncated);
  EXPECT_DOUBLE_EQ(below.low, -4.2);
  EXPECT_DOUBLE_EQ(below.high, -4.1);
  const auto zero = reportedNumber("0.0")->bounds(RoundingRule::Truncated);
  EXPECT_DOUBLE_EQ(zero.low, -0.1);
  EXPECT_DOUBLE_EQ(zero.high, 0.1);
}

TEST(ReportedNumber, DecidesTiesExactly) {
  const auto number = *reportedNumber("4.1");
  EXPECT_TRUE(
      number.matchesQuotient(81, 20, RoundingRule::Rounded));  // 4.05: a half may go either way
  EXPECT_TRUE(number.matchesQuotient(83, 20, RoundingRule::Rounded));  // 4.15
  EXPECT_FALSE(number.matchesQuotient(404, 100, RoundingRule::Rounded));
  EXPECT_TRUE(number.matchesQuotient(41, 10, RoundingRule::Truncated));
  EXPECT_FALSE(number.matchesQuotient(42, 10, RoundingRule::Truncated));
  EXPECT_FALSE(number.matchesQuotient(409, 100, RoundingRule::Truncated));
  EXPECT_TRUE(reportedNumber("-4.1")->matchesQuotient(-419, 100, RoundingRule::Truncated));
  EXPECT_TRUE(reportedNumber("0.0")->matchesQuotient(-9, 100, RoundingRule::Truncated));
}

TEST(ReportedNumber, DecidesRootsExactly) {
  const auto number = *reportedNumber("1.1");
  EXPECT_TRUE(number.matchesRootOf(11025, 10000, RoundingRule::Rounded));  // 1.05²
  EXPECT_FALSE(number.matchesRootOf(11024, 10000, RoundingRule::Rounded));
  EXPECT_TRUE(number.matchesRootOf(121, 100, RoundingRule::Truncated));
  EXPECT_FALSE(number.matchesRootOf(144, 100, RoundingRule::Truncated));
  EXPECT_TRUE(reportedNumber("0.0")->matchesRootOf(0, 1, RoundingRule::Rounded));
}

}  // namespace reported_number_test
