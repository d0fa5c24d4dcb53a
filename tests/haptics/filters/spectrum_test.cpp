#include "haptics/filters/spectrum.h"

#include <cmath>
#include <fstream>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/support/test_data.h"

namespace haptics::filters {
namespace spectrum_test {

TEST(Spectrum, HasTheAmplitudesOfSciPy) {
  std::ifstream file(tests::testData("recordings/golden.json"));
  const auto golden = nlohmann::json::parse(file)["spectrum"];
  const double rate = golden["rate_hz"].get<double>();
  std::vector<double> samples;
  for (std::size_t i = 0; i < golden["samples"].get<std::size_t>(); ++i) {
    const double t = static_cast<double>(i) / rate;
    const auto wave = [&](double f) { return std::sin(2.0 * std::numbers::pi * f * t); };
    samples.push_back(
        10.0 * wave(0.2) * wave(0.2) + 0.5 * wave(3.0) + 0.3 * wave(8.0) + 0.1 * wave(50.0) +
        0.01 * static_cast<double>(i));
  }
  const auto spectrum = spectrumOf(samples, rate, CutoffRule::Floor);
  EXPECT_DOUBLE_EQ(spectrum.step, rate / static_cast<double>(samples.size()));
  ASSERT_EQ(spectrum.amplitude.size(), golden["amplitudes"].size());
  for (std::size_t i = 0; i < spectrum.amplitude.size(); ++i) {
    EXPECT_NEAR(spectrum.amplitude[i], golden["amplitudes"][i].get<double>(), 1e-12) << i;
  }
}

}  // namespace spectrum_test
}  // namespace haptics::filters
