#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "haptics/recordings/force_calibration.h"

namespace haptics::recordings {

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
/// @throws Error  if a column or a unit is not there or unknown, or a cell is no number.
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
/// @throws Error  if there are fewer points with different readings than coefficients.
/// @throws std::invalid_argument  if the order is out of range.
CalibrationFit fitCalibration(const CalibrationTable& table, int order, bool throughZero);

}  // namespace haptics::recordings
