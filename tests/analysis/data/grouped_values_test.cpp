#include "analysis/data/grouped_values.h"

#include <gtest/gtest.h>

#include "analysis/data/error.h"

namespace grouped_values_test {

using analysis::readGroupedValues;
using Values = std::vector<double>;

std::string errorOf(
    std::string_view csv, std::string_view groupColumn = "g", std::string_view valueColumn = "x") {
  try {
    readGroupedValues(csv, groupColumn, valueColumn);
  } catch (const analysis::Error& error) {
    return error.what();
  }
  return "no error";
}

TEST(GroupedValues, ComeInTheOrderOfTheFile) {
  const auto groups = readGroupedValues("n,x,g\n1,4,fem\n2,5.5,kalman\n3,3,fem\n", "g", "x");

  EXPECT_EQ(groups.group1.name, "fem");
  EXPECT_EQ(groups.group1.values, (Values{4.0, 3.0}));
  EXPECT_EQ(groups.group2.name, "kalman");
  EXPECT_EQ(groups.group2.values, Values{5.5});
  EXPECT_EQ(groups.missing, 0U);
}

TEST(GroupedValues, LeaveOutAndCountWhatIsMissing) {
  const auto groups = readGroupedValues("g,x\na,1\na,\nb,NA\n,3\nNA,4\nb,2\n", "g", "x");

  EXPECT_EQ(groups.group1.values, Values{1.0});
  EXPECT_EQ(groups.group2.values, Values{2.0});
  EXPECT_EQ(groups.missing, 4U);
}

TEST(GroupedValues, KeepAGroupThatHasNoValues) {
  const auto groups = readGroupedValues("g,x\na,1\nb,NA\na,2\n", "g", "x");

  EXPECT_EQ(groups.group2.name, "b");
  EXPECT_TRUE(groups.group2.values.empty());
}

TEST(GroupedValues, MayHaveADecimalCommaBetweenSemicolons) {
  const auto groups = readGroupedValues("g;x\na;1,5\nb;2.5\n", "g", "x");

  EXPECT_EQ(groups.group1.values, Values{1.5});
  EXPECT_EQ(groups.group2.values, Values{2.5});
}

TEST(GroupedValues, MayComeFromASpreadsheet) {
  const auto groups = readGroupedValues(
      "\xEF\xBB\xBF\"the group\"\t\"x\"\r\nä\t-1e-3\r\nö\t\"2\"\r\n", "the group", "x");

  EXPECT_EQ(groups.group1.name, "ä");
  EXPECT_EQ(groups.group1.values, Values{-0.001});
  EXPECT_EQ(groups.group2.values, Values{2.0});
}

TEST(GroupedValues, NameTheColumnsWhereOneIsNotThere) {
  EXPECT_EQ(
      errorOf("method,score\na,1\nb,2\n", "methods", "score"),
      "there is no column 'methods'; the columns are 'method' and 'score'; did you mean 'method'?");
  EXPECT_EQ(
      errorOf("method,score\na,1\nb,2\n", "method", "Score"),
      "there is no column 'Score'; the columns are 'method' and 'score'; did you mean 'score'?");
}

TEST(GroupedValues, NameTheLinesOfWhatIsNoNumber) {
  EXPECT_EQ(
      errorOf("g,x\na,1\nb,good\na,inf\nb,nan\n"),
      "line 3: 'good' is no number\nline 4: 'inf' is no number\nline 5: 'nan' is no number");
  EXPECT_EQ(
      errorOf("g,x\na,1\nb,\"2,5\"\n"),
      "line 3: '2,5' is no number; write the decimals after a point");
  EXPECT_EQ(errorOf("g;x\na;1\nb;1.234,5\n"), "line 3: '1.234,5' is no number");
}

TEST(GroupedValues, AreTwoGroupsNeitherMoreNorFewer) {
  EXPECT_EQ(
      errorOf("g,x\na,1\nb,2\nc,3\n"),
      "the column 'g' has 3 groups, 'a', 'b' and 'c'; two are compared");
  EXPECT_EQ(errorOf("g,x\na,1\na,2\n"), "the column 'g' has one group only, 'a'; two are compared");
  EXPECT_EQ(errorOf("g,x\nNA,1\n"), "the column 'g' has no groups; two are compared");
}

TEST(GroupedValues, NameNoMoreThanEightOfTooManyGroups) {
  std::string csv = "g,x\n";
  for (char name = 'a'; name < 'a' + 11; ++name) csv += std::string(1, name) + ",1\n";
  EXPECT_EQ(
      errorOf(csv),
      "the column 'g' has 11 groups, 'a', 'b', 'c', 'd', 'e', 'f', 'g', 'h' and 3 more; two are "
      "compared");
}

TEST(GroupedValues, NeedRows) {
  EXPECT_EQ(errorOf(""), "the file is empty");
  EXPECT_EQ(errorOf("g,x\n"), "the file has a header and no rows");
}

TEST(GroupedValues, PassOnWhatIsWrongWithTheTable) {
  EXPECT_EQ(
      errorOf("g,x\na,1\nb,\"2\n"), "line 3: a quotation mark is opened here and never closed");
  EXPECT_EQ(errorOf("g,x\na\n"), "line 2 has 1 cell, and the header has 2 columns");
}

}  // namespace grouped_values_test
