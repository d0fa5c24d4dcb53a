#pragma once

#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace haptics::recordings {

/// Converts the reading r of a force sensor to newtons by a polynomial,
///
///     f = scale · (c₀ + c₁ r + c₂ r² + …).
struct ForceCalibration {
  std::string name{};                  ///< e.g. `paper-eq1`
  std::string unit = "counts";         ///< unit of the reading, e.g. `counts`, `V`, `N`
  std::vector<double> coefficients{};  ///< c₀, c₁, …
  double scale = 1.0;                  ///< newtons per unit of the polynomial's value
  /// The range of readings for which the calibration was measured; outside it forces are
  /// extrapolated.
  double lowest = -std::numeric_limits<double>::infinity();
  double highest = std::numeric_limits<double>::infinity();
};

/// The force [N] at a reading.
double forceOf(double reading, const ForceCalibration& calibration) noexcept;

/// Whether a reading is outside the calibrated range.
bool isExtrapolated(double reading, const ForceCalibration& calibration) noexcept;

/// `paper-eq1`, eq. (1) of the punch paper, with r in counts (10 bits, 0…1023):
///
///     f = (3·10⁻⁷ r³ − 2·10⁻⁴ r² + 0.7815 r) · 9.81·10⁻³
///
/// In the authors' calibration, readings determine the load up to 869 counts (900 g); readings of
/// 870 and more belonged to loads of 700 to 1,300 g.
ForceCalibration publishedCalibration();

/// `recorder-2021`, the force column of the published recordings (in grams, although their heading
/// says otherwise), for comparison; at full scale it gives a sixth less than `paper-eq1`:
///
///     f = (3·10⁻⁷ r³ − 3·10⁻⁴ r² + 0.7261 r) · 9.81·10⁻³
ForceCalibration recorder2021Calibration();

/// `newtons`: for readings that are forces [N].
ForceCalibration newtons();

/// Newtons per unit of force or weight: N, mN, kN; g and kg at standard gravity, 9.80665 m/s². 0
/// for an unknown unit.
double newtonsIn(std::string_view unit) noexcept;

/// A known load on a sensor, and the sensor's reading.
struct CalibrationPoint {
  double reading = 0.0;  ///< [unit of the sensor]
  double force = 0.0;    ///< [N]
};

/// The measurements of a calibration.
struct CalibrationTable {
  std::string source{};       ///< name of the file
  std::string readingUnit{};  ///< e.g. `counts`, `V`, `mV`
  std::vector<CalibrationPoint> points{};
};

/// The columns of a calibration table, if they are not the default ones.
struct CalibrationColumns {
  std::string reading{};      ///< heading; empty: the first column
  std::string force{};        ///< heading; empty: the second column
  std::string readingUnit{};  ///< empty: from the heading, e.g. "U [mV]"
  std::string forceUnit{};    ///< N, mN, kN, g, kg; empty: from the heading, e.g. "load [g]"
};

/// Reads a table of readings and known loads: a header line and rows, separated by tabs, semicolons
/// or commas.
///
/// @throws UserError  if the text is empty or binary, if a column or unit is missing or unknown, or
///     a cell is not a number.
CalibrationTable readCalibrationTable(
    std::string_view text, std::string_view source, const CalibrationColumns& columns = {});

/// A least-squares polynomial through the points, and its residuals.
struct CalibrationFit {
  ForceCalibration calibration{};
  std::vector<double> residuals{};  ///< fitted − known force of each point [N]
  double rms = 0.0;                 ///< √(Σ residual² / n) [N]
  /// √(Σ residual² / (n − number of coefficients)) [N]; std::nullopt if there are as many
  /// coefficients as points, so that the curve passes through each of them.
  std::optional<double> standardError{};
  double largest = 0.0;  ///< |residual| [N]
  bool isRising = true;  ///< the force increases with the reading over the whole range
};

inline constexpr int kMostCalibrationOrder = 5;

/// Fits f = c₀ + c₁ r + …; without c₀ if @p isThroughZero, as in eq. (1) of the punch paper. Uses
/// QR factorisation, with readings scaled to ±1.
///
/// @param order  1 to kMostCalibrationOrder.
/// @throws UserError  if there are fewer different readings than coefficients, or than two; for
///     @p isThroughZero, readings of 0 do not count.
/// @throws std::invalid_argument  if the order is out of range.
CalibrationFit fitCalibration(const CalibrationTable& table, int order, bool isThroughZero);

}  // namespace haptics::recordings
