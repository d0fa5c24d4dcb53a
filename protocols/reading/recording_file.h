#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "haptics/recordings/force_calibration.h"
#include "haptics/recordings/recording_table.h"
#include "questionnaires/json/problem.h"

namespace protocols {

/// A calibration file as `palpate recording calibrate` writes it (docs/protocol-format.md,
/// "Calibration files"), and everything that is wrong with it; nothing where there are errors.
std::optional<haptics::recordings::ForceCalibration> readCalibration(
    std::string_view json, questionnaires::Problems& problems);

/// The same as JSON text, every number so that it reads back exactly.
///
/// @param source  name of the table without its folder. @param sha256  of its bytes.
std::string calibrationAsJson(
    const haptics::recordings::CalibrationFit& fit,
    const std::string& source,
    std::string_view sha256);

/// What the columns of another laboratory's recordings mean (docs/protocol-format.md, "Columns
/// files").
struct ColumnsFile {
  haptics::recordings::RecordingColumns columns{};
  std::string calibrationFile{};  ///< beside the columns file; empty where none is named
};

/// A columns file, and everything that is wrong with it; nothing where there are errors. Its
/// calibration is read by the caller, who can open files.
std::optional<ColumnsFile> readColumns(std::string_view json, questionnaires::Problems& problems);

}  // namespace protocols
