#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "study/export/column.h"
#include "study/export/export.h"

namespace study {

/// A JSON object with the study, the version of the protocol, the program, and whether the export
/// is blinded.
std::string exportMetadataAsJson(Study& study, const ExportOptions& options);

/// A line of the README: whether the folder is blinded.
std::string codesInWords(Study& study, const ExportOptions& options);

/// How the tables of a format are written, as lines of its README.
std::string formatInWords(const ExportOptions& options);

/// A table that was written, as a README lists it.
struct WrittenTable {
  std::string file;  ///< its path in the folder; "…": the files of several sessions
  std::string description;
  std::vector<std::string> keys;  ///< the columns that identify its rows, among all tables
};
WrittenTable writtenTable(const std::string& file, const ExportedTable& table);

/// The contents of a folder, gathered while it is written. Its README says nothing else of them.
struct FolderContents {
  std::size_t sessions = 0;
  std::vector<WrittenTable> tables;
  std::vector<std::string> scripts = {};  ///< by their paths in the folder
};

std::string readmeOf(Study& study, const ExportOptions& options, const FolderContents& contents);

/// The readers of a folder made with @p options.
Readers readersOf(Study& study, const ExportOptions& options);

/// All tables for @p options. The first has a row per session or person.
std::vector<ExportedTable> tablesFor(Study& study, const ExportOptions& options);

/// Writes the study in the Psych-DS layout (psych-ds.github.io): tables with data dictionaries in
/// data/, the questionnaires in materials/. An unblinded folder includes the protocol, which
/// explains the codes.
/// @return  the number of sessions.
std::size_t writePsychDs(
    Study& study, const std::filesystem::path& folder, const ExportOptions& options);

/// Writes the study in the BIDS layout: sub-<label>/ses-<label>/beh/, tab-separated tables with a
/// dictionary each.
/// @return  the number of sessions.
std::size_t writeBids(
    Study& study, const std::filesystem::path& folder, const ExportOptions& options);

/// The letters and digits of @p text, as a label in file names.
std::string bidsLabel(const std::string& text);

/// Writes the scripts for @p options: for R or Python one that reads the tables with their types;
/// unblinded also one that computes the statistics table again from the responses.
/// @return  their names.
std::vector<std::string> writeScripts(
    const std::filesystem::path& folder, const ExportOptions& options);

/// The 1 kHz traces of all trials that @p options choose, one gzip-compressed CSV each, as
/// `P001_session-1_step-07_attempt-1_force.csv.gz` in @p folder. The same study always gives the
/// same bytes. @return  the number of files.
/// @throws storage::StorageError  if one cannot be read or written.
std::size_t writeTraces(
    Study& study, const std::filesystem::path& folder, const ExportOptions& options);

}  // namespace study
