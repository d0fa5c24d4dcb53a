#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "base/message.h"
#include "study/export/column.h"
#include "study/model/progress.h"
#include "study/model/run_mode.h"
#include "study/session/study.h"

namespace study {

/// The file format of an export.
enum class ExportFormat {
  Csv,      ///< one CSV file for each table
  Json,     ///< one JSON document
  PsychDs,  ///< tables with data dictionaries in the Psych-DS layout (psych-ds.github.io)
  Bids,     ///< one folder for each person in the BIDS layout (bids-specification.readthedocs.io)
  R,        ///< one CSV file for each table, and an R script that reads them with their types
  Python,   ///< one CSV file for each table, and a Python script that reads them
};

/// What is exported, in which format, and for which readers.
struct ExportOptions {
  ExportFormat format = ExportFormat::Csv;
  std::optional<RunMode> runMode;  ///< std::nullopt: all modes, with the column run_mode
  bool isBlinded = true;           ///< condition codes in place of conditions, and no measurements
  bool hasTraces = false;          ///< whether to include the samples of all trials
  /// Whether to include exact dates, times of day, and numbers about a person (age, years of
  /// practice). Otherwise the days since the first session, and bands that are at least five steps
  /// wide.
  bool isExact = false;
  bool hasTexts = false;  ///< whether to include texts of participants and operators
  /// Name of the set of condition codes (study/export/condition_codes.h); empty: exportStudy()
  /// draws a new one, except for public exports, which all use one set.
  std::string codes = {};
  std::string participant = {};  ///< code of the only participant to export; empty: all
  /// For a public export: k, the smallest allowed number of people with equal quasi-identifiers
  /// (study/export/public_tables.h). Everything else that could identify a person is left out.
  /// std::nullopt: not a public export.
  std::optional<std::size_t> publicClassSize = std::nullopt;
  /// Called while writing. If it throws, the export stops and leaves no folder.
  Progress progress = {};
};

/// The smallest allowed k of a public export, and its default.
inline constexpr std::size_t kSmallestPublicClassSize = 5;

/// Whether the export has the sessions of that participant and run mode.
bool isExported(const ExportOptions& options, const storage::SessionRow& session);

/// All data for analyses, as tables: sessions, responses, texts, trials, cuts, events. A blinded
/// export has sessions, responses and texts only, without values that depend on the rendering.
/// Codes of conditions are the same in all rows of a run mode, but differ between exports.
std::vector<ExportedTable> exportTables(Study& study, const ExportOptions& options);

struct WrittenExport {
  std::size_t sessions = 0;
  bool isNoted = true;  ///< false if the study cannot be written (kCopyNotNoted)
};

/// Writes the tables, a codebook and a README to a new folder, which appears when it is complete;
/// if anything fails, there is no folder. Notes the export in the audit trail and signs the trail.
/// Blinded exports of simulated sessions are not noted. An unblinded export requires a @p reason,
/// which is noted, too.
/// @throws storage::StorageError  if the folder exists already or cannot be written, or if the
///     study has too few people for a public export.
WrittenExport exportStudy(
    Study& study,
    const std::string& folder,
    const ExportOptions& options,
    const std::string& reason = {});

/// Opens a study for an export. It is opened for writing, so that the export can be noted in the
/// audit trail. A blinded export that is not public needs no note in the audit trail: if the study
/// cannot be written (an archive, a full disk, an analyst's rights), or if only simulated sessions
/// are exported, it is opened for reading.
/// @throws storage::StorageError
Study openForExport(const std::filesystem::path& folder, const ExportOptions& options);

/// Everything that reveals the condition of an answer in spite of the codes, in any version of the
/// study's protocol (protocols/validation/validation.h). If not empty, an export with codes is not
/// called blinded.
std::vector<base::Message> disclosuresOf(Study& study);

/// "blinded", "NOT blinded", or the reason why an export with codes is not blinded.
std::string blindingInWords(Study& study, const ExportOptions& options);

}  // namespace study
