#include "study/session/import_recording.h"

#include <filesystem>

#include "base/file.h"
#include "haptics/recordings/cut.h"
#include "protocols/reading/cut_file.h"
#include "protocols/reading/recording_file.h"
#include "questionnaires/json/document.h"
#include "study/model/user_error.h"
#include "study/storage/protocol_repository.h"

namespace study {

using haptics::recordings::RecordingColumns;
RecordingColumns columnsIn(const std::string& file) {
  questionnaires::Problems problems;
  const auto read = protocols::readColumns(questionnaires::readTextFile(file), problems);
  if (!read) throw UserError(file + ":\n" + questionnaires::describe(problems.all()));
  auto columns = read->columns;
  if (!read->calibrationFile.empty()) {
    const auto beside = std::filesystem::path(file).parent_path() / read->calibrationFile;
    columns.calibration = readCalibrationFile(beside.string());
  }
  return columns;
}

haptics::recordings::ForceCalibration readCalibrationFile(const std::string& file) {
  questionnaires::Problems problems;
  const auto calibration = protocols::readCalibration(questionnaires::readTextFile(file), problems);
  if (!calibration) throw UserError(file + ":\n" + questionnaires::describe(problems.all()));
  return *calibration;
}

haptics::recordings::Recording readRecordingWithColumns(
    const std::string& file, const std::string& columns) {
  return readRecordingWithColumns(
      file, columns.empty() ? std::optional<RecordingColumns>() : columnsIn(columns));
}

haptics::recordings::Recording readRecordingWithColumns(
    const std::string& file, const std::optional<RecordingColumns>& columns) {
  return columns ? haptics::recordings::readRecordingTableFile(file, *columns)
                 : haptics::recordings::readRecordingFile(file);
}

haptics::recordings::ImportedCut importRecording(
    const haptics::recordings::Recording& recording, haptics::recordings::ImportOptions options) {
  if (options.name.empty()) options.name = std::filesystem::path(recording.source).stem().string();
  for (char& c : options.name) {
    const bool isPlain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
    if (!isPlain && c != '.' && c != '_') c = '-';
  }
  return haptics::recordings::importCut(recording, options);
}

haptics::recordings::ImportedCut importPublishedCut(
    const haptics::recordings::Recording& recording) {
  constexpr double kUnlimitedSlope = 1e6;  // limit of the slope, steeper than any recording
                                           // [N/travel unit]
  const auto rows = haptics::recordings::publishedCutIn(recording);
  if (!rows) return importRecording(recording, {});
  return importRecording(
      recording,
      {.rows = rows,
       .filter = {.kind = haptics::recordings::TravelFilter::Kind::AuthorsFir333},
       .maxSlope = kUnlimitedSlope});
}

std::string withRecordedCut(std::string protocol, const std::string& file) {
  const auto replace = [&](const std::string& part, const std::string& other) {
    for (auto at = protocol.find(part); at != std::string::npos;
         at = protocol.find(part, at + other.size())) {
      protocol.replace(at, part.size(), other);
    }
  };
  replace("\"cut\": \"parametric\"", "\"cut\": \"" + file + "\"");
  replace("(synthetic cut)", "(recorded cut)");
  return protocol;
}

std::string cutAsJsonWithSource(const std::string& recording, const haptics::recordings::Cut& cut) {
  const auto bytes = base::readFile(recording).value_or("");
  return protocols::cutAsJson(cut, storage::sha256(bytes));
}

}  // namespace study
