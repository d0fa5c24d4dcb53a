#include "protocols/reading/calibration_file.h"

#include <utility>

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

ForceCalibration readRoot(const Node& root) {
  if (!root.isObjectWith({"format", "name", "unit", "coefficients_n", "range", "provenance"})) {
    return {};
  }
  const std::string format = root.text("format");
  if (!format.empty() && format != kCalibrationFormat) {
    root.problem(
        "format",
        "this is no calibration file of the kind that this program reads",
        "write one with 'palpate recording calibrate'");
  }
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
  Problems found;
  ForceCalibration calibration;
  if (const auto value = questionnaires::parseJson(json, found)) {
    calibration = readRoot(Node(*value, "$", found));
  }
  problems.append(found);
  return found.hasErrors() ? std::nullopt : std::optional(std::move(calibration));
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
        {"standard_error_n", fit.standardError},
        {"largest_residual_n", fit.largest}}}};
  return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace protocols
