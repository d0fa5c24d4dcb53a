// `palpate stats test` against the reference values of tests/data/stats/by_name.
#include <cmath>
#include <set>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "analysis/registry/registry.h"
#include "tests/support/child_process.h"
#include "tests/support/programs.h"
#include "tests/support/scratch_folder.h"
#include "tests/support/test_data.h"

namespace test_command_test {

using nlohmann::json;

constexpr const char* kCases = "stats/by_name/";

tests::Finished statsTest(std::vector<std::string> arguments) {
  std::vector<std::string> call{tests::program(), "stats", "test"};
  call.insert(call.end(), arguments.begin(), arguments.end());
  return tests::run(call);
}

tests::Finished runCase(const json& one, bool isJson) {
  std::vector<std::string> call{
      one["test"],
      tests::testData(kCases + one["file"].get<std::string>()).lexically_normal().string()};
  for (const auto& option : one["options"]) call.push_back(option);
  if (isJson) call.emplace_back("--json");
  return statsTest(call);
}

void expectNumbers(const json& ours, const json& expected, double tolerance) {
  for (const auto& [key, value] : expected.items()) {
    ASSERT_TRUE(ours.contains(key)) << key;
    if (!value.is_number()) continue;
    ASSERT_TRUE(ours[key].is_number()) << key << ": " << ours[key];
    const double truth = value;
    EXPECT_NEAR(ours[key].get<double>(), truth, tolerance * std::max(std::abs(truth), 1e-3)) << key;
  }
}

json comparisonOf(const json& ours, const json& expected) {
  for (const auto& row : ours["comparisons"]) {
    const bool isSame = row["group1"] == expected["group1"] &&
                        row.value("group2", "") == expected.value("group2", "");
    if (isSame) return row;
  }
  return {};
}

TEST(StatsTest, GivesTheNumbersOfR) {
  const auto cases =
      json::parse(tests::contentOf(tests::testData(kCases + std::string("cases.json"))));
  std::set<std::string> checked;
  for (const auto& one : cases) {
    SCOPED_TRACE(one["test"].get<std::string>());
    const auto finished = runCase(one, true);
    ASSERT_EQ(finished.status, 0) << finished.error;
    const auto ours = json::parse(finished.out);
    EXPECT_EQ(ours["test"], one["test"]);
    if (one.contains("expected")) expectNumbers(ours, one["expected"], one["tolerance"]);
    if (one.contains("comparisons")) {
      for (const auto& row : one["comparisons"]) {
        expectNumbers(comparisonOf(ours, row), row, one["tolerance"]);
      }
    }
    checked.insert(one["test"]);
  }
  for (const auto& test : analysis::statisticalTests()) {
    EXPECT_TRUE(checked.contains(std::string(test.id))) << test.id << " has no reference values";
  }
}

TEST(StatsTest, ListsEveryTest) {
  const auto finished = statsTest({"--list"});
  EXPECT_EQ(finished.status, 0) << finished.error;
  const auto lines = "\n" + finished.out;
  for (const auto& test : analysis::statisticalTests()) {
    EXPECT_NE(lines.find("\n" + std::string(test.id) + " "), std::string::npos) << test.id;
    EXPECT_NE(lines.find(std::string(test.question) + "\n"), std::string::npos) << test.id;
  }
}

TEST(StatsTest, PrintsTheResultOfATest) {
  const tests::ScratchFolder folder;
  const auto pairs = folder.write("pairs.csv", "before,after\n4,4\n5,3\n4,2\n4,5\n5,NA\n");
  // R: binom.test(2, 3)
  const auto sign = statsTest({"sign_test", pairs});
  EXPECT_EQ(sign.status, 0) << sign.error;
  EXPECT_EQ(
      sign.out,
      "Sign test, before − after\n\n"
      "group               n             mean         variance\n"
      "before              4             4.25             0.25\n"
      "after               4              3.5      1.666666667\n\n"
      "1 row was left out, because a cell is empty or NA.\n"
      "p = 1\npositive = 2\nnegative = 1\nzeros = 1\n");
}

TEST(StatsTest, ReportsMistakesInACall) {
  const tests::ScratchFolder folder;
  const auto file = folder.write("table.csv", "g,x\na,1\nb,2\n");
  const auto unknown = statsTest({"welsh", file});
  EXPECT_EQ(unknown.status, 1);
  EXPECT_NE(unknown.error.find("did you mean 'welch'?"), std::string::npos) << unknown.error;
  const auto column = statsTest({"welch", file, "--cluster", "g"});
  EXPECT_EQ(column.status, 1);
  EXPECT_NE(column.error.find("it uses --group, --value"), std::string::npos) << column.error;
  const auto clusters = folder.write("clusters.csv", "p,g,x\n1,a,1\n2,b,2\n");
  const auto from = statsTest({"answer_probability", clusters});
  EXPECT_EQ(from.status, 1);
  EXPECT_NE(from.error.find("the test needs --from"), std::string::npos) << from.error;
  const auto useless = statsTest({"welch", file, "--from", "4"});
  EXPECT_EQ(useless.status, 1);
  EXPECT_NE(useless.error.find("does not use --from"), std::string::npos) << useless.error;
  const auto nothing = statsTest({});
  EXPECT_EQ(nothing.status, 2);
  EXPECT_NE(nothing.error.find("TEST is required"), std::string::npos) << nothing.error;
}

}  // namespace test_command_test
