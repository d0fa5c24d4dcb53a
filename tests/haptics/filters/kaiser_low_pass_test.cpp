#include <cmath>
#include <fstream>
#include <numbers>
#include <numeric>
#include <stdexcept>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "haptics/filters/low_pass.h"
#include "tests/support/test_data.h"

namespace haptics::filters {
namespace kaiser_low_pass_test {

TEST(KaiserLowPass, HasTheTapsOfSciPy) {
  std::ifstream file(tests::testData("recordings/golden.json"));
  const auto golden = nlohmann::json::parse(file)["taps"];
  ASSERT_EQ(golden.size(), 3U);
  for (const auto& row : golden) {
    const int count = row["taps"].get<int>();
    const KaiserLowPass filter({.taps = count, .sampleRate = row["rate_hz"].get<double>()});
    const auto& half = row["from_the_middle"];
    ASSERT_EQ(half.size(), static_cast<std::size_t>(count / 2 + 1));
    for (std::size_t i = 0; i < half.size(); ++i) {
      EXPECT_NEAR(
          filter.taps()[static_cast<std::size_t>(count / 2) + i], half[i].get<double>(), 1e-15);
    }
  }
}

/// The gain of a symmetric filter at a frequency [Hz].
double gainAt(const KaiserLowPass& filter, double frequency, double sampleRate) {
  double gain = 0.0;
  const double reach = (static_cast<double>(filter.taps().size()) - 1.0) / 2.0;
  for (std::size_t i = 0; i < filter.taps().size(); ++i) {
    const double j = static_cast<double>(i) - reach;
    gain += filter.taps()[i] * std::cos(2.0 * std::numbers::pi * frequency * j / sampleRate);
  }
  return gain;
}

TEST(KaiserLowPass, IsSymmetricAndLeavesAConstantAlone) {
  const KaiserLowPass filter(KaiserLowPass::Design{});
  const auto taps = filter.taps();
  ASSERT_EQ(taps.size(), 49U);
  EXPECT_NEAR(std::accumulate(taps.begin(), taps.end(), 0.0), 1.0, 1e-15);
  for (std::size_t i = 0; i < 24; ++i) EXPECT_DOUBLE_EQ(taps[i], taps[48 - i]);
}

TEST(KaiserLowPass, HalvesAtItsCutOffAndStopsBeyond) {
  const KaiserLowPass filter(KaiserLowPass::Design{});
  const double rate = 1000.0 / 3.0;
  EXPECT_NEAR(gainAt(filter, 17.69, rate), 0.5, 2e-3);
  EXPECT_NEAR(gainAt(filter, 5.0, rate), 1.0, 1.2e-3);  // MATLAB's pass-band edge
  for (int f = 31; f < 166; ++f) EXPECT_LT(std::abs(gainAt(filter, f, rate)), 1e-3) << f;
}

TEST(KaiserLowPass, GoesOnWithTheFirstAndTheLastValueBeyondTheEnds) {
  std::vector<double> ramp(200);
  std::iota(ramp.begin(), ramp.end(), 100.0);
  const auto filtered = KaiserLowPass(KaiserLowPass::Design{}).filtered(ramp);
  EXPECT_NEAR(filtered.front(), 100.0, 5.0);
  EXPECT_NEAR(filtered.back(), 299.0, 5.0);
}

TEST(KaiserLowPass, DelaysNothing) {
  std::vector<double> ramp(200);
  for (std::size_t i = 0; i < ramp.size(); ++i) ramp[i] = 0.1 * static_cast<double>(i);
  const std::vector<double> smooth = KaiserLowPass(KaiserLowPass::Design{}).filtered(ramp);
  ASSERT_EQ(smooth.size(), ramp.size());
  for (std::size_t i = 24; i < 176; ++i) EXPECT_NEAR(smooth[i], ramp[i], 1e-12);
}

TEST(KaiserLowPass, HoldsTheEndsOfASignal) {
  const std::vector<double> constant(30, 9.23);  // shorter than the filter
  for (const double y : KaiserLowPass(KaiserLowPass::Design{}).filtered(constant)) {
    EXPECT_NEAR(y, 9.23, 1e-12);
  }
  EXPECT_TRUE(KaiserLowPass(KaiserLowPass::Design{}).filtered({}).empty());
}

TEST(KaiserLowPass, RefusesADesignThatIsNone) {
  using Design = KaiserLowPass::Design;
  EXPECT_THROW(KaiserLowPass(Design{.taps = 48}), std::invalid_argument);
  EXPECT_THROW(KaiserLowPass(Design{.taps = 1}), std::invalid_argument);
  EXPECT_THROW(KaiserLowPass(Design{.taps = 100'001}), std::invalid_argument);
  EXPECT_THROW(KaiserLowPass(Design{.beta = -1.0}), std::invalid_argument);
  EXPECT_THROW(KaiserLowPass(Design{.beta = 1e9}), std::invalid_argument);
  EXPECT_THROW(KaiserLowPass(Design{.cutoff = 0.0}), std::invalid_argument);
  EXPECT_THROW(KaiserLowPass(Design{.cutoff = 170.0}), std::invalid_argument);
  EXPECT_THROW(KaiserLowPass(Design{.sampleRate = std::nan("")}), std::invalid_argument);
}

}  // namespace kaiser_low_pass_test
}  // namespace haptics::filters
