#include "haptics/recordings/trace.h"

#include <algorithm>
#include <cstddef>
#include <stdexcept>
#include <string>

#include "haptics/recordings/error.h"

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
