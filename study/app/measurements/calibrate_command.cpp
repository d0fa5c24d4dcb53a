// `recording calibrate`: fits a calibration to readings of a force sensor under known loads, and
// writes it to a file.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <string>
#include <variant>

#include <fmt/format.h>

#include "haptics/recordings/force_calibration.h"
#include "haptics/recordings/recording.h"
#include "protocols/reading/recording_file.h"
#include "study/app/command_options.h"
#include "study/app/measurements/recording_report.h"
#include "study/app/write_report.h"
#include "study/model/new_file.h"
#include "study/model/user_error.h"
#include "study/storage/protocol_repository.h"
#include "study/words/counted.h"

namespace study::app {
namespace {

namespace recordings = haptics::recordings;

struct CalibrateArguments {
  std::string file;
  std::string out;
  std::string report;
  std::string name = "own-sensor";
  recordings::CalibrationColumns columns;
  int order = 3;
  bool isThroughZero = false;
};

/// A calibration as text: "0.0123 + 0.0076665 r - 1.962e-06 r^2". A constant of 0 is left out.
std::string polynomialOf(const recordings::ForceCalibration& calibration) {
  std::string text;
  for (std::size_t power = 0; power < calibration.coefficients.size(); ++power) {
    const double c = calibration.coefficients[power];
    if (power == 0 && c == 0.0) continue;
    const auto sign = c < 0.0 ? (text.empty() ? "-" : " - ") : (text.empty() ? "" : " + ");
    const auto r = power == 0   ? std::string()
                   : power == 1 ? std::string(" r")
                                : fmt::format(" r^{}", power);
    text += fmt::format("{}{:.6g}{}", sign, std::abs(c), r);
  }
  return text;
}

/// The residuals of polynomials of each order that the number of loads allows.
DataTable orderTable(const recordings::CalibrationTable& table, bool isThroughZero) {
  DataTable orders{
      .name = "orders",
      .description = "Other orders, to compare with.",
      .columns = {
          {"order", "order"},
          {"rms_n", "RMS [N]"},
          {"standard_error_n", "standard error [N]"},
          {"largest_n", "largest residual [N]"}}};
  for (int order = 1; order <= recordings::kMostCalibrationOrder; ++order) {
    try {
      const auto fit = recordings::fitCalibration(table, order, isThroughZero);
      orders.rows.push_back(
          {std::int64_t{order},
           fit.rms,
           fit.standardError ? Cell(*fit.standardError) : Cell(),
           fit.largest});
    } catch (const UserError&) {
      break;  // too few loads for this order and higher ones
    }
  }
  return orders;
}

void print(
    const recordings::CalibrationTable& table,
    const recordings::CalibrationFit& fit,
    const DataTable& orders) {
  const auto& calibration = fit.calibration;
  fmt::print(
      "{}\n  {}, readings of {:g} to {:g} {}\n  f = {} N\n  RMS {:.4g} N, standard error {}, "
      "largest residual {:.4g} N\n\n  order     RMS [N]   standard error [N]   largest [N]\n",
      table.source,
      words::counted(table.points.size(), "load"),
      calibration.lowest,
      calibration.highest,
      calibration.unit,
      polynomialOf(calibration),
      fit.rms,
      fit.standardError ? fmt::format("{:.4g} N", *fit.standardError) : "–",
      fit.largest);
  for (const auto& row : orders.rows) {
    fmt::print(
        "  {:>5} {:>11.4g} {:>20} {:>13.4g}\n",
        std::get<std::int64_t>(row[0]),
        std::get<double>(row[1]),
        std::holds_alternative<double>(row[2]) ? fmt::format("{:.4g}", std::get<double>(row[2]))
                                               : "–",
        std::get<double>(row[3]));
  }
  if (!fit.standardError) {
    fmt::print(
        "\nThe curve has as many coefficients as there are loads: it passes through every point, "
        "and "
        "nothing\ntells how far it is off between them. Add loads, or choose a lower order.\n");
  }
  if (!fit.isRising) {
    fmt::print(
        "\nWARNING: this curve falls somewhere between the lowest and the highest reading, so that "
        "more\nload would be less force. Choose a lower order, or leave out loads that saturate "
        "the sensor.\n");
  }
}

/// @throws UserError  if the name is not allowed in a calibration file.
void requireAllowedName(const std::string& name) {
  const auto isPlain = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' ||
           c == '_' || c == '.';
  };
  if (!name.empty() && std::ranges::all_of(name, isPlain)) return;
  throw UserError(fmt::format(
      "'{}' is no name of a calibration. Use letters, digits, '.', '_' and '-', e.g. "
      "load-cell-2.",
      name));
}

int calibrate(const CalibrateArguments& command) {
  requireAllowedName(command.name);
  const std::string text = recordings::contentOfRecording(command.file);
  const std::filesystem::path path(command.file);
  const auto table =
      recordings::readCalibrationTable(text, path.filename().string(), command.columns);
  auto fit = recordings::fitCalibration(table, command.order, command.isThroughZero);
  fit.calibration.name = command.name;
  const auto orders = orderTable(table, command.isThroughZero);
  print(table, fit, orders);
  if (!command.out.empty()) {
    writeNewFile(
        command.out, protocols::calibrationAsJson(fit, table.source, storage::sha256(text)));
    fmt::print(
        "\nCalibration saved: {}. Name it in 'recording import --calibration', or in a columns "
        "file.\n",
        command.out);
  }
  if (!command.report.empty()) {
    writeDocument(command.report, "calibration", calibrationReport(table, fit, orders));
  }
  return 0;
}

}  // namespace

void addCalibrateCommand(CLI::App& parentCommand, Action& action) {
  auto [verb, command] = addCommand(
      parentCommand,
      action,
      "calibrate",
      "Fit a polynomial to readings of a force sensor under known loads",
      app::calibrate);
  verb->add_option(
          "TABLE",
          command.file,
          "CSV or TSV file with headings: a reading and its load in each row")
      ->required();
  verb->add_option("--order", command.order, "Order of the polynomial")
      ->check(CLI::Range(1, recordings::kMostCalibrationOrder))
      ->capture_default_str();
  verb->add_flag(
      "--through-zero",
      command.isThroughZero,
      "Fit without a constant term, so that a reading of 0 is 0 N, as in eq. (1) of the punch "
      "paper");
  verb->add_option(
      "--reading",
      command.columns.reading,
      "Heading of the column of readings (default: the first)");
  verb->add_option(
      "--force", command.columns.force, "Heading of the column of loads (default: the second)");
  verb->add_option(
      "--reading-unit",
      command.columns.readingUnit,
      "Unit of readings: V, mV, counts … (default: from the heading, 'sensor [V]')");
  verb->add_option(
      "--force-unit",
      command.columns.forceUnit,
      "Unit of loads: N, mN, kN, g or kg (default: from the heading, 'load [N]')");
  verb->add_option("--out", command.out, "New file for the calibration")->type_name("FILE");
  addReportFolder(*verb, command.report, "figures (curve and residuals)");
  verb->add_option("--name", command.name, "Name of the calibration")->capture_default_str();
}

}  // namespace study::app
