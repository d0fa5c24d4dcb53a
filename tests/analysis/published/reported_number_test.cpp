#include <gtest/gtest.h>

#include "analysis/published/published_table.h"

namespace reported_number_test {

using analysis::Reading;
using analysis::reportedNumber;

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
  const auto rounded = reportedNumber("4.1")->bounds(Reading::Rounded);
  EXPECT_DOUBLE_EQ(rounded.low, 4.05);
  EXPECT_DOUBLE_EQ(rounded.high, 4.15);
  const auto truncated = reportedNumber("4.1")->bounds(Reading::Truncated);
  EXPECT_DOUBLE_EQ(truncated.low, 4.1);
  EXPECT_DOUBLE_EQ(truncated.high, 4.2);
  const auto below = reportedNumber("-4.1")->bounds(Reading::Truncated);
  EXPECT_DOUBLE_EQ(below.low, -4.2);
  EXPECT_DOUBLE_EQ(below.high, -4.1);
  const auto zero = reportedNumber("0.0")->bounds(Reading::Truncated);
  EXPECT_DOUBLE_EQ(zero.low, -0.1);
  EXPECT_DOUBLE_EQ(zero.high, 0.1);
}

TEST(ReportedNumber, DecidesTiesExactly) {
  const auto number = *reportedNumber("4.1");
  EXPECT_TRUE(number.prints(81, 20, Reading::Rounded));  // 4.05: a half may go either way
  EXPECT_TRUE(number.prints(83, 20, Reading::Rounded));  // 4.15
  EXPECT_FALSE(number.prints(404, 100, Reading::Rounded));
  EXPECT_TRUE(number.prints(41, 10, Reading::Truncated));
  EXPECT_FALSE(number.prints(42, 10, Reading::Truncated));
  EXPECT_FALSE(number.prints(409, 100, Reading::Truncated));
  EXPECT_TRUE(reportedNumber("-4.1")->prints(-419, 100, Reading::Truncated));
  EXPECT_TRUE(reportedNumber("0.0")->prints(-9, 100, Reading::Truncated));
}

TEST(ReportedNumber, DecidesRootsExactly) {
  const auto number = *reportedNumber("1.1");
  EXPECT_TRUE(number.printsRootOf(11025, 10000, Reading::Rounded));  // 1.05²
  EXPECT_FALSE(number.printsRootOf(11024, 10000, Reading::Rounded));
  EXPECT_TRUE(number.printsRootOf(121, 100, Reading::Truncated));
  EXPECT_FALSE(number.printsRootOf(144, 100, Reading::Truncated));
  EXPECT_TRUE(reportedNumber("0.0")->printsRootOf(0, 1, Reading::Rounded));
}

}  // namespace reported_number_test
