// The commands for scenes: what they write and print.
#include <sstream>
#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/study/app/palpate_command.h"
#include "tests/support/test_data.h"

namespace scene_commands_test {

using nlohmann::json;
using tests::kTheWorldSaidNo;
using tests::linesOf;
using tests::palpate;
using tests::Words;

class SceneCommands : public tests::StudyOfCommands {};

TEST_F(SceneCommands, PlaysASceneToTheEndOfItsData) {
  // The parametric cut ends at 11 travel units; its force fades over another 1.5.
  const std::string cut = folder_ / "cut";
  palpate({"scene", "play", "punch-counterbalanced", "--condition", "interpolation", "--out", cut});
  // Finite elements have no end of their own: the device's stop is at 11.
  const std::string elements = folder_ / "elements";
  palpate(
      {"scene",
       "play",
       "punch-counterbalanced",
       "--condition",
       "finite-elements",
       "--out",
       elements});
  const auto lastTravelOf = [](const std::string& out) {
    std::istringstream cells(linesOf(tests::contentOf(out + ".csv")).back());
    std::string cell;
    for (int i = 0; i < 4; ++i) std::getline(cells, cell, ',');
    return std::stod(cell);
  };
  EXPECT_DOUBLE_EQ(lastTravelOf(cut), 12.5);
  EXPECT_DOUBLE_EQ(lastTravelOf(elements), 11.0);
  const auto backwards = palpate(
      {"scene",
       "play",
       "punch-counterbalanced",
       "--condition",
       "kalman",
       "--from",
       "5",
       "--to",
       "4",
       "--out",
       folder_ / "backwards"});
  EXPECT_EQ(backwards.status, kTheWorldSaidNo);
  EXPECT_NE(backwards.error.find("from 5 to 4"), std::string::npos) << backwards.error;
}

TEST_F(SceneCommands, DrawsForceCurvesOfConditions) {
  const std::string out = folder_ / "fused";
  const Words call{
      "scene",
      "play",
      "punch-face-validity",
      "--condition",
      "kalman",
      "--interpolation-noise",
      "0.1",
      "50",
      "--to",
      "11",
      "--out",
      out};
  const auto played = palpate(call);
  ASSERT_EQ(played.status, 0) << played.error;
  const auto lines = linesOf(tests::contentOf(out + ".csv"));
  EXPECT_EQ(lines.front(), "condition,curve,time_s,travel,force_n,stiffness");
  // The two forces that are combined, and two filters; 11 travel units at 57 units/s and 1 kHz.
  constexpr std::size_t kSteps = 194;
  ASSERT_EQ(lines.size(), 1 + 4 * kSteps);
  const auto lastForceOf = [&](std::size_t curve) {
    std::istringstream cells(lines[(curve + 1) * kSteps]);
    std::string cell;
    for (int i = 0; i < 5; ++i) std::getline(cells, cell, ',');
    return std::stod(cell);
  };
  EXPECT_NEAR(lastForceOf(0), 4.29, 1e-9);           // the recording, after the authors' filter
  EXPECT_NEAR(lastForceOf(1), 7.0, 1e-9);            // the finite elements, yielding
  EXPECT_NEAR(lastForceOf(2), 4.29, 0.1);            // the filter that trusts the recording
  EXPECT_NEAR(lastForceOf(3), 7.0, 0.4);             // the filter that does not
  EXPECT_EQ(palpate(call).status, kTheWorldSaidNo);  // nothing is overwritten
}

TEST_F(SceneCommands, TimesAConditionWithAdditionalParts) {
  const auto explained = palpate(
      {"scene",
       "explain",
       "punch-face-validity",
       "--condition",
       "interpolation",
       "--cost",
       "--json"});
  const auto costs = json::parse(explained.out)["costs"];
  ASSERT_GE(costs.size(), 4U);
  EXPECT_EQ(costs[0]["what"], "as it is");
  for (const auto& cost : costs) EXPECT_GT(cost["median_ns"].get<double>(), 0.0);
}

}  // namespace scene_commands_test
