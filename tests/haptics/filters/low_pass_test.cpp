#include "haptics/filters/low_pass.h"

#include <cmath>
#include <numbers>
#include <stdexcept>

#include <gtest/gtest.h>

#include "haptics/filters/spectrum.h"
#include "haptics/reaming/material/synthetic_series.h"

namespace haptics::filters {
namespace low_pass_test {

constexpr double kRate = 100.0;

std::vector<double> sine(double frequency, std::size_t count) {
  std::vector<double> samples;
  for (std::size_t i = 0; i < count; ++i) {
    samples.push_back(
        std::sin(2.0 * std::numbers::pi * frequency * static_cast<double>(i) / kRate));
  }
  return samples;
}

double rmsOf(const std::vector<double>& a, const std::vector<double>& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += (a[i] - b[i]) * (a[i] - b[i]);
  return std::sqrt(sum / static_cast<double>(a.size()));
}

TEST(ZeroPhaseLowPass, WeighsEachFrequencyAsButterworthSaysAndDelaysNone) {
  constexpr double kCutoff = 2.0;
  for (const double frequency : {0.5, 1.0, 2.0, 3.0, 5.0}) {
    const auto in = sine(frequency, 20'000);
    const auto out = zeroPhaseLowPass(in, kRate, kCutoff);
    // The bilinear transform bends the axis: tan(π f / rate).
    const double x = std::tan(std::numbers::pi * frequency / kRate) /
                     std::tan(std::numbers::pi * kCutoff / kRate);
    const double gain = 1.0 / (1.0 + std::pow(x, 8.0));
    for (std::size_t i = 9000; i < 11'000; ++i)
      ASSERT_NEAR(out[i], gain * in[i], 1e-9) << frequency;
  }
}

TEST(ZeroPhaseLowPass, LeavesStraightLinesAsTheyAreUpToTheEnds) {
  std::vector<double> ramp;
  for (int i = 0; i < 5000; ++i) ramp.push_back(7.0 + 0.06 * i);  // 0 to 300 N
  for (const double cutoff : {0.01, 0.1, 5.0}) {
    const auto out = zeroPhaseLowPass(ramp, kRate, cutoff);
    for (std::size_t i = 0; i < ramp.size(); ++i) ASSERT_NEAR(out[i], ramp[i], 1e-9) << cutoff;
  }
}

TEST(ZeroPhaseLowPass, RefusesAnInvalidCutoff) {
  const std::vector<double> samples(100, 1.0);
  for (const double cutoff : {0.0, -1.0, 50.0, 1e9, std::nan("")}) {
    EXPECT_THROW(zeroPhaseLowPass(samples, kRate, cutoff), std::invalid_argument) << cutoff;
  }
}

TEST(Spectrum, ShowsALineAtItsPlaceWithItsAmplitude) {
  auto samples = sine(5.0, 20'000);
  for (double& sample : samples) sample *= 3.0;
  const auto spectrum = spectrumOf(samples, kRate, CutoffRule::Floor);
  std::size_t highest = 1;
  for (std::size_t i = 1; i < spectrum.amplitude.size(); ++i) {
    if (spectrum.amplitude[i] > spectrum.amplitude[highest]) highest = i;
  }
  EXPECT_NEAR(spectrum.step * static_cast<double>(highest), 5.0, spectrum.step);
  EXPECT_NEAR(spectrum.amplitude[highest], 3.0, 0.1);
}

TEST(Spectrum, PadsAPrimeNumberOfSamples) {
  // 199,999 is prime: its own Fourier transform would take minutes, a padded one milliseconds.
  const auto samples = sine(1.0, 199'999);
  const auto spectrum = spectrumOf(samples, kRate, CutoffRule::Plain);
  EXPECT_GE(spectrum.amplitude.size(), 100'000U);
  EXPECT_LE(spectrum.amplitude.size(), 102'000U);
}

TEST(Cutoff, LeavesOutNoiseAndKeepsTheCurve) {
  for (const double hardness : {0.2, 0.5, 0.9}) {
    const reaming::SyntheticTest test{.hardness = hardness, .seed = 7};
    const auto measured = reaming::syntheticSeries(test);
    const auto truth = reaming::noiselessSeries(test);
    // A reamer that stalls earlier or later for a little noise ends earlier or later.
    const std::size_t count = std::min(measured.force.size(), truth.force.size());
    const std::vector<double> force(measured.force.begin(), measured.force.begin() + count);
    const std::vector<double> wanted(truth.force.begin(), truth.force.begin() + count);
    const double cutoff = cutoffOf(force, kRate, CutoffRule::Floor);
    const double residual = rmsOf(zeroPhaseLowPass(force, kRate, cutoff), wanted);
    // The best of a scan: T11 allows four times as much.
    double oracle = 1e9;
    for (double tried = 0.005; tried < 10.0; tried *= 1.3) {
      oracle = std::min(oracle, rmsOf(zeroPhaseLowPass(force, kRate, tried), wanted));
    }
    EXPECT_LT(residual, 4.0 * oracle) << hardness << " at " << cutoff << " Hz";
    // The paper's plain spectrum leaks, and lets the rotation through.
    EXPECT_GT(cutoffOf(force, kRate, CutoffRule::Plain), 2.0 * cutoff);
  }
}

}  // namespace low_pass_test
}  // namespace haptics::filters
