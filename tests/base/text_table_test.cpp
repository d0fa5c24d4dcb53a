#include "base/text_table.h"

#include <cstdint>
#include <locale>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace text_table_test {

using base::characterCount;
using base::DecimalMark;
using base::decimalNumber;
using base::numberFrom;
using Cells = std::vector<std::string>;

TEST(DecimalNumber, IsTheNearestDouble) {
  EXPECT_EQ(decimalNumber("4"), 4.0);
  EXPECT_EQ(decimalNumber("-0.1"), -0.1);
  EXPECT_EQ(decimalNumber("+2.5e3"), 2500.0);
  EXPECT_EQ(decimalNumber("0.30000000000000004"), 0.1 + 0.2);
  EXPECT_EQ(decimalNumber("1e-200"), 1e-200);
  EXPECT_EQ(decimalNumber("5e-324"), 5e-324);
  // The classic that a careless reader rounds twice: just above the middle of two doubles.
  EXPECT_EQ(decimalNumber("9007199254740993.00000000001"), 9007199254740994.0);
}

TEST(DecimalNumber, RejectsOtherText) {
  for (const char* text :
       {"",
        " ",
        "four",
        "4 ",
        " 4",
        "4x",
        "0x10",
        "1_000",
        "1 000",
        "--1",
        "+-1",
        "+",
        ".",
        "1.2.3",
        "4,5"}) {
    EXPECT_FALSE(decimalNumber(text).has_value()) << text;
  }
}

TEST(DecimalNumber, RejectsInfinityAndNumbersOutOfRange) {
  for (const char* text : {"inf", "-Inf", "infinity", "nan", "NaN", "1e999", "-1e999", "1e-999"}) {
    EXPECT_FALSE(decimalNumber(text).has_value()) << text;
  }
}

TEST(DecimalNumber, ReadsADecimalCommaWhereOneIsAllowed) {
  EXPECT_EQ(decimalNumber("4,5", DecimalMark::PointOrComma), 4.5);
  EXPECT_EQ(decimalNumber("4.5", DecimalMark::PointOrComma), 4.5);
  EXPECT_EQ(decimalNumber("-1,5e2", DecimalMark::PointOrComma), -150.0);
  EXPECT_FALSE(decimalNumber("1.234,5", DecimalMark::PointOrComma).has_value());
  EXPECT_FALSE(decimalNumber("1,234,5", DecimalMark::PointOrComma).has_value());
}

/// As a German desktop would have it.
class CommaLocale : public std::numpunct<char> {
 protected:
  char do_decimal_point() const override { return ','; }
  char do_thousands_sep() const override { return '.'; }
  std::string do_grouping() const override { return "\3"; }
};

TEST(DecimalNumber, DoesNotDependOnTheLocale) {
  const std::locale before = std::locale::global(std::locale(std::locale(), new CommaLocale));
  const auto number = decimalNumber("1234.5");
  std::locale::global(before);

  EXPECT_EQ(number, 1234.5);
}

TEST(CharacterCount, CountsCharactersAndNotBytes) {
  EXPECT_EQ(characterCount(""), 0U);
  EXPECT_EQ(characterCount("α – µ"), 5U);
}

TEST(NumberFrom, IsWhatTheWholeTextIs) {
  EXPECT_EQ(numberFrom<int>("-12"), -12);
  EXPECT_EQ(numberFrom<std::uint64_t>("18446744073709551615"), 18446744073709551615U);
  EXPECT_EQ(numberFrom<double>("0.1"), 0.1);
  for (const auto* text : {"", "1 ", " 1", "+1", "1.5", "one", "2147483648"}) {
    EXPECT_FALSE(numberFrom<int>(text)) << text;
  }
  EXPECT_FALSE(numberFrom<std::uint64_t>("-1"));
}

TEST(TextTable, TrimsCellsAndCountsEmptyOnes) {
  EXPECT_EQ(base::cellsOf(" a;\"b c\" ;;1,5\r", ';'), (Cells{"a", "b c", "", "1,5"}));
  EXPECT_EQ(base::cellsOf(" 1 \t 2\r", ' '), (Cells{"1", "2"}));
}

TEST(TextTable, NumbersTheLinesThatHoldCells) {
  const auto lines = base::linesOf(base::withoutByteOrderMark("\xEF\xBB\xBFt\n\n \t\r\n1"));
  ASSERT_EQ(lines.size(), 2U);
  EXPECT_EQ(lines[0].text, "t");
  EXPECT_EQ(lines[1].number, 4U);
}

TEST(TextTable, FindsTheUnitInAHead) {
  const std::vector<Cells> heads{
      {"Weg [mm]", "Weg", "mm"}, {"force_n", "force", "n"}, {"Zeit", "Zeit", ""}};
  for (const auto& head : heads) {
    EXPECT_EQ(base::columnHeadingOf(head[0]).name, head[1]);
    EXPECT_EQ(base::columnHeadingOf(head[0]).unit, head[2]);
  }
}

}  // namespace text_table_test
