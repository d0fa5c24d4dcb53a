#include "haptics/recordings/force_calibration.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <set>
#include <stdexcept>

#include <Eigen/QR>

#include "base/text_table.h"
#include "haptics/recordings/recording.h"

namespace haptics::recordings {
namespace {

constexpr double kPaperNewtonsPerGram = 9.81e-3;
constexpr double kLastCalibratedCount = 869.0;
constexpr double kStandardGravity = 9.80665;  // [m/s²]

}  // namespace

double forceOf(double reading, const ForceCalibration& calibration) noexcept {
  // Sum powers from the highest to the lowest, each computed as a product: this reproduces
  // published forces to the last bit.
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

ForceCalibration publishedCalibration() {
  return {
      .name = "paper-eq1",
      .coefficients = {0.0, 0.7815, -2e-4, 3e-7},
      .scale = kPaperNewtonsPerGram,
      .highest = kLastCalibratedCount};
}

ForceCalibration recorder2021Calibration() {
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

namespace {

/// Index of a column, from 0: by its heading, or @p usual if that is empty.
std::size_t columnIndexOf(
    const std::string& head,
    std::size_t usual,
    const std::vector<std::string>& heads,
    std::string_view source) {
  if (head.empty() && usual < heads.size()) return usual;
  const auto found = std::ranges::find(heads, head);
  if (!head.empty() && found != heads.end()) return static_cast<std::size_t>(found - heads.begin());
  throw base::UserError(
      "'" + std::string(source) + "' has no column " +
      (head.empty() ? "for readings and one for loads" : "'" + head + "'") + ". Its columns are " +
      base::listed(heads) + ".");
}

std::string unitIn(const std::string& cell) {
  std::string unit = base::columnHeadingOf(cell).unit;
  if (cell.find_first_of("[(") != std::string::npos) return unit;
  // Units after an underscore are often in lower case.
  unit = base::lowerCase(unit);
  for (const char* known : {"V", "mV", "N", "mN", "kN"}) {
    if (unit == base::lowerCase(known)) return known;
  }
  return unit;
}

double newtonsOf(const std::string& unit, std::string_view source) {
  if (const double newtons = newtonsIn(unit); newtons > 0.0) return newtons;
  throw base::UserError(
      "The loads in '" + std::string(source) + "' have " +
      (unit.empty() ? "no unit" : "an unknown unit, '" + unit + "'") +
      ". Write N, mN, kN, g or kg into the head, as in 'load [N]', or name the unit.");
}

double numberOf(
    const std::vector<std::string>& cells,
    std::size_t place,
    char separator,
    const base::TextLine& line,
    std::string_view source) {
  const auto value =
      place < cells.size() ? base::numberIn(cells[place], separator) : std::optional<double>();
  if (value) return *value;
  throw base::UserError(
      "Line " + std::to_string(line.number) + " of '" + std::string(source) + "' has " +
      (place < cells.size() ? "'" + cells[place] + "'" : "no cell") +
      " where a number must be: correct or remove the line.");
}

}  // namespace

CalibrationTable readCalibrationTable(
    std::string_view text, std::string_view source, const CalibrationColumns& columns) {
  requireText(text, "'" + std::string(source) + "'");
  const auto lines = base::linesOf(base::withoutByteOrderMark(text));
  if (lines.empty()) throw base::UserError("'" + std::string(source) + "' is empty.");
  const char separator = base::separatorOf(lines.front().text);
  const auto heads = base::cellsOf(lines.front().text, separator);
  const std::size_t reading = columnIndexOf(columns.reading, 0, heads, source);
  const std::size_t force = columnIndexOf(columns.force, 1, heads, source);
  CalibrationTable table{.source = std::string(source), .readingUnit = columns.readingUnit};
  if (table.readingUnit.empty()) table.readingUnit = unitIn(heads[reading]);
  if (table.readingUnit.empty()) {
    throw base::UserError(
        "The readings in '" + table.source +
        "' have no unit. Write one into the head, as in 'sensor [V]', or name it (V, mV, counts).");
  }
  const double newtons =
      newtonsOf(columns.forceUnit.empty() ? unitIn(heads[force]) : columns.forceUnit, source);
  for (std::size_t i = 1; i < lines.size(); ++i) {
    const auto cells = base::cellsOf(lines[i].text, separator);
    table.points.push_back(
        {numberOf(cells, reading, separator, lines[i], source),
         newtons * numberOf(cells, force, separator, lines[i], source)});
  }
  return table;
}

namespace {

/// Whether a polynomial increases over its range, checked in small steps.
bool risesWithin(const ForceCalibration& calibration) {
  constexpr int kSteps = 1000;
  double last = forceOf(calibration.lowest, calibration);
  for (int i = 1; i <= kSteps; ++i) {
    const double share = static_cast<double>(i) / kSteps;
    const double next = forceOf(
        calibration.lowest + share * (calibration.highest - calibration.lowest), calibration);
    if (next < last) return false;
    last = next;
  }
  return true;
}

void requireEnough(const CalibrationTable& table, std::size_t coefficients, bool isThroughZero) {
  std::set<double> readings;
  for (const CalibrationPoint& point : table.points) {
    if (!isThroughZero || point.reading != 0.0) readings.insert(point.reading);
  }
  if (readings.size() >= std::max<std::size_t>(coefficients, 2)) return;
  throw base::UserError(
      "'" + table.source + "' has " + std::to_string(readings.size()) +
      " different readings; this order needs " +
      std::to_string(std::max<std::size_t>(coefficients, 2)) +
      " or more: choose a lower one, or measure more loads.");
}

}  // namespace

CalibrationFit fitCalibration(const CalibrationTable& table, int order, bool isThroughZero) {
  if (order < 1 || order > kMostCalibrationOrder) {
    throw std::invalid_argument("the order of a calibration is 1 to 5");
  }
  const int first = isThroughZero ? 1 : 0;
  const int count = order + 1 - first;
  requireEnough(table, static_cast<std::size_t>(count), isThroughZero);

  const auto isLowerReading = [](const CalibrationPoint& a, const CalibrationPoint& b) {
    return a.reading < b.reading;
  };
  const auto [lowest, highest] =
      std::minmax_element(table.points.begin(), table.points.end(), isLowerReading);
  // Scale readings to ±1, since powers of a thousand counts would span 15 decades.
  const double unit = std::max(std::abs(lowest->reading), std::abs(highest->reading));
  const auto rows = static_cast<Eigen::Index>(table.points.size());
  Eigen::MatrixXd powers(rows, count);
  Eigen::VectorXd forces(rows);
  for (Eigen::Index row = 0; row < rows; ++row) {
    const CalibrationPoint& point = table.points[static_cast<std::size_t>(row)];
    forces[row] = point.force;
    for (int k = 0; k < count; ++k) powers(row, k) = std::pow(point.reading / unit, k + first);
  }
  const Eigen::VectorXd solution = powers.colPivHouseholderQr().solve(forces);

  CalibrationFit fit{
      .calibration = {
          .unit = table.readingUnit,
          .coefficients = std::vector<double>(static_cast<std::size_t>(order) + 1, 0.0),
          .lowest = lowest->reading,
          .highest = highest->reading}};
  for (int k = 0; k < count; ++k) {
    fit.calibration.coefficients[static_cast<std::size_t>(k + first)] =
        solution[k] / std::pow(unit, k + first);
  }
  double squares = 0.0;
  for (const CalibrationPoint& point : table.points) {
    const double residual = forceOf(point.reading, fit.calibration) - point.force;
    squares += residual * residual;
    fit.largest = std::max(fit.largest, std::abs(residual));
    fit.residuals.push_back(residual);
  }
  fit.rms = std::sqrt(squares / static_cast<double>(rows));
  if (rows > count) fit.standardError = std::sqrt(squares / static_cast<double>(rows - count));
  fit.isRising = risesWithin(fit.calibration);
  return fit;
}

}  // namespace haptics::recordings
