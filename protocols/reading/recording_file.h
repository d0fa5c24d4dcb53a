#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "haptics/recordings/force_calibration.h"
#include "haptics/recordings/recording_table.h"
#include "questionnaires/json/problem.h"

namespace protocols {

/// Reads a calibration file as `palpate recording calibrate` writes it (docs/protocol-format.md,
/// "Calibration files") and reports all problems; std::nullopt if there are errors.
std::optional<haptics::recordings::ForceCalibration> readCalibration(
    std::string_view json, questionnaires::Problems& problems);

/// A calibration as JSON text; numbers can be read back exactly.
///
/// @param source  file name of the table, without folder.
/// @param sha256  hash of the table's bytes in hexadecimal.
std::string calibrationAsJson(
    const haptics::recordings::CalibrationFit& fit,
    const std::string& source,
    std::string_view sha256);

/// The meaning of columns in recordings of another laboratory (docs/protocol-format.md, "Columns
/// files").
struct ColumnsFile {
  haptics::recordings::RecordingColumns columns{};
  std::string calibrationFile{};  ///< file in the folder of the columns file; empty if none is
                                  ///< named
};

/// Reads a columns file and reports all problems; std::nullopt if there are errors. The caller must
/// read the calibration file.
std::optional<ColumnsFile> readColumns(std::string_view json, questionnaires::Problems& problems);

}  // namespace protocols
