// What is deterministic about the benchmarks: errors, lines, medians over processes.
#include "haptics/bench/measurement.h"

#include <cmath>
#include <map>

#include <gtest/gtest.h>

#include "haptics/bench/string_reference.h"

namespace haptics::bench {
namespace measurement_test {

TEST(MeasurementText, IsReadBackUnchanged) {
  const Measurement m{
      .family = "splines",
      .setting = "random",
      .method = "palpate Hermite",
      .parameter = 10'000,
      .error = 1.0 / 3.0,
      .bound = 0.5,
      .time = Timing{7.25, 9.5}};
  const auto back = fromLine(asLine(m));
  ASSERT_TRUE(back);
  EXPECT_EQ(back->family, m.family);
  EXPECT_EQ(back->setting, m.setting);
  EXPECT_EQ(back->method, m.method);
  EXPECT_EQ(back->parameter, m.parameter);
  EXPECT_EQ(back->error, m.error);
  EXPECT_EQ(back->bound, m.bound);
  EXPECT_EQ(back->time->median, 7.25);
  EXPECT_EQ(back->time->p99, 9.5);
  const auto bare = fromLine(asLine({.family = "a", .setting = "b", .method = "c"}));
  ASSERT_TRUE(bare);
  EXPECT_FALSE(bare->error);
  EXPECT_FALSE(bare->bound);
  EXPECT_FALSE(bare->time);
  const auto endless = fromLine(asLine({.family = "a", .error = INFINITY}));
  EXPECT_EQ(endless->error, INFINITY);
}

TEST(MeasurementText, RefusesOtherText) {
  for (const char* line : {"", "splines", "a\tb\tc\td\t-\t-\t-\t-", "a\tb\tc\t1\t-\t-\t-"}) {
    EXPECT_FALSE(fromLine(line)) << line;
  }
}

TEST(Gathered, TakesMediansOverProcesses) {
  std::vector<Measurement> all;
  for (const double median : {5.0, 9.0, 6.0}) {
    all.push_back({.family = "f", .setting = "s", .method = "a", .time = Timing{median, 20.0}});
    all.push_back({.family = "f", .setting = "s", .method = "b", .error = 0.5});
  }
  const auto gathered = bench::mergedOverProcesses(all);
  ASSERT_EQ(gathered.size(), 2U);
  EXPECT_EQ(gathered[0].measurement.time->median, 6.0);
  EXPECT_EQ(gathered[0].fastest, 5.0);
  EXPECT_EQ(gathered[0].slowest, 9.0);
  EXPECT_EQ(gathered[0].processes, 3);
  EXPECT_EQ(gathered[1].measurement.error, 0.5);
}

TEST(StringReference, IsThePublishedStiffness) {
  // Five elements over 1.5, tool at two thirds: 1.714 N per unit; ours are of length 1, hence 0.3
  // times as stiff.
  const StringReference reference(std::vector<double>(5, 1.0), 5.0 * (1.5 - 0.5) / 1.5);
  EXPECT_NEAR(static_cast<double>(reference.stiffness) / 0.3, 1.714, 5e-4);
}

TEST(Measurement, IsWithinItsBoundOnlyWithAnErrorThatIsANumber) {
  const auto isWithin = [](std::optional<double> error, std::optional<double> bound) {
    return Measurement{.error = error, .bound = bound}.isWithinBound();
  };
  EXPECT_TRUE(isWithin(1.0, 1.0));
  EXPECT_TRUE(isWithin(1.0, std::nullopt));
  EXPECT_FALSE(isWithin(1.1, 1.0));
  EXPECT_FALSE(isWithin(NAN, 1.0));
  EXPECT_FALSE(isWithin(std::nullopt, 1.0));
}

TEST(Encoders, ChangeTheForcesByTheExpectedAmount) {
  std::map<std::string, double> found;
  measureEncoders({.report = [&](const Measurement& m) {
    found[m.setting + "/" + m.method + "/" + std::to_string(m.parameter)] = *m.error;
  }});
  const auto at = [&](const std::string& what, const std::string& method, double resolution) {
    return found.at(what + " [N], 10 travel units/s/" + method + "/" + std::to_string(resolution));
  };
  const std::string difference = "RMS difference from an ideal encoder";
  EXPECT_EQ(at(difference, "interpolation", 0.0), 0.0);
  // A resolution of q is off by q / √12; the finite elements make K of it where they are elastic.
  EXPECT_NEAR(
      at(difference, "finite elements", 0.176) / at(difference, "finite elements", 0.0439),
      4.0,
      0.2);
  // Only paper-text chatters by itself: a square wave between its two forces.
  EXPECT_GT(at("RMS chatter", "filter, paper-text", 0.0), 0.2);
  EXPECT_LT(at("RMS chatter", "filter, space-domain", 0.0), 0.01);
}

}  // namespace measurement_test
}  // namespace haptics::bench
