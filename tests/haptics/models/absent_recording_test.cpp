// A filter where nothing was recorded: a prediction and the finite elements, and no third thing.
#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "haptics/models/interpolation.h"
#include "haptics/models/kalman_filter.h"
#include "tests/support/test_data.h"

namespace haptics::models {
namespace absent_recording_test {

using Noise = KalmanNoise<double>;
using Printed = KalmanFilter<double, TextbookCovariance>;

const std::map<std::string, KalmanScheme> kSchemes{
    {"paper-text", KalmanScheme::PaperText},
    {"authors-firmware", KalmanScheme::AuthorsFirmware},
    {"sequential", KalmanScheme::Sequential},
    {"space-domain", KalmanScheme::SpaceDomain}};
const std::map<std::string, ProcessNoiseReading> kReadings{
    {"symmetrised", ProcessNoiseReading::Symmetrised},
    {"state-order", ProcessNoiseReading::StateOrder},
    {"product", ProcessNoiseReading::Product}};

/// tests/data/kalman/make_golden.py: NumPy's matrices.
nlohmann::json golden() {
  std::ifstream file(tests::testData("kalman/golden.json"));
  return nlohmann::json::parse(file);
}

/// The largest relative difference of force and of its variance from @p expected.
template <typename Filter>
double largestDifference(
    Filter filter, const nlohmann::json& inputs, const nlohmann::json& expected) {
  double largest = 0.0;
  const auto compare = [&](double ours, double theirs) {
    largest = std::max(largest, std::abs(ours - theirs) / std::max(1.0, std::abs(theirs)));
  };
  for (std::size_t i = 0; i < inputs["travelled"].size(); ++i) {
    const auto in = [&](const char* name) { return inputs[name][i].get<double>(); };
    filter.step(in("travelled"), in("elastic"), in("recorded"), in("trust"));
    compare(filter.force(), expected["force"][i].get<double>());
    compare(filter.variances().force, expected["variance"][i].get<double>());
  }
  return largest;
}

TEST(AbsentRecording, IsFilteredAsAnIndependentFilterWithMissingMeasurementsDoes) {
  const auto known = golden();
  ASSERT_EQ(known["cases"].size(), 15U);
  for (const auto& expected : known["cases"]) {
    const auto scheme = kSchemes.at(expected["scheme"]);
    const std::string process = expected["process"];
    const double difference =
        process == "as-printed"
            ? largestDifference(Printed(Noise().asPrinted(), scheme), known, expected)
            : largestDifference(
                  KalmanFilter<double>(Noise::published(kReadings.at(process)).factored(), scheme),
                  known,
                  expected);
    EXPECT_LE(difference, 1e-9) << expected["scheme"] << ", " << process;
  }
}

TEST(AbsentRecording, LeavesTheForceToTheFiniteElements) {
  for (const auto& [name, scheme] : kSchemes) {
    KalmanFilter<double> filter(Noise().factored(), scheme);
    double sum = 0.0;
    for (int i = 0; i < 400; ++i) {
      const double force = filter.step(0.0, 3.26, 0.0, 0.0);
      if (i >= 300) sum += force / 100.0;
    }
    EXPECT_NEAR(sum, 3.26, 0.01) << name;
  }
}

TEST(AbsentRecording, LeavesTheForceMoreUncertain) {
  KalmanFilter<double> with(Noise().factored(), KalmanScheme::AuthorsFirmware);
  KalmanFilter<double> without(Noise().factored(), KalmanScheme::AuthorsFirmware);
  for (int i = 0; i < 50; ++i) {
    with.step(0.01, 3.0, 3.0);
    without.step(0.01, 3.0, 0.0, 0.0);
  }
  // P₁₁ is what the second prediction leaves; a measurement multiplies it by R / (P₁₁ + R).
  const double predicted = without.variances().force;
  EXPECT_GT(predicted, Noise().processForce);
  EXPECT_NEAR(with.variances().force, predicted * 7.742 / (predicted + 7.742), 0.05);
}

TEST(AbsentRecording, IsTrustedFromItsEndsInwards) {
  const std::vector<CurveNode<double>> nodes{{2.0, 0.0}, {6.0, 4.0}, {10.0, 5.0}};
  const Interpolation<double> curve(
      nodes.data(), nodes.size(), {.extrapolation = Extrapolation::Absent, .rampLength = 2.0});
  EXPECT_EQ(curve.measurementWeightAt(1.999), 0.0);
  EXPECT_EQ(curve.measurementWeightAt(2.0), 0.0);
  EXPECT_EQ(curve.measurementWeightAt(3.0), 0.5);
  EXPECT_EQ(curve.measurementWeightAt(6.0), 1.0);
  EXPECT_EQ(curve.measurementWeightAt(9.5), 0.25);
  EXPECT_EQ(curve.measurementWeightAt(10.1), 0.0);
  EXPECT_EQ(curve.measurementWeightAt(std::nan("")), 0.0);
  std::size_t hint = 0;
  EXPECT_FALSE(curve.at(1.9, hint).isDefined);
  EXPECT_FALSE(curve.at(10.1, hint).isDefined);
  EXPECT_DOUBLE_EQ(curve.at(3.0, hint).force, 1.0);  // within it nothing changes
  const Interpolation<double> held(
      nodes.data(), nodes.size(), {.extrapolation = Extrapolation::Hold});
  EXPECT_EQ(held.measurementWeightAt(50.0), 1.0);
}

}  // namespace absent_recording_test
}  // namespace haptics::models
