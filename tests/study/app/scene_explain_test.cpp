// 'palpate scene explain' from outside: a recorded cut that ends at once is warned of.
#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "haptics/recordings/cut.h"
#include "protocols/reading/cut_file.h"
#include "tests/support/child_process.h"
#include "tests/support/programs.h"
#include "tests/support/scratch_folder.h"
#include "tests/support/test_data.h"

namespace scene_explain_test {

/// The shipped protocol with a cut beside it that ends with 5 N, and a policy for what is beyond.
std::string protocolWith(tests::ScratchFolder& folder, const std::string& beyond) {
  folder.write(
      "mine.json",
      protocols::cutAsJson(haptics::recordings::parametricCut(), std::string(64, '0')));
  auto json = nlohmann::ordered_json::parse(tests::contentOf(
      (tests::repository() / "protocols/library/punch-counterbalanced.json").string()));
  json["conditions"][0]["scene"]["parameters"] = {{"cut", "mine.json"}, {"beyond", beyond}};
  return folder.write("protocol-" + beyond + ".json", json.dump());
}

tests::Finished explain(const std::string& protocol, const std::string& more = {}) {
  std::vector<std::string> call{
      tests::program(), "scene", "explain", protocol, "--condition", "interpolation"};
  if (!more.empty()) call.push_back(more);
  return tests::run(call);
}

TEST(SceneExplain, WarnsOfACutThatDropsAtItsEnd) {
  tests::ScratchFolder folder;
  const auto clamped = explain(protocolWith(folder, "authors-clamp"));
  EXPECT_EQ(clamped.status, 0) << clamped.error;
  EXPECT_NE(
      clamped.out.find("WARN, the recorded force drops from 4.29 to 0.01 N at once, at a travel of "
                       "11 travel_unit"),
      std::string::npos)
      << clamped.out;
  const auto faded = explain(protocolWith(folder, "ramp-out"));
  EXPECT_EQ(faded.out.find("at once"), std::string::npos) << faded.out;
}

TEST(SceneExplain, ListsTheDropsForPrograms) {
  tests::ScratchFolder folder;
  const auto found = nlohmann::json::parse(explain(protocolWith(folder, "zero"), "--json").out);
  ASSERT_EQ(found["jumps"].size(), 1U);
  EXPECT_EQ(found["jumps"][0]["travel"], 11.0);
  EXPECT_EQ(found["jumps"][0]["from_n"], 5.0);
  EXPECT_EQ(found["jumps"][0]["to_n"], 0.0);
}

/// The shipped protocol of reaming, whose first condition is a material of these @p parameters.
std::string reamingWith(tests::ScratchFolder& folder, const nlohmann::json& parameters) {
  auto json = nlohmann::ordered_json::parse(
      tests::contentOf((tests::repository() / "protocols/library/reaming-hardness.json").string()));
  json["conditions"][0]["scene"]["parameters"] = parameters;
  return folder.write("reaming.json", json.dump());
}

TEST(SceneExplain, ReportsAMaterialThatBeginsWithAJump) {
  tests::ScratchFolder folder;
  const auto node = [](double depth, double force) {
    return nlohmann::json{{"depth_m", depth}, {"lower_n", force}, {"upper_n", force}};
  };
  const auto protocol = reamingWith(
      folder,
      {{"hardness", 0.5},
       {"removal", false},
       {"nodes", {node(0.001, 50.0), node(0.01, 60.0), node(0.02, 70.0)}}});
  const auto said =
      tests::run({tests::program(), "scene", "explain", protocol, "--condition", "hardness-0"});
  EXPECT_EQ(said.status, 0) << said.error;
  EXPECT_EQ(said.out.find("PASS"), std::string::npos) << said.out;
  EXPECT_NE(said.out.find("rises from 0.00 to 50.00 N at once"), std::string::npos) << said.out;
}

/// What `--json` says of the torque on an arm that gives @p most N·m.
nlohmann::json torqueOn(tests::ScratchFolder& folder, double most) {
  const nlohmann::json arm{
      {"id", "reamer"},
      {"type", "iiwa-fri"},
      {"robot_address", "127.0.0.1"},
      {"max_torque_nm", most}};
  const auto devices = folder.write(
      "devices.json", nlohmann::json{{"format", "palpate-devices-1"}, {"devices", {arm}}}.dump());
  const auto said = tests::run(
      {tests::program(),
       "scene",
       "explain",
       "reaming-hardness",
       "--condition",
       "hardness-33",
       "--devices",
       devices,
       "--json"});
  EXPECT_EQ(said.status, 0) << said.error;
  return nlohmann::json::parse(said.out)["torque"];
}

TEST(SceneExplain, SaysAsAValueWhetherTheDeviceRendersTheTorque) {
  tests::ScratchFolder folder;
  const auto given = torqueOn(folder, 2.0);
  EXPECT_EQ(given["rendered"], true);
  EXPECT_EQ(given["device_max_nm"], 2.0);
  EXPECT_EQ(torqueOn(folder, 0.0)["rendered"], false);
  const auto punch = nlohmann::json::parse(explain("punch-counterbalanced", "--json").out);
  EXPECT_FALSE(punch.contains("torque")) << "the scene has none";
}

}  // namespace scene_explain_test
