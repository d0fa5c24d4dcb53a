#include "haptics/recordings/trace.h"

#include <cstddef>
#include <stdexcept>
#include <string>

#include "haptics/recordings/error.h"

namespace haptics::recordings {

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
  std::vector<CurvePoint> samples;
  for (std::size_t i = rows.first - 1; i < rows.last; ++i) {
    samples.push_back({trace.travel[i], trace.force[i]});
  }
  try {
    return monotoneCurve(samples);
  } catch (const std::invalid_argument&) {
    throw Error(
        "Rows " + std::to_string(rows.first) + " to " + std::to_string(rows.last) +
        " are no closing hand (their travel does not rise): choose other rows.");
  }
}

}  // namespace haptics::recordings
