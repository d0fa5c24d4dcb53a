// The command 'palpate stats check-table'.
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/support/child_process.h"
#include "tests/support/programs.h"
#include "tests/support/scratch_folder.h"

namespace check_table_command_test {

using nlohmann::json;
using tests::Finished;

class CheckTableCommandTest : public testing::Test {
 protected:
  Finished check(std::vector<std::string> more = {}) const {
    std::vector<std::string> call{tests::program(), "stats", "check-table", groups_, comparisons_};
    call.insert(call.end(), more.begin(), more.end());
    return tests::run(call);
  }

  tests::ScratchFolder folder_;
  // Tables 2 and 3 of the punch paper, professionals.
  std::string groups_ = folder_.write(
      "groups.csv", "group,n,mean,variance\nI,36,4.1,1.3\nF,36,2.6,2.6\nK,36,3.2,2.4\n");
  std::string comparisons_ =
      folder_.write("comparisons.csv", "group1,group2,p\nI,F,< .017\nI,K,.021\nK,F,.115\n");
};

TEST_F(CheckTableCommandTest, ReportsImpossiblePValues) {
  const auto found = check();
  ASSERT_EQ(found.status, 0) << found.error;
  for (const char* phrase :
       {".0024 … .0165",
        "CANNOT BE: at most .0165",
        "Of 24 conventions none explains",
        "--scale"}) {
    EXPECT_NE(found.out.find(phrase), std::string::npos) << phrase << "\nin\n" << found.out;
  }
}

TEST_F(CheckTableCommandTest, FindsTheSizesThatFitWholeAnswers) {
  const auto found = check({"--sizes", "24", "36", "--scale", "1", "5"});
  ASSERT_EQ(found.status, 0) << found.error;
  for (const char* phrase :
       {"rounded              26–33",
        "62 of 2197 fit, none with equal sizes; fewest missing: I 36, F 36, K 28",
        "One data set that prints the row (Welch, two-sided, variances with n − 1, rounded)",
        "    I: "}) {
    EXPECT_NE(found.out.find(phrase), std::string::npos) << phrase << "\nin\n" << found.out;
  }
}

TEST_F(CheckTableCommandTest, SaysThatItIsProvedIfNoWholeAnswersFit) {
  const auto found = check({"--sizes", "36", "36", "--scale", "1", "5"});
  ASSERT_EQ(found.status, 0) << found.error;
  EXPECT_NE(
      found.out.find("PROVED: no answers on this scale print the row, at any of 1 combinations"),
      std::string::npos)
      << found.out;
}

TEST_F(CheckTableCommandTest, PrintsOneJsonDocumentWithTheOptionJson) {
  const auto found = check({"--sizes", "30", "30", "--scale", "1", "5", "--parts", "2", "--json"});
  ASSERT_EQ(found.status, 0) << found.error;
  const auto report = json::parse(found.out);
  ASSERT_EQ(report["at_stated_n"].size(), 24U);
  EXPECT_FALSE(report["at_stated_n"][0]["comparisons"][1]["follows"]);
  EXPECT_NEAR(report["at_stated_n"][0]["comparisons"][1]["p_high"], 0.0165, 5e-5);
  EXPECT_TRUE(report["at_equal_n"][0]["row"].is_array());
  EXPECT_EQ(report["whole_answers"][0]["equal_n"], json::array({30}));
  EXPECT_EQ(report["whole_answers"][0]["example"].size(), 3U);
}

TEST_F(CheckTableCommandTest, ReportsMissingAndInvalidInput) {
  const auto refused = [&](const std::vector<std::string>& more, const std::string& phrase) {
    const auto found = check(more);
    EXPECT_EQ(found.status, 1);
    EXPECT_EQ(found.out, "");
    EXPECT_NE(found.error.find(phrase), std::string::npos) << found.error;
  };
  refused({"--sizes", "36", "24"}, "from the fewest to the most");
  refused({"--sizes", "2", "999"}, "at most 100");
  refused({"--sizes", "950", "999", "--scale", "1", "5"}, "too many to count out");
  refused({"--scale", "5", "1"}, "from the lowest point to the highest");
  groups_ = folder_.write("no-n.csv", "group,mean,sd\nI,4.1,1.1\nF,2.6,1.6\nK,3.2,1.5\n");
  refused({}, "does not state the size of every group");
  groups_ = folder_.write("bad.csv", "group,mean,sd\nI,much,1.1\nF,2.6,1.6\n");
  refused({}, "groups, line 2: 'much' is no mean");
  refused({}, "there is no group 'K'");
}

}  // namespace check_table_command_test
