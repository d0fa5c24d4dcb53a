#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "haptics/recordings/calibration_fit.h"
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

}  // namespace protocols
