#include "analysis/registry/test_data.h"

#include <gtest/gtest.h>

#include "analysis/data/csv_table.h"
#include "tests/support/complaint.h"

namespace test_data_test {

using analysis::DataShape;
using analysis::readTestData;
using Names = std::vector<std::string>;
using Values = std::vector<double>;

analysis::TestData twoGroups(
    std::string_view csv, std::string_view groupColumn = "g", std::string_view valueColumn = "x") {
  return readTestData(
      csv,
      DataShape::TwoGroups,
      {{"group", {std::string(groupColumn)}}, {"value", {std::string(valueColumn)}}});
}

std::string errorOf(
    std::string_view csv, std::string_view groupColumn = "g", std::string_view valueColumn = "x") {
  return tests::complaintOf([&] { twoGroups(csv, groupColumn, valueColumn); });
}

TEST(TestDataOfTwoGroups, ComeInTheOrderOfTheFile) {
  const auto groups = twoGroups("n,x,g\n1,4,fem\n2,5.5,kalman\n3,3,fem\n", "g", "x");

  EXPECT_EQ(groups.values.at(0).name, "fem");
  EXPECT_EQ(groups.values.at(0).values, (Values{4.0, 3.0}));
  EXPECT_EQ(groups.values.at(1).name, "kalman");
  EXPECT_EQ(groups.values.at(1).values, Values{5.5});
  EXPECT_EQ(groups.missing, 0U);
}

TEST(TestDataOfTwoGroups, LeaveMissingValuesOutAndCountThem) {
  const auto groups = twoGroups("g,x\na,1\na,\nb,NA\n,3\nNA,4\nb,2\n", "g", "x");

  EXPECT_EQ(groups.values.at(0).values, Values{1.0});
  EXPECT_EQ(groups.values.at(1).values, Values{2.0});
  EXPECT_EQ(groups.missing, 4U);
}

TEST(TestDataOfTwoGroups, KeepAGroupThatHasNoValues) {
  const auto groups = twoGroups("g,x\na,1\nb,NA\na,2\n", "g", "x");

  EXPECT_EQ(groups.values.at(1).name, "b");
  EXPECT_TRUE(groups.values.at(1).values.empty());
}

TEST(TestDataOfTwoGroups, MayHaveADecimalCommaBetweenSemicolons) {
  const auto groups = twoGroups("g;x\na;1,5\nb;2.5\n", "g", "x");

  EXPECT_EQ(groups.values.at(0).values, Values{1.5});
  EXPECT_EQ(groups.values.at(1).values, Values{2.5});
}

TEST(TestDataOfTwoGroups, MayComeFromASpreadsheet) {
  const auto groups =
      twoGroups("\xEF\xBB\xBF\"the group\"\t\"x\"\r\nä\t-1e-3\r\nö\t\"2\"\r\n", "the group", "x");

  EXPECT_EQ(groups.values.at(0).name, "ä");
  EXPECT_EQ(groups.values.at(0).values, Values{-0.001});
  EXPECT_EQ(groups.values.at(1).values, Values{2.0});
}

TEST(TestDataOfTwoGroups, ListTheColumnsIfOneIsMissing) {
  EXPECT_EQ(
      errorOf("method,score\na,1\nb,2\n", "methods", "score"),
      "there is no column 'methods'; the columns are 'method' and 'score'; did you mean 'method'?");
  EXPECT_EQ(
      errorOf("method,score\na,1\nb,2\n", "method", "Score"),
      "there is no column 'Score'; the columns are 'method' and 'score'; did you mean 'score'?");
}

TEST(TestDataOfTwoGroups, NameTheLinesWithoutANumber) {
  EXPECT_EQ(
      errorOf("g,x\na,1\nb,good\na,inf\nb,nan\n"),
      "line 3: 'good' is no number\nline 4: 'inf' is no number\nline 5: 'nan' is no number");
  EXPECT_EQ(
      errorOf("g,x\na,1\nb,\"2,5\"\n"),
      "line 3: '2,5' is no number; write the decimals after a point");
  EXPECT_EQ(errorOf("g;x\na;1\nb;1.234,5\n"), "line 3: '1.234,5' is no number");
}

TEST(TestDataOfTwoGroups, AreTwoGroupsNeitherMoreNorFewer) {
  EXPECT_EQ(
      errorOf("g,x\na,1\nb,2\nc,3\n"),
      "the column 'g' has 3 groups, 'a', 'b' and 'c'; two are compared");
  EXPECT_EQ(errorOf("g,x\na,1\na,2\n"), "the column 'g' has one group only, 'a'; two are compared");
  EXPECT_EQ(errorOf("g,x\nNA,1\n"), "the column 'g' has no groups; two are compared");
}

TEST(TestDataOfTwoGroups, NameNoMoreThanEightOfTooManyGroups) {
  std::string csv = "g,x\n";
  for (char name = 'a'; name < 'a' + 11; ++name) csv += std::string(1, name) + ",1\n";
  EXPECT_EQ(
      errorOf(csv),
      "the column 'g' has 11 groups, 'a', 'b', 'c', 'd', 'e', 'f', 'g', 'h' and 3 more; two are "
      "compared");
}

TEST(TestDataOfTwoGroups, NeedRows) {
  EXPECT_EQ(errorOf(""), "the file is empty");
  EXPECT_EQ(errorOf("g,x\n"), "the file has a header and no rows");
}

TEST(TestDataOfTwoGroups, PassOnTheProblemsOfTheTable) {
  EXPECT_EQ(
      errorOf("g,x\na,1\nb,\"2\n"), "line 3: a quotation mark is opened here and never closed");
  EXPECT_EQ(errorOf("g,x\na\n"), "line 2 has 1 cell, and the header has 2 columns");
}

std::string errorOf(std::string_view csv, DataShape shape, const analysis::ChosenColumns& chosen) {
  return tests::complaintOf([&] { readTestData(csv, shape, chosen); });
}

TEST(TestData, UsesColumnsInTheOrderOfTheFileByDefault) {
  const auto pairs = readTestData("before,after\n1,2\n3,5\n", DataShape::Pairs, {});
  EXPECT_EQ(pairs.values.at(0).name, "before");
  EXPECT_EQ(pairs.values.at(0).values, (Values{1.0, 3.0}));
  EXPECT_EQ(pairs.values.at(1).values, (Values{2.0, 5.0}));
  EXPECT_EQ(
      errorOf("x\n1\n", DataShape::Pairs, {}),
      "the file has 1 column, and the test needs --first, --second");
}

TEST(TestData, LeavesOutALineWithAMissingCell) {
  const auto data = readTestData("a,b,c\n1,2,3\n4,NA,6\n7,8,9\n", DataShape::Columns, {});
  EXPECT_EQ(data.lines(), (std::vector<Values>{{1.0, 2.0, 3.0}, {7.0, 8.0, 9.0}}));
  EXPECT_EQ(data.missing, 1U);
}

TEST(TestData, UsesOnlyTheNamedColumns) {
  const auto data =
      readTestData("who,a,b,c\nP1,1,2,3\n", DataShape::Columns, {{"columns", {"c", "a"}}});
  EXPECT_EQ(data.lines(), (std::vector<Values>{{3.0, 1.0}}));
}

TEST(TestData, RefusesAColumnThatTheTestDoesNotUse) {
  EXPECT_EQ(
      errorOf("g,x,who\na,1,P1\n", DataShape::TwoGroups, {{"cluster", {"who"}}}),
      "the test does not use --cluster; it uses --group, --value");
}

TEST(TestData, RefusesAColumnThatIsLeftOver) {
  EXPECT_EQ(
      errorOf("before,after,age\n1,2,30\n", DataShape::Pairs, {}),
      "column 'age' is not used: choose the test's columns with --first, --second");
  EXPECT_EQ(
      errorOf("who,g,x\nP1,a,1\n", DataShape::Groups, {{"group", {"g"}}}),
      "column 'x' is not used: choose the test's columns with --group, --value");
  EXPECT_EQ(
      errorOf("x,y,people\na,b,3\n", DataShape::Categories, {}),
      "column 'people' is not used: choose the test's columns with --first, --second, --count");
  EXPECT_EQ(
      errorOf(
          "age,after,before\n30,2,1\n",
          DataShape::Pairs,
          {{"first", {"before"}}, {"second", {"after"}}}),
      "");
}

TEST(TestData, UsesAnOptionalColumnOfTheFileByItsName) {
  using Counts = std::vector<std::uint64_t>;
  EXPECT_EQ(
      readTestData("count,x,y\n5,a,a\n3,a,b\n", DataShape::Categories, {}).counts, (Counts{5, 3}));
  EXPECT_EQ(readTestData("value,count\na,5\n", DataShape::Votes, {}).counts, Counts{5});
  EXPECT_EQ(
      readTestData("who,g,x,round\nP1,a,1,2\nP1,b,2,1\n", DataShape::Clusters, {})
          .factor("round")
          .levels,
      (Names{"2", "1"}));
}

TEST(TestData, UsesNoColumnTwice) {
  const auto groups = readTestData("x,g\n1,a\n2,b\n", DataShape::TwoGroups, {{"group", {"g"}}});
  EXPECT_EQ(groups.values.at(0).values, Values{1.0});
}

TEST(TestData, CountsHowOftenNamesOccurTogether) {
  const auto data = readTestData(
      "before,after,people\nfem,kalman,3\nkalman,fem,1\nfem,fem,2\n",
      DataShape::BeforeAfter,
      {{"count", {"people"}}});
  const auto table = analysis::contingencyTableOf(data, true);
  EXPECT_EQ(table.rows, (Names{"fem", "kalman"}));
  EXPECT_EQ(table.counts, (std::vector<std::vector<std::uint64_t>>{{2, 3}, {1, 0}}));
}

TEST(TestData, HasRowsAndColumnsForDifferentNames) {
  const auto data =
      readTestData("who,said\nstudent,no\nsurgeon,yes\nstudent,yes\n", DataShape::Categories, {});
  const auto table = analysis::contingencyTableOf(data, false);
  EXPECT_EQ(table.rows, (Names{"student", "surgeon"}));
  EXPECT_EQ(table.columns, (Names{"no", "yes"}));
  EXPECT_EQ(table.counts, (std::vector<std::vector<std::uint64_t>>{{1, 1}, {0, 1}}));
}

TEST(TestData, RefusesANumberOfCasesThatIsNotWhole) {
  EXPECT_EQ(
      errorOf("v,n\nfem,1.5\nfem,-2\n", DataShape::Votes, {{"count", {"n"}}}),
      "line 2: '1.5' is no number of cases, which is whole and not negative\n"
      "line 3: '-2' is no number of cases, which is whole and not negative");
}

}  // namespace test_data_test
