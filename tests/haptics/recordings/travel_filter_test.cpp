#include <cmath>
#include <numbers>
#include <numeric>
#include <stdexcept>

#include <gtest/gtest.h>

#include "haptics/recordings/trace.h"

namespace haptics::recordings {
namespace travel_filter_test {

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

TEST(TravelFilter, LeavesTheTravelAloneWhereAskedTo) {
  const std::vector<double> travel{0.25, 0.51, 0.25, 1.02};
  EXPECT_EQ(filtered(travel, TravelFilter::None), travel);
}

TEST(TravelFilter, IsCalledAsResearchersCallIt) {
  EXPECT_EQ(nameOf(TravelFilter::AuthorsFir), "authors-fir");
  EXPECT_EQ(travelFilterNamed("authors-fir"), TravelFilter::AuthorsFir);
  EXPECT_EQ(travelFilterNamed("none"), TravelFilter::None);
  EXPECT_FALSE(travelFilterNamed("butterworth"));
}

TEST(TravelFilter, StatesEveryParameterThatItUses) {
  const KaiserLowPass::Design design;
  const std::string words = parametersOf(TravelFilter::AuthorsFir);
  EXPECT_NE(words.find(std::to_string(design.taps) + "-tap"), std::string::npos);
  EXPECT_NE(words.find("beta 5.653"), std::string::npos);
  EXPECT_NE(words.find("17.69075 Hz"), std::string::npos);
  EXPECT_DOUBLE_EQ(design.beta, 5.653);
  EXPECT_DOUBLE_EQ(design.cutoff, 17.69075);
}

}  // namespace travel_filter_test
}  // namespace haptics::recordings
