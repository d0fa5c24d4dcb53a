#include "haptics/recordings/force_calibration.h"

#include <array>
#include <cstddef>

namespace haptics::recordings {
namespace {

constexpr double kPaperNewtonsPerGram = 9.81e-3;
constexpr double kLastCalibratedCount = 869.0;
constexpr double kStandardGravity = 9.80665;  // [m/s²]

}  // namespace

double forceOf(double reading, const ForceCalibration& calibration) noexcept {
  // From the highest power to the lowest, each as a product: published forces keep their last bit.
  double sum = 0.0;
  for (std::size_t power = calibration.coefficients.size(); power-- > 0;) {
    double term = calibration.coefficients[power];
    for (std::size_t i = 0; i < power; ++i) term *= reading;
    sum += term;
  }
  return sum * calibration.scale;
}

bool isExtrapolated(double reading, const ForceCalibration& calibration) noexcept {
  return reading < calibration.lowest || reading > calibration.highest;
}

ForceCalibration paperEq1() {
  return {
      .name = "paper-eq1",
      .coefficients = {0.0, 0.7815, -2e-4, 3e-7},
      .scale = kPaperNewtonsPerGram,
      .highest = kLastCalibratedCount};
}

ForceCalibration recorder2021() {
  return {
      .name = "recorder-2021",
      .coefficients = {0.0, 0.7261, -3e-4, 3e-7},
      .scale = kPaperNewtonsPerGram,
      .highest = kLastCalibratedCount};
}

ForceCalibration newtons() {
  return {.name = "newtons", .unit = "N", .coefficients = {0.0, 1.0}};
}

double newtonsIn(std::string_view unit) noexcept {
  struct Unit {
    std::string_view name;
    double newtons;
  };
  constexpr std::array kUnits{
      Unit{"N", 1.0},
      Unit{"mN", 1e-3},
      Unit{"kN", 1e3},
      Unit{"g", 1e-3 * kStandardGravity},
      Unit{"kg", kStandardGravity}};
  for (const Unit& known : kUnits) {
    if (known.name == unit) return known.newtons;
  }
  return 0.0;
}

}  // namespace haptics::recordings
