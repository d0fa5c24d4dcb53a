#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "base/message.h"
#include "study/export/column.h"
#include "study/model/progress.h"
#include "study/model/run_mode.h"
#include "study/session/study.h"

namespace study {

enum class ExportFormat {
  Csv,      ///< one file for each table
  Json,     ///< one document
  PsychDs,  ///< tables with data dictionaries, as psych-ds.github.io lays them out
  Bids,     ///< a folder a person, as bids-specification.readthedocs.io lays them out
  R,        ///< one file for each table, and an R script that reads them with their types
  Python,   ///< … a Python script
};

struct ExportOptions {
  ExportFormat format = ExportFormat::Csv;
  std::optional<RunMode> runMode;  ///< std::nullopt: all modes, with a column that tells them apart
  bool isBlinded = true;           ///< condition codes in place of conditions, and no measurements
  bool hasTraces = false;          ///< also the samples of all trials
  /// Dates and times of day, and numbers about a person (age, years of practice) as given;
  /// otherwise the day of the study, and bands of five years or more.
  bool isExact = false;
  bool hasTexts = false;  ///< also what participants and operators wrote
  /// The set of codes of conditions (study/export/condition_codes.h); empty: exportStudy() draws a
  /// new one, except for public exports, which all have the same codes.
  std::string codes = {};
  /// For public data: k, the smallest allowed number of people with equal quasi-identifiers
  /// (study/export/public_tables.h); everything else that could identify a person is left out.
  /// std::nullopt: not a public export.
  std::optional<std::size_t> publicClass = std::nullopt;
  /// Called while writing; if it throws, the export stops and leaves no folder.
  Progress progress = {};
};

/// The smallest allowed k of a public export, and its default.
inline constexpr std::size_t kSmallestPublicClass = 5;

/// All data for analyses, as tables: sessions, responses, texts, trials, cuts, events. A blinded
/// export has sessions, responses and texts only, without anything that depends on the rendering;
/// codes of conditions are the same in all rows of a run mode, and differ from those of other
/// exports.
std::vector<ExportedTable> exportTables(Study& study, const ExportOptions& options);

/// Writes the tables, a codebook and a README into a new folder, which appears when it is complete.
/// If anything fails, there is no folder. Notes the export in the audit trail and signs that.
/// Blinded exports of simulated sessions, or of a study that cannot be written, are not noted. An
/// unblinded export needs a @p reason, which is noted, too.
/// @return  the number of exported sessions.
/// @throws storage::StorageError  if the folder exists already or cannot be written, or if too few
///     people took part for a public export.
std::size_t exportStudy(
    Study& study,
    const std::string& folder,
    const ExportOptions& options,
    const std::string& reason = {});

/// Opens a study for an export: for writing, so that the export can be noted in the audit trail. A
/// study that cannot be written (an archive, a full disk, an analyst's rights) is opened for
/// reading if the export is blinded and not public; so is any study for such an export of simulated
/// sessions.
/// @throws storage::StorageError
Study openForExport(const std::filesystem::path& folder, const ExportOptions& options);

/// Everything that reveals the condition of an answer despite its code, in any version of the
/// study's protocol (protocols/validation/validation.h). If not empty, an export with codes is not
/// called blinded.
std::vector<base::Message> disclosuresOf(Study& study);

/// "blinded", "NOT blinded", or why an export with codes is not blinded.
std::string blindingInWords(Study& study, const ExportOptions& options);

}  // namespace study
