#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "haptics/recordings/recording_table.h"
#include "questionnaires/json/problem.h"

namespace protocols {

/// What the columns of another laboratory's recordings mean (docs/protocol-format.md, "Columns
/// files").
struct ColumnsFile {
  haptics::recordings::RecordingColumns columns{};
  std::string calibrationFile{};  ///< beside the columns file; empty where none is named
};

/// A columns file, and everything that is wrong with it; nothing where there are errors. Its
/// calibration is left to whoever can open files.
std::optional<ColumnsFile> readColumns(std::string_view json, questionnaires::Problems& problems);

}  // namespace protocols
