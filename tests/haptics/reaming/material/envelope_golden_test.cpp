// A fitted material against computations that share nothing with it: a plain statistic of the
// samples here, and tests/data/reaming/envelope_reference.py, which has the rule for depths beyond
// the first end, and SciPy's filter.
#include <algorithm>
#include <cmath>
#include <fstream>
#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "haptics/reaming/material/material_fit.h"
#include "haptics/reaming/material/synthetic_series.h"
#include "tests/support/test_data.h"

namespace haptics::reaming {
namespace envelope_golden_test {

constexpr FitOptions kAsReferred{.cutoff = 0.1, .torqueCutoff = 0.1};

CurveNodes curveAt(const FittedEnvelope& envelope, double hardness) {
  const HardnessCurves curves{
      envelope.minimum.spline.nodes, envelope.average.spline.nodes, envelope.maximum.spline.nodes};
  return curveOf(curves, hardness);
}

std::vector<Series> staticTests() {
  auto study = syntheticStudy(1);
  std::erase_if(study, [](const auto& each) { return each.set != TestSet::Static; });
  return study;
}

/// The mean of the samples within 5 µm of a depth.
double measuredAt(const Series& series, double depth) {
  double sum = 0.0;
  double count = 0.0;
  for (std::size_t i = 0; i < series.force.size(); ++i) {
    if (std::abs(series.displacement[i] - depth) > 5e-6) continue;
    sum += series.force[i];
    count += 1.0;
  }
  return sum / count;
}

TEST(FittedMaterial, EqualsTheMeasurementsAtTheirDepths) {
  const auto study = staticTests();
  const auto fit = fitMaterial(study, {});
  const auto& force = fit.sets[0].force;
  for (const double depth : {1e-3, 2e-3, 4e-3, 6e-3}) {
    std::vector<double> measured;
    for (const auto& series : study) measured.push_back(measuredAt(series, depth));
    const auto [least, most] = std::minmax_element(measured.begin(), measured.end());
    double mean = 0.0;
    for (const double value : measured) mean += value / static_cast<double>(measured.size());
    constexpr double kNoise = 1.0;  // of a mean of samples [N]
    const auto off = [&](const FittedCurve& curve, double wanted) {
      return std::abs(curve.spline.at(depth) - wanted);
    };
    EXPECT_LE(off(force.minimum, *least), force.minimum.error.largest + kNoise) << depth;
    EXPECT_LE(off(force.average, mean), force.average.error.largest + kNoise) << depth;
    EXPECT_LE(off(force.maximum, *most), force.maximum.error.largest + kNoise) << depth;
    // Within the share that was asked for, too.
    EXPECT_LE(off(force.minimum, *least), 0.05 * *least + kNoise) << depth;
    EXPECT_LE(off(force.average, mean), 0.05 * mean + kNoise) << depth;
    EXPECT_LE(off(force.maximum, *most), 0.05 * *most + kNoise) << depth;
  }
}

TEST(FittedMaterial, SpansTheMeasuredRangeByItsHardness) {
  const auto study = staticTests();
  const auto fit = fitMaterial(study, {.wantedError = 0.01});
  std::vector<double> measured;
  for (const auto& series : study) measured.push_back(measuredAt(series, 6e-3));
  const auto [least, most] = std::minmax_element(measured.begin(), measured.end());
  ASSERT_GT(*most, 2.4 * *least);
  double before = 0.0;
  for (const double hardness : {0.0, 1.0 / 3.0, 2.0 / 3.0, 1.0}) {
    const double felt = forceOf(curveAt(fit.sets[0].force, hardness), 6e-3);
    EXPECT_GT(felt, 1.2 * before) << hardness;
    if (hardness == 0.0) {
      EXPECT_NEAR(felt, *least, 0.01 * *least + 1.0);
    }
    if (hardness == 1.0) {
      EXPECT_NEAR(felt, *most, 0.01 * *most + 1.0);
    }
    before = felt;
  }
}

const FittedEnvelope* find(const MaterialFit& fit, const std::string& set, bool isTorque) {
  for (const auto& each : fit.sets) {
    if (nameOf(each.set) != set) continue;
    return isTorque ? &*each.torque : &each.force;
  }
  return nullptr;
}

TEST(FittedMaterial, IsThatOfTheReferenceAtEveryDepth) {
  std::ifstream file(tests::testData("reaming/envelope_golden.json"));
  const auto golden = nlohmann::json::parse(file);
  const auto fit = fitMaterial(syntheticStudy(1), kAsReferred);
  int compared = 0;
  for (const auto& set : golden.at("sets")) {
    const bool isTorque = set.at("quantity") == "torque_nm";
    const auto* envelope = find(fit, set.at("test_set"), isTorque);
    ASSERT_NE(envelope, nullptr);
    for (const auto& row : set.at("rows")) {
      const double depth = 1e-3 * row.at("depth_mm").get<double>();
      const auto& places = envelope->average.data.x;
      const auto place = static_cast<std::size_t>(
          std::upper_bound(places.begin(), places.end(), depth) - places.begin() - 1);
      EXPECT_EQ(envelope->measured[place], row.at("measured").get<int>()) << row;
      EXPECT_EQ(envelope->held[place], row.at("held").get<int>()) << row;
      const std::pair<const char*, const FittedCurve*> curves[]{
          {"minimum", &envelope->minimum},
          {"average", &envelope->average},
          {"maximum", &envelope->maximum}};
      for (const auto& [name, curve] : curves) {
        const double wanted = row.at(name).get<double>();
        // Another way to read noisy samples, and another filter's ends.
        const double slack = 0.005 * std::abs(wanted) + (isTorque ? 0.05 : 1.0);
        EXPECT_NEAR(curve->data.y[place], wanted, slack) << name << row;
        EXPECT_NEAR(curve->spline.at(depth), wanted, curve->error.largest + slack) << name << row;
        ++compared;
      }
    }
  }
  EXPECT_GT(compared, 100);
}

}  // namespace envelope_golden_test
}  // namespace haptics::reaming
