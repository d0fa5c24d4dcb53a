#include "analysis/published/published_table.h"

#include <gtest/gtest.h>

#include "analysis/data/csv_table.h"
#include "tests/support/complaint.h"

namespace published_table_test {

using analysis::PublishedP;
using analysis::readPublishedTable;
using analysis::RoundingRule;

constexpr const char* kComparisons = "group1,group2,p\nI,F,< .017\nI,K,.021\n";

std::string refusalOf(const std::string& groups, const std::string& comparisons) {
  return tests::complaintOf([&] { readPublishedTable(groups, comparisons); });
}

TEST(PublishedTable, ReadsGroupsAndComparisons) {
  const auto table = readPublishedTable(
      "group,n,mean,variance\nI,36,4.1,1.3\nF,,2.6,2.6\nK,NA,3.2,2.4\n", kComparisons);
  ASSERT_EQ(table.groups.size(), 3U);
  EXPECT_EQ(table.groups[0].n, 36U);
  EXPECT_FALSE(table.groups[1].n);
  EXPECT_FALSE(table.groups[2].n);
  EXPECT_EQ(table.groups[2].mean.digits, 32);
  EXPECT_FALSE(table.groups[0].isStandardDeviation);
  ASSERT_EQ(table.comparisons.size(), 2U);
  EXPECT_EQ(table.comparisons[1].second, 2U);
  EXPECT_EQ(table.comparisons[0].p.text(), "< .017");
  EXPECT_DOUBLE_EQ(table.comparisons[0].p.bounds(RoundingRule::Rounded).high, 0.017);
  EXPECT_DOUBLE_EQ(table.comparisons[1].p.bounds(RoundingRule::Rounded).low, 0.0205);
}

TEST(PublishedTable, ReadsStandardDeviationsAndDecimalCommas) {
  const auto table =
      readPublishedTable("group;mean;sd\nI;4,1;1,1\nF;2,6;1,6\n", "group1;group2;p\nI;F;> 0,05\n");
  EXPECT_TRUE(table.groups[1].isStandardDeviation);
  EXPECT_EQ(table.groups[1].spread.digits, 16);
  EXPECT_EQ(table.comparisons[0].p.relation, PublishedP::Relation::Above);
  EXPECT_DOUBLE_EQ(table.comparisons[0].p.bounds(RoundingRule::Truncated).low, 0.05);
}

TEST(PublishedTable, ReportsAllProblemsAtOnce) {
  const auto refusal = refusalOf(
      "group,n,mean,variance\nI,1,4.1,1.3\nI,36,vier,-2\n", "group1,group2,p\nI,X,1.2\nI,I,.5\n");
  for (const char* phrase :
       {"groups, line 2: '1' is no size",
        "line 3: a second group is called 'I'",
        "'vier' is no mean",
        "a variance is never negative",
        "comparisons, line 2: there is no group 'X'",
        "'1.2' is no p",
        "not compared with itself"}) {
    EXPECT_NE(refusal.find(phrase), std::string::npos) << phrase << "\nin\n" << refusal;
  }
}

TEST(PublishedTable, RejectsMissingColumnsAndRows) {
  EXPECT_NE(refusalOf("group,mean\nI,4.1\n", kComparisons).find("'variance'"), std::string::npos);
  const auto none = refusalOf("group,mean,sd\nI,4.1,1.0\n", "group1,group2,p\n");
  EXPECT_NE(none.find("2 to 8 groups"), std::string::npos) << none;
  EXPECT_NE(none.find("1 to 28 comparisons"), std::string::npos) << none;
}

}  // namespace published_table_test
