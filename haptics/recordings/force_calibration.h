#pragma once

#include <limits>
#include <string>
#include <string_view>
#include <vector>

namespace haptics::recordings {

/// From what a force sensor reads to newtons: a polynomial of the reading r,
///
///     f = scale · (c₀ + c₁ r + c₂ r² + …).
struct ForceCalibration {
  std::string name{};                  ///< e.g. `paper-eq1`
  std::string unit = "counts";         ///< of the reading, e.g. `counts`, `V`, `N`
  std::vector<double> coefficients{};  ///< c₀, c₁, …
  double scale = 1.0;                  ///< newtons in one unit of the polynomial
  /// The readings for which the calibration was measured; beyond them a force is extrapolated.
  double lowest = -std::numeric_limits<double>::infinity();
  double highest = std::numeric_limits<double>::infinity();
};

/// The force [N] at a reading.
double forceOf(double reading, const ForceCalibration& calibration) noexcept;

/// Whether a reading lies outside of what was calibrated.
bool isExtrapolated(double reading, const ForceCalibration& calibration) noexcept;

/// `paper-eq1`, eq. (1) of the punch paper, with r in counts (10 bits, 0…1023):
///
///     f = (3·10⁻⁷ r³ − 2·10⁻⁴ r² + 0.7815 r) · 9.81·10⁻³
///
/// Up to 869 counts (900 g) readings and loads kept together in the authors' calibration; readings
/// of 870 and more stood for 700 to 1,300 g.
ForceCalibration paperEq1();

/// `recorder-2021`, the force column of the published recordings (there in grams, although their
/// heading says otherwise), kept to compare with; it reads a sixth less at full scale:
///
///     f = (3·10⁻⁷ r³ − 3·10⁻⁴ r² + 0.7261 r) · 9.81·10⁻³
ForceCalibration recorder2021();

/// `newtons`: the recording has forces already.
ForceCalibration newtons();

/// Newtons in a unit of force or of weight: N, mN, kN; g and kg at standard gravity, 9.80665 m/s².
/// 0 where the unit is another one.
double newtonsIn(std::string_view unit) noexcept;

}  // namespace haptics::recordings
