#include "haptics/recordings/trace.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <stdexcept>
#include <string>

#include "haptics/recordings/kaiser_low_pass.h"
#include "haptics/recordings/recording.h"

namespace haptics::recordings {

namespace {

constexpr double kNewtonsPerGram = 9.81e-3;
constexpr std::array kCalibrations{ForceCalibration::PaperEq1, ForceCalibration::Recorder2021};

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
  for (const ForceCalibration calibration : kCalibrations) {
    if (nameOf(calibration) == name) return calibration;
  }
  return std::nullopt;
}

namespace {

constexpr std::array kTravelFilters{TravelFilter::AuthorsFir, TravelFilter::None};

}  // namespace

std::vector<double> filtered(std::span<const double> travel, TravelFilter filter) {
  if (filter == TravelFilter::None) return {travel.begin(), travel.end()};
  return KaiserLowPass(KaiserLowPass::Design{}).filtered(travel);
}

std::string_view nameOf(TravelFilter filter) noexcept {
  return filter == TravelFilter::AuthorsFir ? "authors-fir" : "none";
}

std::string parametersOf(TravelFilter filter) {
  if (filter == TravelFilter::None) return "travel as recorded";
  return "49-tap linear-phase Kaiser FIR, beta 5.653, -6 dB at 17.69075 Hz, Fs 1000/3 Hz nominal, "
         "unit gain at rest, delay of 24 rows taken out, end values held";
}

std::optional<TravelFilter> travelFilterNamed(std::string_view name) noexcept {
  for (const TravelFilter filter : kTravelFilters) {
    if (nameOf(filter) == name) return filter;
  }
  return std::nullopt;
}

namespace {

std::vector<CurvePoint> samplesOf(const Trace& trace, const RowRange& rows) {
  std::vector<CurvePoint> samples;
  for (std::size_t i = rows.first - 1; i < rows.last; ++i) {
    samples.push_back({trace.travel[i], trace.force[i]});
  }
  return samples;
}

}  // namespace

Trace traceOf(const Recording& recording, ForceCalibration calibration, TravelFilter filter) {
  Trace trace;
  trace.force.reserve(recording.rows.size());
  std::vector<double> travel;
  travel.reserve(recording.rows.size());
  for (const Recording::Row& row : recording.rows) {
    travel.push_back(row.travel);
    trace.force.push_back(forceOf(row.reading, calibration));
  }
  trace.travel = filtered(travel, filter);
  return trace;
}

MonotoneCurve curveOf(const Trace& trace, const RowRange& rows) {
  try {
    return monotoneCurve(samplesOf(trace, rows));
  } catch (const std::invalid_argument&) {
    throw Error(
        "Rows " + std::to_string(rows.first) + " to " + std::to_string(rows.last) +
        " are no closing hand (their travel does not rise): choose other rows.");
  }
}

std::optional<MonotoneCurve> openingCurveOf(const Trace& trace, const RowRange& rows) {
  auto samples = samplesOf(trace, rows);
  std::reverse(samples.begin(), samples.end());
  try {
    return monotoneCurve(samples);
  } catch (const std::invalid_argument&) {
    return std::nullopt;
  }
}

}  // namespace haptics::recordings
