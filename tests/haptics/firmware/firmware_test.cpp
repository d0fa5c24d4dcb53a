// The punch's own program under an emulator: the same forces as here, and what they cost.
//
// QEMU counts instructions exactly; it models neither the processor's pipeline nor its flash, so
// microseconds are no business of these tests.
#include <cmath>
#include <cstdint>
#include <cstring>
#include <iostream>
#include <map>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

#include "haptics/bench/refresh_rate.h"
#include "haptics/firmware/report.h"
#include "haptics/models/interpolation.h"
#include "haptics/recordings/cut.h"
#include "tests/support/child_process.h"

namespace haptics::firmware {
namespace firmware_test {

constexpr const char* kProgram = PALPATE_FIRMWARE;
constexpr const char* kEmulator = PALPATE_ARM_EMULATOR;

/// What was said, by name, in order.
using Said = std::map<std::string, std::vector<std::uint32_t>>;

Said saidHere() {
  Said said;
  Report report(
      [&](const char* name, int, std::uint32_t bits) { said[name].push_back(bits); },
      [] {},
      [] { return 0U; });
  report.run();
  return said;
}

/// What the board says; it is run once.
const Said& saidByTheBoard() {
  static const Said said = [] {
    const auto finished = tests::run(
        {kEmulator,
         "-M",
         "mps2-an385",
         "-nographic",
         "-monitor",
         "none",
         "-serial",
         "none",
         "-semihosting-config",
         "enable=on,target=native",
         "-icount",
         "shift=6",
         "-kernel",
         kProgram});
    EXPECT_EQ(finished.status, 0) << finished.error.substr(0, 500);
    Said result;
    std::istringstream lines(finished.out + finished.error);
    std::string name;
    std::string bits;
    for (int step = 0; lines >> name >> step >> bits;) {
      result[name].push_back(static_cast<std::uint32_t>(std::stoul(bits, nullptr, 16)));
    }
    return result;
  }();
  return said;
}

float floatOf(std::uint32_t bits) {
  float value = 0.0F;
  std::memcpy(&value, &bits, sizeof value);
  return value;
}

class FirmwareTest : public testing::Test {
 protected:
  void SetUp() override {
    const bool isThere = std::strlen(kProgram) > 0 && std::strlen(kEmulator) > 0;
    if (!isThere) {
      GTEST_SKIP()
          << "needs a compiler and an emulator for ARM: ./setup --firmware, then configure "
             "again";
    }
  }
};

TEST_F(FirmwareTest, GivesTheSameForcesInSinglePrecision) {
  for (const std::string name : {"float-5", "float-15"}) {
    const auto here = saidHere().at(name);
    const auto there = saidByTheBoard().at(name);
    ASSERT_EQ(there.size(), here.size());
    double largest = 0.0;
    for (std::size_t i = 0; i < here.size(); ++i) {
      const double expected = floatOf(here[i]);
      const double scale = std::max(std::abs(expected), 0.1);  // [N]
      largest = std::max(largest, std::abs(floatOf(there[i]) - expected) / scale);
    }
    EXPECT_LE(largest, 1e-5) << name;
  }
}

TEST_F(FirmwareTest, StaysWithinItsInstructions) {
  // Our bounds. The published code takes 28,400 and 143,900 in single precision.
  const auto& said = saidByTheBoard();
  EXPECT_LE(said.at("instructions-float-5").at(0), 6000U);
  EXPECT_LE(said.at("instructions-float-15").at(0), 7000U);
  for (const auto* name : {"instructions-float-5", "instructions-float-15", "stack"}) {
    std::cout << name << ": " << said.at(name).at(0) << "\n";
  }
}

TEST_F(FirmwareTest, TakesTheInstructionsThatTheTableOfFig12Has) {
  const auto& said = saidByTheBoard();
  const std::map<std::string_view, std::string> names{
      {"interpolation, with mesh", "instructions-interpolation-"},
      {"finite elements, with mesh", "instructions-elements-"},
      {"Kalman filter, with mesh", "instructions-float-"}};
  for (const auto& rate : bench::kRefreshRates) {
    const auto name = names.at(rate.method) + std::to_string(rate.elements);
    const double counted = said.at(name).at(0);
    std::cout << name << ": " << counted << "\n";
    // Another release of the compiler may take some more or fewer.
    EXPECT_NEAR(counted, rate.instructions, 0.05 * rate.instructions) << name;
  }
}

TEST_F(FirmwareTest, NeedsLittleStack) {
  EXPECT_LE(saidByTheBoard().at("stack").at(0), 2048U);
}

TEST(FirmwareModels, HaveTheParametricCut) {
  const auto cut = recordings::parametricCut();
  std::vector<models::CurveNode<double>> nodes;
  for (const auto& point : cut.curve.nodes()) nodes.push_back({point.travel, point.force});
  const models::Interpolation<double> curve(nodes.data(), nodes.size(), {});
  std::size_t hint = 0;
  for (const auto& point : kCut) {
    const auto travel = static_cast<double>(point.travel);
    EXPECT_NEAR(static_cast<double>(point.force), curve.at(travel, hint).force, 1e-5);
  }
}

}  // namespace firmware_test
}  // namespace haptics::firmware
