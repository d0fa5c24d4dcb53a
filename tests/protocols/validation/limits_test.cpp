// Limits of force and of its change that a file may ask for.
#include <fstream>

#include <gtest/gtest.h>

#include "protocols/load_protocol.h"
#include "tests/protocols/small_protocol.h"
#include "tests/support/says.h"
#include "tests/support/scratch_folder.h"
#include "tests/support/test_data.h"

namespace protocols {
namespace limits_test {

using tests::says;

/// What is said of a protocol on a punch with these limits, in a file.
std::string verdict(const std::string& force, const std::string& rate) {
  auto text = tests::usualProtocol();
  text = tests::with(text, "\"max_force_n\": 8", "\"max_force_n\": " + force);
  text =
      tests::with(text, "\"max_force_rate_n_per_s\": 500", "\"max_force_rate_n_per_s\": " + rate);
  const tests::ScratchFolder folder;
  const std::string path = folder / "protocol.json";
  std::ofstream(path) << text;
  questionnaires::Problems problems;
  const bool isUsable = loadProtocolFile(path, problems).has_value();
  return (isUsable ? "usable " : "refused ") + questionnaires::describe(problems.all());
}

TEST(Limits, OfShippedProtocolsAreAllowed) {
  EXPECT_TRUE(says(verdict("8", "500"), "usable "));
  EXPECT_FALSE(says(verdict("8", "500"), "max_force"));
}

TEST(Limits, TooLargeForAHandAreErrorsWithTheSourceOfTheBound) {
  const auto said = verdict("1000", "500");
  EXPECT_TRUE(says(said, "refused "));
  EXPECT_TRUE(says(said, "ISO/TS 15066:2016, table A.2"));
  EXPECT_FALSE(says(verdict("140", "500"), "ISO/TS 15066"));
  EXPECT_TRUE(says(verdict("140.1", "500"), "ISO/TS 15066"));
}

TEST(Limits, OfAForceThatComesInOneTickAreErrors) {
  EXPECT_TRUE(says(verdict("8", "1000000"), "as a blow"));
  EXPECT_TRUE(says(verdict("8", "8000"), "usable "));
  EXPECT_TRUE(says(verdict("8", "8001"), "refused "));
}

TEST(Limits, BeyondTheKindOfDeviceAreErrorsWithTheSourceOfTheBound) {
  const auto said = verdict("8.1", "500");
  EXPECT_TRUE(says(said, "refused "));
  EXPECT_TRUE(says(said, "a punch gives 8 N (docs/devices.md, 'Saturation')"));
}

TEST(Limits, OfTheTorqueOfAReamerAreThoseOfTheDevice) {
  const auto verdictOf = [](const std::string& torque, const std::string& rate) {
    const auto text = tests::with(
        tests::contentOf(tests::repository() / "protocols/library/reaming-hardness.json"),
        "\"max_force_n\": ",
        "\"max_torque_nm\": " + torque + ", \"max_torque_rate_nm_per_s\": " + rate +
            ", \"max_force_n\": ");
    const tests::ScratchFolder folder;
    questionnaires::Problems problems;
    loadProtocolFile(folder.write("protocol.json", text), problems);
    return questionnaires::describe(problems.all());
  };
  EXPECT_FALSE(says(verdictOf("10", "10000"), "max_torque")) << verdictOf("10", "10000");
  EXPECT_TRUE(says(verdictOf("10.1", "50"), "a reamer gives 10 N·m"));
  EXPECT_TRUE(says(verdictOf("5", "5001"), "max_torque_rate_nm_per_s"));
  EXPECT_TRUE(says(verdictOf("5", "5001"), "as a blow"));
}

TEST(Limits, OfAStudyThatExistsStayAsTheyAre) {
  const auto text =
      tests::with(tests::usualProtocol(), "\"max_force_n\": 8", "\"max_force_n\": 1000");
  questionnaires::Problems problems;
  EXPECT_TRUE(loadProtocol(
      text, [](const auto&) { return std::nullopt; }, problems));
}

}  // namespace limits_test
}  // namespace protocols
