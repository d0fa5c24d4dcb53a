// Options that would do nothing, and values that cannot be meant, are refused.
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/support/child_process.h"
#include "tests/support/programs.h"

namespace refused_options_test {

using Words = std::vector<std::string>;

void expectRefused(Words arguments, const Words& phrases) {
  arguments.insert(arguments.begin(), tests::program());
  const auto finished = tests::run(arguments);
  EXPECT_EQ(finished.status, 2) << finished.error;
  for (const auto& phrase : phrases) {
    EXPECT_NE(finished.error.find(phrase), std::string::npos) << finished.error;
  }
}

TEST(RefusedOptions, AreThoseThatWouldDoNothing) {
  expectRefused({"study", "erase", "x", "--by", "c.txt", "--also", "backup"}, {"--by", "--also"});
  expectRefused(
      {"report", "x", "--out", "y.html", "--figure-width", "85"}, {"--figure-width", "--figures"});
  expectRefused(
      {"device", "emulate", "punch", "--firmware", "x.elf", "--clock-drift", "20"},
      {"--firmware", "--clock-drift"});
  expectRefused({"material", "compare", "--spline", "pchip"}, {"--spline"});
}

TEST(RefusedOptions, AreValuesThatCannotBeMeant) {
  expectRefused(
      {"stats", "test", "welch", "x.csv", "--group", "g", "--value", "x", "--level", "1"},
      {"1 lies outside 0.0001 to 0.9999"});
  expectRefused({"study", "create", "x", "--protocol", "y", "--seed", "-1"}, {"-1 is no seed"});
  expectRefused({"demo", "--seed", "-1"}, {"-1 is no seed"});
  expectRefused(
      {"study", "consent", "x", "--participant", "P001", "--out", "x.doc"},
      {"'x.doc' does not end in .html or .pdf"});
}

TEST(RefusedOptions, AreCallsWithoutACommandAndTheCommandsAreListed) {
  expectRefused({"study"}, {"There are: create, run, simulate"});
}

}  // namespace refused_options_test
