// What a scene gives over the whole travel of its device: nothing, a pull, too much.
#include <algorithm>
#include <string>

#include <gtest/gtest.h>

#include "tests/protocols/small_protocol.h"

namespace protocols {
namespace force_warnings_test {

/// The warnings on usualProtocol() with other parameters of "soft", by key; of its device first.
std::string keysFor(const std::string& parameters, const FileFinder& find = {}) {
  const auto text = tests::with(tests::usualProtocol(), R"({ "yield_force_n": 3 })", parameters);
  const auto loading = tests::load(text, find);
  EXPECT_TRUE(loading.loaded.has_value()) << loading.describe();
  std::string keys;
  for (const auto& problem : loading.problems) {
    if (problem.path == "$.conditions[0].scene.parameters" ||
        problem.path == "$.conditions[0].scene.parameters.slope_limit") {
      keys.append(keys.empty() ? "" : " ").append(problem.what.key());
    }
  }
  return keys;
}

/// The warnings if "soft" is a cut through (4, 0), (7, @p yield) and (10, @p end).
std::string keysForCut(double yield, double end, const std::string& more = "") {
  const auto json = std::string(R"({"format": "palpate-cut-1", "name": "c", "title": "C",
      "unit": "travel_unit", "curve": [{"travel": 4, "force_n": 0}, {"travel": 7, "force_n": )") +
                    std::to_string(yield) + R"(}, {"travel": 10, "force_n": )" +
                    std::to_string(end) + "}]}";
  const auto text = tests::with(
      tests::usualProtocol(),
      R"("model": "finite-elements",
        "parameters": { "yield_force_n": 3 })",
      R"("model": "interpolation", "parameters": { "cut": "c.json")" + more + " }");
  const auto loading = tests::load(text, [&](const std::string&) { return json; });
  EXPECT_TRUE(loading.loaded.has_value()) << loading.describe();
  std::string keys;
  for (const auto& problem : loading.problems) {
    if (problem.path.starts_with("$.conditions[0].scene.parameters")) {
      keys.append(keys.empty() ? "" : " ").append(problem.what.key());
    }
  }
  return keys;
}

TEST(ForceWarnings, LeaveUsualScenesAlone) {
  EXPECT_EQ(keysFor("{}"), "");
  EXPECT_EQ(keysFor(R"({ "yield_force_n": 0.5 })"), "");
  EXPECT_EQ(keysForCut(4.2, 3.0), "");
  EXPECT_EQ(keysForCut(0.5, 0.0), "");
}

TEST(ForceWarnings, WarnOfElementsThatAreHardlyFelt) {
  EXPECT_EQ(keysFor(R"({ "yield_force_n": 0.005 })"), "hardly_felt");
  EXPECT_EQ(keysFor(R"({ "contact_travel": 40 })"), "hardly_felt");
  EXPECT_EQ(keysFor(R"({ "element_stiffness": 0.001 })"), "hardly_felt");
}

TEST(ForceWarnings, WarnOfACutThatIsHardlyFelt) {
  EXPECT_EQ(keysForCut(0.0042, 0.003), "hardly_felt");
  EXPECT_EQ(keysForCut(0.0, 0.0), "hardly_felt");
}

TEST(ForceWarnings, NameTheLargestForceAndTheTravel) {
  const auto loading = tests::load(tests::with(
      tests::usualProtocol(), R"({ "yield_force_n": 3 })", R"({ "yield_force_n": 0.004 })"));
  EXPECT_NE(
      loading.describe().find("at most 0.004 N are felt over the travel from 0 to 11"),
      std::string::npos)
      << loading.describe();
}

TEST(ForceWarnings, WarnOfACutThatPulls) {
  EXPECT_EQ(keysForCut(-4.2, -3.0), "force_pulls");
}

TEST(ForceWarnings, WarnOfElementsBeyondTheDevicesLimit) {
  const auto parameters = R"({ "yield_force_n": 100, "element_stiffness": 10 })";
  EXPECT_EQ(keysFor(parameters), "elements_beyond_limit");
}

TEST(ForceWarnings, WarnOfTwoConditionsOfABlockWithTheSameForces) {
  const auto text = tests::usualProtocol();
  const auto isWarned = [](const std::string& json) {
    const auto said = tests::load(json).problems;
    return std::ranges::any_of(said, [](const auto& problem) {
      return problem.path == "$.conditions[1].scene" && problem.what.key() == "same_force";
    });
  };
  EXPECT_FALSE(isWarned(text));
  const auto firm = "\"yield_force_n\": 6";
  EXPECT_TRUE(isWarned(tests::with(text, firm, "\"contact_travel\": 4, \"yield_force_n\": 3")));
  EXPECT_FALSE(
      isWarned(tests::with(text, firm, "\"yielding\": \"return-map\", \"yield_force_n\": 3")));
}

TEST(ForceWarnings, WarnOfASlopeLimitThatFlattensACut) {
  EXPECT_EQ(keysForCut(4.2, 3.0, R"(, "slope_limit": 1.3)"), "");
  const auto keys = keysForCut(4.2, 3.0, R"(, "slope_limit": 0.1)");
  EXPECT_TRUE(keys.starts_with("slope_limit_flattens")) << keys;
}

}  // namespace force_warnings_test
}  // namespace protocols
