#include "haptics/recordings/trace.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

#include "haptics/recordings/recording.h"

namespace haptics::recordings {
namespace {

std::vector<CurvePoint> samplesOf(const Trace& trace, const RowRange& rows) {
  std::vector<CurvePoint> samples;
  for (std::size_t i = rows.first - 1; i < rows.last; ++i) {
    samples.push_back({trace.travel[i], trace.force[i]});
  }
  return samples;
}

}  // namespace

ForceCalibration calibrationFor(const Recording& recording) {
  if (recording.calibration) return *recording.calibration;
  throw base::UserError(
      "The forces of '" + recording.source + "' are readings in " + recording.readingUnit +
      ", and it is not known what they are in newtons. Write N, mN, kN, g or kg if that is their "
      "unit, or calibrate the sensor ('palpate recording calibrate') and name its file.");
}

Trace traceOf(
    const Recording& recording, const ForceCalibration& calibration, const TravelFilter& filter) {
  if (calibration.unit != recording.readingUnit) {
    throw base::UserError(
        "The calibration '" + calibration.name + "' is for readings in " + calibration.unit +
        ", and those of '" + recording.source + "' are in " + recording.readingUnit +
        ": choose the calibration of this sensor.");
  }
  Trace trace{.calibration = calibration};
  trace.force.reserve(recording.rows.size());
  std::vector<double> travel;
  travel.reserve(recording.rows.size());
  for (const Recording::Row& row : recording.rows) {
    travel.push_back(row.travel);
    trace.force.push_back(forceOf(row.reading, calibration));
  }
  trace.travel = filtered(travel, samplingOf(recording).rate, filter);
  return trace;
}

MonotoneCurve curveOf(const Trace& trace, const RowRange& rows) {
  try {
    return monotoneCurve(samplesOf(trace, rows));
  } catch (const std::invalid_argument&) {
    throw base::UserError(
        "Rows " + std::to_string(rows.first) + " to " + std::to_string(rows.last) +
        " are no closing hand (their travel does not rise): choose other rows.");
  }
}

std::optional<MonotoneCurve> openingCurveOf(const Trace& trace, const RowRange& rows) {
  auto samples = samplesOf(trace, rows);
  std::ranges::reverse(samples);
  try {
    return monotoneCurve(samples);
  } catch (const std::invalid_argument&) {
    return std::nullopt;
  }
}

namespace {

double meanOf(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double value : values) sum += value;
  return sum / static_cast<double>(values.size());
}

double covarianceOf(const std::vector<double>& a, const std::vector<double>& b) {
  const double meanA = meanOf(a);
  const double meanB = meanOf(b);
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += (a[i] - meanA) * (b[i] - meanB);
  return sum / static_cast<double>(a.size() - 1);
}

}  // namespace

ProcessNoise processNoiseOf(const Trace& trace, std::span<const RowRange> rows, double leastStep) {
  constexpr std::size_t kFewest = 3;
  std::vector<double> force;
  std::vector<double> stiffness;
  ProcessNoise noise;
  double lastTravel = 0.0;
  for (const RowRange& range : rows) {
    for (std::size_t row = range.first - 1; row < range.last; ++row) {
      const double travelled = trace.travel[row] - lastTravel;
      const bool isFirst = force.empty();
      if (!isFirst && (travelled == 0.0 || std::abs(travelled) < leastStep)) {
        ++noise.resting;
        continue;
      }
      stiffness.push_back(isFirst ? 0.0 : (trace.force[row] - force.back()) / travelled);
      force.push_back(trace.force[row]);
      lastTravel = trace.travel[row];
    }
  }
  if (force.size() < kFewest) {
    throw base::UserError(
        "Two rows and fewer say nothing about a variance. Name longer ranges of rows.");
  }
  noise.samples = force.size();
  noise.force = covarianceOf(force, force);
  noise.covariance = covarianceOf(force, stiffness);
  noise.stiffness = covarianceOf(stiffness, stiffness);
  return noise;
}

}  // namespace haptics::recordings
