#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "base/embedded_file.h"
#include "study/export/column.h"
#include "study/export/export.h"

namespace study {

/// A JSON object on the study, the version of the protocol, the program, and whether the export is
/// blinded.
std::string exportMetadataAsJson(Study& study, const ExportOptions& options);

/// A line of the README on whether the folder is blinded.
std::string readmeLineOnBlinding(Study& study, const ExportOptions& options);

/// How the tables of a format are written, as lines of its README.
std::string formatInWords(const ExportOptions& options);

/// A written table, as the README lists it.
struct WrittenTable {
  std::string file;  ///< path in the folder; "…" stands for participant and session
  std::string description;
  std::vector<std::string> keys;  ///< the columns that identify a row among all tables
};
WrittenTable writtenTable(const std::string& file, const ExportedTable& table);

/// The contents of an export folder, collected while it is written, for its README.
struct FolderContents {
  std::size_t sessions = 0;
  std::vector<WrittenTable> tables;
  std::vector<std::string> scripts = {};  ///< paths in the folder
};

std::string readmeOf(Study& study, const ExportOptions& options, const FolderContents& contents);

/// The readers of an export with @p options.
Readers readersOf(Study& study, const ExportOptions& options);

/// All tables for @p options. The first table has a row for each session or person.
std::vector<ExportedTable> tablesFor(Study& study, const ExportOptions& options);

/// Writes the study in the Psych-DS layout (psych-ds.github.io): tables with data dictionaries in
/// data/, questionnaires in materials/. An unblinded folder includes the protocol, which explains
/// the codes.
/// @return  the number of sessions.
std::size_t writePsychDs(
    Study& study, const std::filesystem::path& folder, const ExportOptions& options);

/// Writes the study in the BIDS layout: tab-separated tables, each with a dictionary, in
/// sub-<label>/ses-<label>/beh/.
/// @return  the number of sessions.
std::size_t writeBids(
    Study& study, const std::filesystem::path& folder, const ExportOptions& options);

/// The letters and digits of @p text, for a label in file names.
std::string bidsLabel(const std::string& text);

/// Writes the scripts for @p options: for R or Python a script that reads the tables with their
/// types; for unblinded exports also a script that computes the statistics table from the
/// responses.
/// @return  the names of the scripts.
std::vector<std::string> writeScripts(
    const std::filesystem::path& folder, const ExportOptions& options);

/// Writes the traces of all trials that @p options select to @p folder, with a row for each tick,
/// each as a gzip-compressed CSV file `P001_session-1_step-07_attempt-1_force.csv.gz`. The same
/// study always gives the same bytes.
/// @return  the number of files.
/// @throws storage::StorageError  if a trace cannot be read or a file cannot be written.
std::size_t writeTraces(
    Study& study, const std::filesystem::path& folder, const ExportOptions& options);

/// The R and Python scripts of study/library, which are exported unchanged.
std::span<const base::EmbeddedFile> exportScripts();

}  // namespace study
