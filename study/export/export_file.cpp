#include <filesystem>

#include <nlohmann/json.hpp>

#include "base/text_table.h"
#include "study/export/codebook.h"
#include "study/export/condition_codes.h"
#include "study/export/export.h"
#include "study/export/export_parts.h"
#include "study/export/public_history.h"
#include "study/export/public_tables.h"
#include "study/model/new_file.h"
#include "study/session/backup.h"
#include "study/session/unblinding.h"

namespace study {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

Json asJson(const Cell& cell) {
  if (const auto* flag = std::get_if<bool>(&cell)) return *flag;
  if (const auto* whole = std::get_if<std::int64_t>(&cell)) return *whole;
  if (const auto* number = std::get_if<double>(&cell)) return *number;
  if (const auto* text = std::get_if<std::string>(&cell)) return *text;
  return nullptr;
}

Json asJson(const ExportedTable& table) {
  Json rows = Json::array();
  for (const auto& row : table.rows) {
    Json object;
    for (std::size_t i = 0; i < row.size(); ++i) object[table.columns[i].name] = asJson(row[i]);
    rows.push_back(std::move(object));
  }
  return rows;
}

/// Whether the export includes a script that reads the tables.
bool hasReadingScript(const ExportOptions& options) {
  return options.format == ExportFormat::R || options.format == ExportFormat::Python;
}

/// Writes the tables. @return  the number of sessions
std::size_t writeTables(Study& study, const fs::path& folder, const ExportOptions& options) {
  auto tables = tablesFor(study, options);
  FolderContents contents{.sessions = tables.front().rows.size(), .tables = {}};
  if (hasReadingScript(options)) tables.push_back(columnsTable(tables));
  if (options.format == ExportFormat::Json) {
    Json json = Json::parse(exportMetadataAsJson(study, options));
    for (const auto& table : tables) {
      json[table.name] = asJson(table);
      contents.tables.push_back(writtenTable(table.name, table));
    }
    writeNewFile((folder / "study.json").string(), json.dump(1) + "\n");
  } else {
    for (const auto& table : tables) {
      const auto file = table.name + ".csv";
      writeNewFile((folder / file).string(), asCsv(table));
      contents.tables.push_back(writtenTable(file, table));
    }
    contents.scripts = writeScripts(folder, options);
  }
  if (options.hasTraces) writeTraces(study, folder / "traces", options);
  writeNewFile((folder / "codebook.json").string(), codebookAsJson(study, options, tables));
  writeNewFile((folder / "README.md").string(), readmeOf(study, options, contents));
  return contents.sessions;
}

/// Writes all files in the requested format. @return  the number of sessions
std::size_t writeAll(Study& study, const fs::path& folder, const ExportOptions& options) {
  announceProgress(options.progress, kUnknownShare, "writing the tables");
  if (options.format == ExportFormat::PsychDs) return writePsychDs(study, folder, options);
  if (options.format == ExportFormat::Bids) return writeBids(study, folder, options);
  return writeTables(study, folder, options);
}

/// @throws storage::StorageError  if @p options contradict each other or need a reason.
void requireAllowed(const ExportOptions& options, const std::string& reason) {
  if (!options.isBlinded && base::isBlank(reason)) {
    throw storage::StorageError(
        "To say which rendering was felt needs a reason: it goes into the audit trail.");
  }
  if (options.publicClassSize && options.hasTraces) {
    throw storage::StorageError(
        "How somebody's hand moved is theirs alone, so that a public folder has no traces. Leave "
        "--traces or --public out.");
  }
  if (options.publicClassSize && options.format == ExportFormat::Bids) {
    throw storage::StorageError(
        "A BIDS folder has one for each person, with measurements in it, which a public one may "
        "not "
        "have. Choose --format csv, json, psych-ds, r or python.");
  }
  if (options.publicClassSize && *options.publicClassSize < kSmallestPublicClassSize) {
    throw storage::StorageError(
        "A class of a public folder has at least " + std::to_string(kSmallestPublicClassSize) +
        " people. Ask for that many or more.");
  }
  if (options.isBlinded && options.hasTraces) {
    throw storage::StorageError(
        "Traces show what an alternative felt like, so that a blinded export has none. Leave "
        "--traces out, or add --unblind --reason \"…\".");
  }
}

/// Whether the export must fail if it cannot be noted in the audit trail.
bool isNoteRequired(const ExportOptions& options) {
  return !options.isBlinded || options.publicClassSize.has_value();
}

/// Draws the set of codes for the export. All public exports have one set of codes, so that their
/// readers can compare them.
void drawCodes(Study& study, ExportOptions& options) {
  const auto mode = options.runMode.value_or(RunMode::Live);
  if (options.publicClassSize || !drawsCodesForEachExport(study, mode)) {
    if (options.codes.empty()) return;
    throw storage::StorageError(
        "These sessions have the same codes in each export: leave --codes-of out.");
  }
  if (options.codes.empty()) options.codes = drawnCodeSet();
}

/// Notes in the audit trail in which folder a copy of the data is, except for simulated sessions.
/// @return  false if the study cannot be written
bool noteFolder(Study& study, const fs::path& target, const ExportOptions& options) {
  if (options.runMode == RunMode::Simulated) return true;
  const std::string how = options.publicClassSize ? "public"
                          : options.isBlinded     ? "coded"
                                                  : "unblinded";
  storage::Event exported{
      .actor = storage::Actor::Operator,
      .kind = EventKind::Exported,
      .values = {
          {"how", how},
          {"run_mode", std::string(options.runMode ? nameOf(*options.runMode) : "all")},
          {"folder", pathForAuditTrail(target)}}};
  if (!options.codes.empty()) exported.values.emplace_back("codes", options.codes);
  if (!options.participant.empty())
    exported.values.emplace_back("participant", options.participant);
  if (!isNoteRequired(options)) return noteCopy(study, exported);
  study.note(exported);
  return true;
}

/// Notes the export in the audit trail, before anything is written.
/// @return  false if the study cannot be written
bool noteExport(
    Study& study, const fs::path& target, const ExportOptions& options, const std::string& reason) {
  const bool isNoted = noteFolder(study, target, options);
  if (options.publicClassSize) {
    const auto release = publicRelease(study, options);
    study.note(
        {.actor = storage::Actor::Operator,
         .kind = EventKind::PublicExport,
         .values = {
             {"k", base::asArgument(release.k)},
             {"people", base::asArgument(release.after.people)},
             {"smallest", base::asArgument(release.after.smallest)},
             {"run_mode", std::string(nameOf(options.runMode.value_or(RunMode::Live)))}}});
    rememberPublicExport(study, options.runMode.value_or(RunMode::Live), release.k);
  }
  if (!options.isBlinded) study.note(EventKind::UnblindedExport, reason);
  return isNoted;
}

}  // namespace

