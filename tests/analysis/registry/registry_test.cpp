#include "analysis/registry/registry.h"

#include <set>

#include <gtest/gtest.h>

#include "analysis/data/csv_table.h"
#include "base/joined.h"
#include "tests/support/complaint.h"
#include "tests/support/scratch_folder.h"
#include "tests/support/test_data.h"

namespace registry_test {

using analysis::StatisticalTest;

/// The columns of a test as docs/statistics.md has them: "group, value, count".
std::string columnsOf(const StatisticalTest& test) {
  return base::joined(analysis::columnsOf(test.shape), ", ", &analysis::DataColumn::role);
}

TEST(StatisticalTests, AreListedInTheManual) {
  const auto page = tests::contentOf((tests::repository() / "docs/statistics.md").string());
  const auto begin = page.find("## Tests by name");
  ASSERT_NE(begin, std::string::npos);
  const auto section = page.substr(begin, page.find("\n## ", begin + 1) - begin);
  std::string expected;
  for (const auto& test : analysis::statisticalTests()) {
    expected += "| `" + std::string(test.id) + "` | " + columnsOf(test) + " | " +
                std::string(test.title) + ": " + std::string(test.question) + " | " +
                std::string(test.source) + " |\n";
  }
  EXPECT_NE(section.find(expected), std::string::npos)
      << "the table of docs/statistics.md, \"Tests by name\", has to be:\n"
      << expected;
}

TEST(StatisticalTests, HaveANameOfTheirOwn) {
  std::set<std::string_view> ids;
  for (const auto& test : analysis::statisticalTests()) {
    EXPECT_TRUE(ids.insert(test.id).second) << test.id;
    EXPECT_FALSE(test.title.empty()) << test.id;
    EXPECT_NE(test.rows, nullptr) << test.id;
  }
  EXPECT_GE(ids.size(), 16U);
}

TEST(StatisticalTests, SuggestTheNearestNameForAnUnknownOne) {
  EXPECT_EQ(
      tests::complaintOf([] { analysis::statisticalTest("fischer_exact"); }),
      "There is no test 'fischer_exact'; did you mean 'fisher_exact'? 'palpate stats test --list' "
      "lists all.");
  EXPECT_EQ(
      tests::complaintOf([] { analysis::statisticalTest("nosuch"); }),
      "There is no test 'nosuch'. 'palpate stats test --list' lists all.");
}

analysis::TestData dataFor(const StatisticalTest& test, std::string_view csv) {
  return analysis::readTestData(csv, test.shape, {});
}

TEST(StatisticalTests, NeedABoundOnlyForEquivalence) {
  const auto& tost = analysis::statisticalTest("tost");
  EXPECT_NE(
      tests::complaintOf([&] {
        computeTest(tost, dataFor(tost, "x,y\n1,2\n2,2\n4,3\n"), {});
      }).find("--bound"),
      std::string::npos);
  const auto& sign = analysis::statisticalTest("sign_test");
  EXPECT_NE(
      tests::complaintOf([&] {
        computeTest(sign, dataFor(sign, "x,y\n1,2\n"), {.bound = 1.0});
      }).find("--bound"),
      std::string::npos);
}

TEST(StatisticalTests, GiveAReasonIfTheyAreUndefined) {
  for (const auto& [id, csv] : std::vector<std::pair<std::string, std::string>>{
           {"welch", "g,x\na,1\nb,1\n"},
           {"student", "g,x\na,1\nb,1\n"},
           {"paired_t", "x,y\n1,2\n"},
           {"sign_test", "x,y\n1,1\n"},
           {"friedman", "a,b\n1,1\n"},
           {"nemenyi", "a,b\n1,1\n"},
           {"icc_2_1", "a,b\n1,1\n"},
           {"fisher_exact", "a,b\nx,y\n"},
           {"mcnemar", "a,b\nx,x\ny,y\n"},
           {"cluster_robust", "who,g,x\nP1,a,1\nP1,b,2\n"},
           {"mixed_model", "who,g,x\nP1,a,1\nP1,b,2\n"},
           {"ordinal_model", "who,g,x\nP1,a,1\nP1,b,2\n"}}) {
    SCOPED_TRACE(id);
    const auto& test = analysis::statisticalTest(id);
    const auto rows = computeTest(test, dataFor(test, csv), {});
    ASSERT_EQ(rows.size(), 1U);
    EXPECT_EQ(rows[0].id, id);
    EXPECT_FALSE(rows[0].p);
    EXPECT_FALSE(rows[0].reason.empty());
  }
}

TEST(StatisticalTests, GiveAReasonForAMissingLocationBesideAnExactP) {
  std::string csv = "x,y\n1,2\n";
  for (int i = 0; i < 4000; ++i) csv += "1,1\n";
  const auto& test = analysis::statisticalTest("signed_rank");
  const auto rows = computeTest(test, dataFor(test, csv), {});
  ASSERT_EQ(rows.size(), 1U);
  EXPECT_TRUE(rows[0].p);
  EXPECT_FALSE(rows[0].estimate.value);
  EXPECT_EQ(rows[0].reason.key(), "too_many_averages");
}

TEST(StatisticalTests, AdjustClusterRobustDifferencesForRounds) {
  const auto& test = analysis::statisticalTest("cluster_robust");
  const auto data = dataFor(
      test,
      "who,g,x,round\nP1,a,3,1\nP1,b,4,2\nP1,a,5,2\nP2,a,1,1\nP2,b,2,1\nP2,b,6,2\nP3,a,4,2\n"
      "P3,b,3,1\nP4,b,7,2\nP4,a,2,1\nP5,a,3,2\nP5,b,4,1\n");
  const auto row = computeTest(test, data, {}).at(0);
  // R, from the formulas of Bell & McCaffrey: x ~ g + factor(round), clusters who; without the
  // round the standard error is 0.951769
  EXPECT_NEAR(row.estimate.value.value(), -1.333333333333, 1e-11);
  EXPECT_NEAR(row.standardError.value(), 0.858133396877, 1e-11);
  EXPECT_NEAR(row.df.value(), 3.584031017166, 1e-10);
}

TEST(StatisticalTests, RefuseDataOfAnotherKind) {
  const auto refused = [](const char* id, std::string_view csv) {
    const auto& test = analysis::statisticalTest(id);
    return tests::complaintOf([&] { computeTest(test, dataFor(test, csv), {}); });
  };
  EXPECT_EQ(refused("cochran_q", "a,b\n1,2\n"), "Cochran's Q needs 0 for no and 1 for yes");
  EXPECT_NE(refused("mcnemar", "a,b\nx,y\nz,x\n").find("there are 3"), std::string::npos);
  EXPECT_NE(refused("ordinal_model", "p,g,x\nP1,a,1.5\n").find("whole"), std::string::npos);
  EXPECT_NE(refused("friedman", "a\n1\n"), "");
}

}  // namespace registry_test
