#include "protocols/reading/recording_file.h"

#include <array>

#include <nlohmann/json.hpp>

#include "questionnaires/json/document.h"

namespace protocols {
namespace {

using haptics::recordings::ForceCalibration;
using Json = nlohmann::ordered_json;
using questionnaires::Node;
using questionnaires::Problems;

constexpr std::string_view kCalibrationFormat = "palpate-calibration-1";
constexpr double kLargestCoefficient = 1e12;

ForceCalibration readCalibrationRoot(const Node& root) {
  if (!root.isObjectWithOnlyKeys(
          {"format", "name", "unit", "coefficients_n", "range", "provenance"})) {
    return {};
  }
  root.requireFormat("format", kCalibrationFormat, "write one with 'palpate recording calibrate'");
  ForceCalibration calibration{
      .name = root.id("name"),
      .unit = root.text("unit"),
      .coefficients = root.numbers("coefficients_n", -kLargestCoefficient, kLargestCoefficient)};
  const std::size_t count = calibration.coefficients.size();
  if (count < 2 || count > haptics::recordings::kMostCalibrationOrder + 1) {
    root.problem(
        "coefficients_n",
        "a calibration has 2 to 6 coefficients",
        "list them from the constant one to that of the highest power");
  }
  if (root.has("range")) {
    const auto range = root.numbers("range", -kLargestCoefficient, kLargestCoefficient);
    if (range.size() != 2 || !(range[0] < range[1])) {
      root.problem("range", "a lowest and a higher reading are expected here", "write [low, high]");
    } else {
      calibration.lowest = range[0];
      calibration.highest = range[1];
    }
  }
  return calibration;
}

}  // namespace

std::optional<ForceCalibration> readCalibration(std::string_view json, Problems& problems) {
  return questionnaires::readJson<ForceCalibration>(json, problems, readCalibrationRoot);
}

std::string calibrationAsJson(
    const haptics::recordings::CalibrationFit& fit,
    const std::string& source,
    std::string_view sha256) {
  const ForceCalibration& calibration = fit.calibration;
  const Json json{
      {"format", kCalibrationFormat},
      {"name", calibration.name},
      {"unit", calibration.unit},
      {"coefficients_n", calibration.coefficients},
      {"range", {calibration.lowest, calibration.highest}},
      {"provenance",
       {{"source_file", source},
        {"source_sha256", sha256},
        {"points", fit.residuals.size()},
        {"rms_n", fit.rms},
        {"standard_error_n", fit.standardError ? Json(*fit.standardError) : Json()},
        {"largest_residual_n", fit.largest}}}};
  return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

namespace {

using haptics::recordings::RecordingColumns;
using haptics::recordings::TableColumn;
using questionnaires::Choice;
using questionnaires::Node;
using questionnaires::Problems;

constexpr std::string_view kColumnsFormat = "palpate-columns-1";
constexpr std::int64_t kMostColumns = 1000;
constexpr std::int64_t kMostSkippedLines = 100'000;
constexpr double kLargestCell = 1e12;
constexpr double kHighestRate = 1e6;  // [Hz]

constexpr std::array kSeparators{
    Choice<char>{"tab", '\t'},
    Choice<char>{"semicolon", ';'},
    Choice<char>{"comma", ','},
    Choice<char>{"blank", ' '}};

/// Milliseconds in a unit of time.
constexpr std::array kTimeUnits{
    Choice<double>{"s", 1000.0}, Choice<double>{"ms", 1.0}, Choice<double>{"us", 1e-3}};

TableColumn readColumn(const Node& node) {
  const auto column = node.member("column");
  if (column && !column->isText()) {
    return {.number = static_cast<std::size_t>(node.wholeNumber("column", 1, kMostColumns))};
  }
  return {.heading = node.text("column")};
}

void readTime(const Node& node, RecordingColumns& columns) {
  if (!node.isObjectWithOnlyKeys({"column", "unit", "rate_hz"})) return;
  if (node.has("rate_hz") == node.has("column")) {
    node.problem(
        node.has("column") ? "rate_hz" : "column",
        "a time is either a column or a rate",
        "name the column, or write \"rate_hz\" where the file has none");
    return;
  }
  if (node.has("rate_hz")) {
    columns.rate = node.number("rate_hz", 1e-3, kHighestRate);
    return;
  }
  columns.time = readColumn(node);
  columns.millisecondsPerTime = node.choice("unit", kTimeUnits);
}

void readTravel(const Node& node, RecordingColumns& columns) {
  if (!node.isObjectWithOnlyKeys({"column", "open", "closed"})) return;
  columns.travel = readColumn(node);
  columns.open = node.number("open", -kLargestCell, kLargestCell);
  columns.closed = node.number("closed", -kLargestCell, kLargestCell);
  if (node.isSound() && columns.open == columns.closed) {
    node.problem(
        "closed", "this is where the tool is open, too", "write what the column has there");
  }
}

void readForce(const Node& node, RecordingColumns& columns) {
  if (!node.isObjectWithOnlyKeys({"column", "unit", "zero", "factor", "saturates_at"})) return;
  columns.force = readColumn(node);
  columns.readingUnit = node.text("unit");
  columns.forceZero = node.number("zero", -kLargestCell, kLargestCell, 0.0);
  columns.forceFactor = node.number("factor", -kLargestCell, kLargestCell, 1.0);
  if (columns.forceFactor == 0.0) {
    node.problem("factor", "0 makes every force nothing", "leave it out, or write -1 to turn it");
  }
  if (node.has("saturates_at")) {
    columns.saturatesAt = node.number("saturates_at", -kLargestCell, kLargestCell);
  }
  if (const double newtons = haptics::recordings::newtonsIn(columns.readingUnit); newtons > 0.0) {
    columns.forceFactor *= newtons;
    columns.readingUnit = "N";
  }
}

ColumnsFile readColumnsRoot(const Node& root) {
  ColumnsFile file;
  if (!root.isObjectWithOnlyKeys(
          {"format", "skip_lines", "separator", "time", "travel", "force", "calibration"})) {
    return file;
  }
  root.requireFormat("format", kColumnsFormat);
  RecordingColumns& columns = file.columns;
  columns.skippedLines =
      static_cast<std::size_t>(root.wholeNumber("skip_lines", 0, kMostSkippedLines, 0));
  if (root.has("separator")) columns.separator = root.choice("separator", kSeparators);
  if (const auto time = root.requiredObject("time")) readTime(*time, columns);
  if (const auto travel = root.requiredObject("travel")) readTravel(*travel, columns);
  if (const auto force = root.requiredObject("force")) readForce(*force, columns);
  const auto isSame = [&](const TableColumn& other) {
    return columns.force.heading == other.heading && columns.force.number == other.number;
  };
  if (root.isSound() && (isSame(columns.travel) || (columns.time && isSame(*columns.time)))) {
    root.problem(
        "force.column",
        "this is the column of the travel or of the time, too",
        "name the column of the force");
  }
  file.calibrationFile = root.text("calibration", "");
  if (columns.readingUnit == "N" && !file.calibrationFile.empty()) {
    root.problem("calibration", "the forces are in newtons already", "leave the calibration out");
  }
  return file;
}

}  // namespace

std::optional<ColumnsFile> readColumns(std::string_view json, Problems& problems) {
  return questionnaires::readJson<ColumnsFile>(json, problems, readColumnsRoot);
}

}  // namespace protocols
