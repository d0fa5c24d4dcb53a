// The filter as it is felt: where the recording ends, and where the hand comes back into it.
#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "haptics/engine/built_in_models.h"
#include "haptics/engine/compiled_scene.h"

namespace haptics::engine {
namespace kalman_model_test {

using models::KalmanScheme;

KalmanSpec filterWith(KalmanScheme scheme, models::Extrapolation beyond) {
  auto spec = publishedFilter(scheme, 5);
  spec.interpolation.options.extrapolation = beyond;
  return spec;
}

/// Closing from 0 to 14 travel units and opening again at an even speed, at 1 kHz.
std::vector<double> thereAndBack(double speed) {
  std::vector<double> travels;
  const int steps = static_cast<int>(14.0 / speed * 1000.0);
  for (int i = 0; i <= 2 * steps; ++i) {
    travels.push_back(14.0 * (i <= steps ? i : 2 * steps - i) / steps);
  }
  return travels;
}

TEST(KalmanModel, UsesOnlyTheFiniteElementsOutsideTheRecording) {
  // The cut of our own ends at 11; there the finite elements give 7 N.
  for (const auto scheme :
       {KalmanScheme::AuthorsFirmware, KalmanScheme::Sequential, KalmanScheme::SpaceDomain}) {
    CompiledScene absent({.model = filterWith(scheme, models::Extrapolation::Absent)});
    double force = 0.0;
    for (int i = 0; i <= 1300; ++i) {
      const auto response = absent.respond({.travel = 0.01 * i});
      ASSERT_TRUE(response.isDefined);
      force = response.force;
    }
    EXPECT_NEAR(force, 7.0, 0.01);
  }
  CompiledScene zero(
      {.model = filterWith(KalmanScheme::AuthorsFirmware, models::Extrapolation::Zero)});
  double told = 0.0;
  for (int i = 0; i <= 1300; ++i) told = zero.respond({.travel = 0.01 * i}).force;
  EXPECT_NEAR(told, 7.0 * (1.0 - 0.44), 0.1);  // 0 N is taken for a measurement
}

TEST(KalmanModel, StaysWithinTheSlewLimitAtTheEndOfTheRecording) {
  constexpr double kSlew = 300.0;  // [N/s]; the shipped protocols allow 500
  for (const auto scheme :
       {KalmanScheme::PaperText,
        KalmanScheme::AuthorsFirmware,
        KalmanScheme::Sequential,
        KalmanScheme::SpaceDomain}) {
    auto spec = filterWith(scheme, models::Extrapolation::Absent);
    // Without it paper-text steps at every tick, wherever the hand is.
    if (scheme == KalmanScheme::PaperText) spec.smoothing = models::Smoothing::TwoPoint;
    for (const double speed : {1.0, 10.0, 57.0}) {
      CompiledScene scene({.model = spec});
      double last = 0.0;
      double largest = 0.0;
      for (const double travel : thereAndBack(speed)) {
        const double force = scene.respond({.travel = travel}).force;
        if (travel > 9.0 && travel < 13.0) largest = std::max(largest, std::abs(force - last));
        last = force;
      }
      EXPECT_LE(largest, kSlew * 1e-3) << static_cast<int>(scheme) << " at " << speed;
    }
  }
}

}  // namespace kalman_model_test
}  // namespace haptics::engine