std::vector<std::string> writeScripts(const fs::path& folder, const ExportOptions& options) {
  std::vector<std::string> written;
  const bool hasStatistics =
      !options.isBlinded && !options.publicClassSize && options.participant.empty();
  for (const auto& file : exportScripts()) {
    const bool isReader = file.name.starts_with("read_");
    const bool isForR = file.name.ends_with(".R");
    const bool isForOther = options.format == (isForR ? ExportFormat::Python : ExportFormat::R);
    if (isForOther || !(isReader ? hasReadingScript(options) : hasStatistics)) continue;
    writeNewFile((folder / file.name).string(), std::string(file.content));
    written.emplace_back(file.name);
  }
  return written;
}

Study openForExport(const fs::path& folder, const ExportOptions& options) {
  using Access = storage::Database::Access;
  if (isNoteRequired(options)) return Study::open(folder, Access::ReadWrite);
  if (options.runMode == RunMode::Simulated) return Study::open(folder, Access::ReadOnly);
  try {
    return Study::open(folder, Access::ReadWrite);
  } catch (const storage::StorageError&) {
    return Study::open(folder, Access::ReadOnly);
  }
}

WrittenExport exportStudy(
    Study& study,
    const std::string& folder,
    const ExportOptions& requestedOptions,
    const std::string& reason) {
  ExportOptions options = requestedOptions;
  if (options.publicClassSize && !options.runMode) options.runMode = RunMode::Live;
  fs::path target = fs::path(folder).lexically_normal();
  if (!target.has_filename()) target = target.parent_path();  // "out/" becomes "out"
  std::error_code error;
  if (fs::exists(target, error)) {
    throw storage::StorageError(
        folder + " is there already. Nothing is ever overwritten: choose another folder.");
  }
  requireAllowed(options, reason);
  drawCodes(study, options);
  if (options.publicClassSize) requireSafeFromDifferencing(study, options);
  announceProgress(options.progress, kUnknownShare, "gathering the tables");
  const bool isNoted = noteExport(study, target, options, reason);
  const fs::path unfinished = makeFolderBeside(target);
  try {
    const auto sessions = writeAll(study, unfinished, options);
    announceProgress(options.progress, 1.0, "giving the folder its name");
    moveIntoPlace(unfinished, target);
    return {.sessions = sessions, .isNoted = isNoted};
  } catch (...) {
    fs::remove_all(unfinished, error);
    throw;
  }
}

}  // namespace study
