#include "haptics/recordings/recording_survey.h"

#include <algorithm>

#include "haptics/recordings/force_calibration.h"

namespace haptics::recordings {

RecordingSurvey surveyOf(const Recording& recording, const Trace& trace) {
  std::vector<double> travels;
  RecordingSurvey survey{.rows = recording.rows.size(), .sampling = samplingOf(recording)};
  for (const Recording::Row& row : recording.rows) {
    if (row.reading >= kSaturatedReading) ++survey.saturatedRows;
    if (row.reading >= kUncalibratedReading) ++survey.uncalibratedRows;
    travels.push_back(row.travel);
  }
  const auto [least, most] = std::ranges::minmax(trace.force);
  survey.minForce = least;
  survey.maxForce = most;

  std::ranges::sort(travels);
  survey.minTravel = travels.front();
  survey.maxTravel = travels.back();
  travels.erase(std::unique(travels.begin(), travels.end()), travels.end());
  survey.distinctTravels = travels.size();

  survey.refusedLines = recording.refusedCount;
  survey.closures = closuresOf(recording, trace);
  return survey;
}

}  // namespace haptics::recordings
