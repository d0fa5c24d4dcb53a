#pragma once

#include <cstddef>
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
ForceCalibration publishedCalibration();

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

/// A known load on a sensor, and what the sensor read.
struct CalibrationPoint {
  double reading = 0.0;  ///< [unit of the sensor]
  double force = 0.0;    ///< [N]
};

/// Loads and readings of a sensor, as measured.
struct CalibrationTable {
  std::string source{};       ///< name of the file
  std::string readingUnit{};  ///< e.g. `counts`, `V`, `mV`
  std::vector<CalibrationPoint> points{};
};

/// Which columns a calibration table has, where its heads do not say it.
struct CalibrationColumns {
  std::string reading{};      ///< its head; empty: the first column
  std::string force{};        ///< its head; empty: the second column
  std::string readingUnit{};  ///< empty: from the head, e.g. "U [mV]"
  std::string forceUnit{};    ///< N, mN, kN, g, kg; empty: from the head, e.g. "load [g]"
};

/// Reads a table of readings and known loads: a head and rows, between tabs, semicolons or commas.
///
/// @throws UserError  if a column or a unit is not there or unknown, or a cell is no number.
CalibrationTable readCalibrationTable(
    std::string_view text, std::string_view source, const CalibrationColumns& columns = {});

/// The polynomial that is nearest to the points in least squares, and how near it is.
struct CalibrationFit {
  ForceCalibration calibration{};
  std::vector<double> residuals{};  ///< of each point: fitted − known force [N]
  double rms = 0.0;                 ///< √(Σ residual² / n) [N]
  /// √(Σ residual² / (n − number of coefficients)) [N]; 0 where the curve goes through all points.
  double standardError = 0.0;
  double largest = 0.0;  ///< |residual| [N]
  bool rises = true;     ///< from the lowest to the highest reading more reading is more force
};

inline constexpr int kMostCalibrationOrder = 5;

/// Fits f = c₀ + c₁ r + … of an order; without c₀ where it is to go through zero, as eq. (1) of the
/// punch paper does. By QR factorisation, with readings scaled to ±1.
///
/// @param order  1 to kMostCalibrationOrder.
/// @throws UserError  if there are fewer points with different readings than coefficients.
/// @throws std::invalid_argument  if the order is out of range.
CalibrationFit fitCalibration(const CalibrationTable& table, int order, bool throughZero);

}  // namespace haptics::recordings
