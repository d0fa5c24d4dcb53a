// `palpate stats`: the results of a study as JSON, and Welch's test of a table.
#include <map>
#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/study/app/palpate_command.h"

namespace stats_commands_test {

using nlohmann::json;
using tests::expectRefused;
using tests::kTheWorldSaidNo;
using tests::palpate;
using tests::Words;

class StatsCommands : public tests::StudyOfCommands {
 protected:
  Words welchOf(const std::string& table, bool isJson = true) {
    const auto file = folder_.write("table.csv", table);
    Words call{"stats", "test", "welch", file, "--group", "g", "--value", "x"};
    if (isJson) call.emplace_back("--json");
    return call;
  }
};

TEST_F(StatsCommands, PrintsEveryTestOfAStudyAsJson) {
  const auto study = made("punch-face-validity", 12);
  const auto finished = palpate({"stats", "run", study, "--run-mode", "simulated", "--json"});
  const auto results = json::parse(finished.out);
  const auto& family = results["families"].at(0);
  const auto& within = family["cohorts"].at(0)["within"];
  EXPECT_TRUE(within["anova"]["f"].is_number());
  EXPECT_TRUE(within["anova"]["p_greenhouse_geisser"].is_number());
  ASSERT_FALSE(family["between"].empty());
  for (const auto* test : {"mann_whitney", "brunner_munzel", "cliff_delta"}) {
    const auto& result = family["between"].at(0)[test];
    EXPECT_TRUE(result.contains("reason")) << test;
  }
  EXPECT_TRUE(family["between"].at(0)["mann_whitney"]["p"].is_number());
  EXPECT_TRUE(results["votes"].at(0)["p_exact"].is_number());
  std::map<std::string, std::map<std::string, int>> sums;
  for (const auto& vote : results["votes"]) {
    for (const auto& [condition, votes] : vote["votes"].items()) {
      sums[vote["cohort"]][condition] += votes.get<int>();
      sums["all"][condition] += votes.get<int>();
    }
  }
  ASSERT_EQ(results["vote_sums"].size(), sums.size());
  for (const auto& sum : results["vote_sums"]) {
    const auto cohort = sum["cohort"].is_null() ? "all" : sum["cohort"].get<std::string>();
    EXPECT_EQ(sum["votes"], json(sums.at(cohort)));
  }
}

TEST_F(StatsCommands, TestsAnyTableOfTwoGroups) {
  const auto finished = palpate(welchOf("g,x\na,1\na,2\nb,5\nb,3\n"));
  ASSERT_EQ(finished.status, 0) << finished.error;
  const auto result = json::parse(finished.out);
  // R: t.test(c(1, 2), c(5, 3))
  EXPECT_EQ(result["n1"], 2);
  EXPECT_EQ(result["n2"], 2);
  EXPECT_DOUBLE_EQ(result["mean1"], 1.5);
  EXPECT_DOUBLE_EQ(result["mean2"], 4.0);
  EXPECT_DOUBLE_EQ(result["variance1"], 0.5);
  EXPECT_DOUBLE_EQ(result["variance2"], 2.0);
  EXPECT_DOUBLE_EQ(result["difference"], -2.5);
  EXPECT_NEAR(result["t"], -2.23606797749979, 1e-14);
  EXPECT_NEAR(result["df"], 1.470588235294118, 1e-14);
  EXPECT_NEAR(result["p"], 0.1987273889345261, 1e-14);
  EXPECT_NEAR(result["log10_p"], -0.7017422735876812, 1e-13);
  EXPECT_NEAR(result["conf_low"], -9.418522830071065, 1e-11);
  EXPECT_NEAR(result["conf_high"], 4.418522830071065, 1e-11);
  EXPECT_TRUE(result["reason"].is_null());
}

TEST_F(StatsCommands, ReportsWhyATestIsUndefined) {
  const auto finished = palpate(welchOf("g,x\na,1\na,2\nb,5\n"));
  ASSERT_EQ(finished.status, 0) << finished.error;
  const auto result = json::parse(finished.out);
  for (const auto* key : {"variance2", "t", "df", "p", "log10_p", "conf_low", "conf_high"}) {
    ASSERT_TRUE(result.contains(key)) << key;
    EXPECT_TRUE(result[key].is_null()) << key;
  }
  EXPECT_NE(result["reason"].get<std::string>().find("one value only"), std::string::npos);
}

TEST_F(StatsCommands, ReadsTablesAsSpreadsheetsWriteThem) {
  const auto plain = palpate(welchOf("g,x\na,1.5\na,2\nb,5\nb,3\n")).out;
  EXPECT_EQ(
      palpate(welchOf("\xEF\xBB\xBF\"g\",\"x\"\r\na,1.5\r\na,2\r\nb,5\r\nb,3\r\n")).out, plain);
  EXPECT_EQ(palpate(welchOf("g;x\na;1,5\na;2\nb;5\nb;3\n")).out, plain);
}

TEST_F(StatsCommands, ReportsMistakesInATable) {
  expectRefused(
      welchOf("g,x\na,1\na,2\nb,zwei\nb,3\n"), kTheWorldSaidNo, {"table.csv", "line 4", "'zwei'"});
  expectRefused(welchOf("g,x\na,1\nb,2\nc,3\n"), kTheWorldSaidNo, {"3 groups", "two are compared"});
  expectRefused(welchOf("g,y\na,1\nb,2\n"), kTheWorldSaidNo, {"'x'", "'y'"});
  expectRefused(welchOf(""), kTheWorldSaidNo, {"table.csv"});
}

}  // namespace stats_commands_test
