#include "haptics/recordings/force_calibration.h"

#include <array>

namespace haptics::recordings {
namespace {

constexpr double kNewtonsPerGram = 9.81e-3;
constexpr std::array kAll{ForceCalibration::PaperEq1, ForceCalibration::Recorder2021};

}  // namespace

double forceOf(double r, ForceCalibration calibration) noexcept {
  const bool isPaper = calibration == ForceCalibration::PaperEq1;
  const double square = isPaper ? -2e-4 : -3e-4;
  const double linear = isPaper ? 0.7815 : 0.7261;
  return (3e-7 * r * r * r + square * r * r + linear * r) * kNewtonsPerGram;
}

std::string_view nameOf(ForceCalibration calibration) noexcept {
  return calibration == ForceCalibration::PaperEq1 ? "paper-eq1" : "recorder-2021";
}

std::optional<ForceCalibration> forceCalibrationNamed(std::string_view name) noexcept {
  for (const ForceCalibration calibration : kAll) {
    if (nameOf(calibration) == name) return calibration;
  }
  return std::nullopt;
}

}  // namespace haptics::recordings
