#pragma once

#include <optional>
#include <string>

#include "haptics/recordings/cut_import.h"
#include "haptics/recordings/force_calibration.h"
#include "haptics/recordings/recording.h"
#include "study/report/document.h"

namespace study::app {

/// A recording as figures and tables: the amplitude spectrum of the travel before and after
/// filtering (section II-B of the punch paper), the force over travel of every closure with its
/// landmarks (Fig. 4), the closures, and the imported cut if there is one.
///
/// @param trace, survey  of @p recording.
/// @param filterParameters  recordings::parametersOf() of the travel filter.
report::Document recordingReport(
    const haptics::recordings::Recording& recording,
    const haptics::recordings::Trace& trace,
    const haptics::recordings::RecordingSurvey& survey,
    const std::string& filterParameters,
    const std::optional<haptics::recordings::ImportedCut>& imported);

/// The share of a signal's variance at or below @p frequency [Hz], from its amplitude spectrum; 0
/// to 1.
/// @param rate  sampling rate [Hz].
double shareBelow(const std::vector<double>& samples, double rate, double frequency);

/// A calibration as figures and tables: loads and fitted curve, residuals, points, and polynomials
/// of other orders for comparison.
report::Document calibrationReport(
    const haptics::recordings::CalibrationTable& table,
    const haptics::recordings::CalibrationFit& fit,
    const DataTable& orders);

}  // namespace study::app
